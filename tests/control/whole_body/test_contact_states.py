"""What a foot is doing, and the way it takes on a step of its own."""

import numpy as np
import pytest

from game.control.whole_body.bow import NO_BOW, bow
from game.control.whole_body.contact_states import FootState, Phase

START, GOAL, CLEARANCE = np.array([0.1, 0.2, 0.0]), np.array([0.5, 0.1, 0.02]), 0.06


def step(time_s, start_yaw=0.1, goal_yaw=0.5, duration_s=0.26, ahead_m=0.0):
    """place, velocity, acceleration, yaw, its rate at time_s of a step, with a bow so far ahead."""
    foot = FootState()
    foot.step_to(START, GOAL, start_yaw, goal_yaw, duration_s, bow(goal_yaw, ahead_m, 0.0) if ahead_m else NO_BOW)
    foot.time_s = time_s
    return foot.step_motion(CLEARANCE)


def test_a_foot_stands_until_it_is_told_otherwise():
    foot = FootState()
    assert foot.stands
    foot.enter(Phase.SWING)
    assert not foot.stands and foot.time_s == 0.0 and foot.fresh


def test_two_feet_share_no_arrays():
    left, right = FootState(), FootState()
    left.start[0] = left.goal[0] = left.behind[0] = 1.0
    assert not right.start.any() and not right.goal.any() and not right.behind.any()


def test_a_step_begins_where_the_foot_is_and_ends_at_its_goal():
    place, velocity, _, yaw, rate = step(0.0)
    np.testing.assert_allclose(place, START)
    np.testing.assert_allclose(velocity[:2], 0.0)
    assert (yaw, rate) == (0.1, 0.0)
    place, velocity, _, yaw, rate = step(0.26)
    np.testing.assert_allclose(place, GOAL)
    np.testing.assert_allclose(velocity[:2], 0.0)
    assert yaw == pytest.approx(0.5) and rate == pytest.approx(0.0)


@pytest.mark.parametrize("ahead_m", [0.3, -0.2])
def test_round_the_other_leg_a_step_swings_out_ahead_and_comes_down_where_it_was_to(ahead_m):
    ends = [step(t, goal_yaw=0.5, ahead_m=ahead_m) for t in (0.0, 0.26)]
    for (place, velocity, *_), there in zip(ends, (START, GOAL), strict=True):
        np.testing.assert_allclose(place, there, atol=1e-12)
        np.testing.assert_allclose(velocity[:2], 0.0, atol=1e-12)
    out = step(0.13, ahead_m=ahead_m)[0] - step(0.13)[0]
    np.testing.assert_allclose(out, ahead_m * np.array([np.cos(0.5), np.sin(0.5), 0.0]))


def test_half_way_the_foot_is_highest():
    place, velocity, *_ = step(0.13)
    np.testing.assert_allclose(place[:2], 0.5 * (START + GOAL)[:2])
    assert place[2] == pytest.approx(0.5 * (START + GOAL)[2] + CLEARANCE)
    assert velocity[2] == pytest.approx((GOAL - START)[2] * 30.0 / 16.0 / 0.26)


@pytest.mark.parametrize("ahead_m", [0.0, 0.3])
@pytest.mark.parametrize("time_s", [0.01, 0.07, 0.13, 0.2, 0.25])
def test_velocity_and_acceleration_are_the_derivatives_of_the_place(time_s, ahead_m):
    h = 1e-5
    before, here, after = (step(time_s + d, ahead_m=ahead_m) for d in (-h, 0.0, h))
    np.testing.assert_allclose(here[1], (after[0] - before[0]) / (2 * h), atol=1e-7)
    np.testing.assert_allclose(here[2], (after[1] - before[1]) / (2 * h), atol=1e-6)
    assert here[4] == pytest.approx((after[3] - before[3]) / (2 * h), abs=1e-7)


def test_a_late_foot_reaches_down_for_the_floor():
    place, velocity, acceleration, yaw, _ = step(0.31)
    np.testing.assert_allclose(place, GOAL - [0.0, 0.0, 0.4 * 0.05], atol=1e-12)
    np.testing.assert_allclose(velocity, [0.0, 0.0, -0.4])
    assert not acceleration.any()
    assert yaw == pytest.approx(0.5)


def test_a_foot_turns_the_short_way_round():
    assert step(0.26, 3.0, -3.0)[3] == pytest.approx(2 * np.pi - 3.0)
    yaws = [step(t, 3.0, -3.0)[3] for t in np.linspace(0.0, 0.26, 9)]
    assert np.all(np.diff(yaws) >= 0.0) and yaws[-1] - yaws[0] < 0.3


def test_a_step_keeps_its_goal_where_the_caller_moves_his_array():
    foot, goal = FootState(), GOAL.copy()
    foot.step_to(START, goal, 0.0, 0.0, 0.26)
    goal[:] = 9.0
    foot.time_s = 0.26
    np.testing.assert_allclose(foot.step_motion(CLEARANCE)[0], GOAL)
