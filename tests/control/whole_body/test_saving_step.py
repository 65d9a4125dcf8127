"""Steps that save the balance, told as scenes."""

import numpy as np
import pytest

from game.control.whole_body.bow import NO_BOW, Farthest
from game.control.whole_body.footing import STUCK_S
from game.control.whole_body.saving_step import (
    CROSS_AHEAD_M,
    CROSS_S,
    LEAST_SIDE_M,
    MOST_CROSS_M,
    OVERSTEP,
    REACH_M,
    ROUND_M,
    STEP_S,
    UNCROSS_S,
    WIDE_M,
    landing_goal,
    saving_step,
)
from tests.control.whole_body.footing_scene import CENTRED, DT, HALF_LENGTH, HALF_WIDTH, LEFT, OMEGA, RIGHT, STAND, STANDS, STEPS, Scene

REAL_HALF_WIDTH = 0.075


@pytest.fixture
def scene():
    return Scene()


def test_a_push_sideways_makes_the_foot_on_that_side_step_out(scene):
    scene.xi = np.array([0.0, 0.2])
    assert scene.go() == (STEPS, STANDS)
    foot = scene.footing.feet[LEFT]
    assert foot.duration_s == STEP_S
    assert foot.goal[1] > STAND[LEFT, 1] + 0.1 and foot.goal[2] == 0.0


def test_pushed_hard_sideways_the_foot_that_carries_nothing_crosses_over_round_the_other_leg(scene):
    scene.xi, scene.load = np.array([0.0, 0.22]), (1.0, 0.0)
    scene.push = np.array([0.0, 5.0])
    assert scene.go() == (STANDS, STEPS)
    foot = scene.footing.feet[RIGHT]
    assert foot.goal[1] > STAND[LEFT, 1] + 0.1 and abs(foot.goal[0]) >= CROSS_AHEAD_M - 1e-9
    assert foot.duration_s == CROSS_S
    np.testing.assert_allclose(foot.bow.out, [np.copysign(ROUND_M, foot.goal[0]), -WIDE_M, 0.0])
    assert foot.bow.farthest is Farthest.EARLY, "past the toes or the heel of the other foot, then aside"


def gap_m(foot, other):
    """Least distance, along one axis, between two soles of real feet while `foot` takes its step; negative where they overlap."""
    gaps = []
    for time_s in np.linspace(0.0, foot.duration_s, 100):
        foot.time_s = time_s
        apart = np.abs(foot.step_motion(0.0)[0][:2] - other) - (2.0 * HALF_LENGTH, 2.0 * REAL_HALF_WIDTH)
        gaps.append(apart.max())
    return min(gaps)


@pytest.mark.parametrize("xi", [0.19, 0.22, 0.25])
@pytest.mark.parametrize("side", [LEFT, RIGHT])
def test_a_foot_on_its_way_across_does_not_run_into_the_other_one(scene, side, xi):
    aside = 1.0 if side == RIGHT else -1.0
    scene.xi, scene.load = np.array([0.0, aside * xi]), tuple(float(k != side) for k in (LEFT, RIGHT))
    scene.push = np.array([0.0, 5.0 * aside])
    scene.go()
    foot = scene.footing.feet[side]
    assert foot.saving is not None and foot.saving.across
    assert gap_m(foot, STAND[1 - side]) > 0.005
    foot.bow = NO_BOW
    assert gap_m(foot, STAND[1 - side]) < -0.05, "the straight way leads through it"


def test_a_foot_that_is_crossed_comes_back_round_the_other_leg(scene):
    """Calm again, the feet are put side by side: the one that was left behind goes round where the other one is not."""
    scene.place[RIGHT] = -0.2, 0.45
    scene.xi, scene.thrown = scene.place[RIGHT].copy(), True
    for _ in range(60):
        scene.go()
        if scene.footing.feet[LEFT].phase is STEPS:
            break
    foot = scene.footing.feet[LEFT]
    assert foot.phase is STEPS and foot.duration_s == UNCROSS_S
    np.testing.assert_allclose(foot.bow.out, [ROUND_M, WIDE_M, 0.0], err_msg="the right foot is behind: it goes before it, and wide")
    assert foot.bow.farthest is Farthest.LATE, "first past its toes, then back"
    assert foot.goal[1] >= scene.place[RIGHT, 1] + LEAST_SIDE_M - 1e-9


def test_beside_a_foot_that_is_turned_a_step_comes_down_farther_off(scene):
    scene.xi = np.array([0.0, -0.02])
    step = saving_step(RIGHT, 0, scene.soles(), scene.wish())
    straight = landing_goal(step, scene.soles(), scene.sway(), scene.wish(), 0.1)
    scene.wished[:, 1] *= 0.5
    scene.yaw[LEFT] = 0.5 * np.pi
    turned = landing_goal(step, scene.soles(), scene.sway(), scene.wish(), 0.1)
    wide = HALF_LENGTH - HALF_WIDTH
    assert turned[1] == pytest.approx(STAND[LEFT, 1] - LEAST_SIDE_M - wide) and turned[1] < straight[1]


def test_a_push_that_is_felt_calls_for_a_step_before_the_capture_point_is_out(scene):
    scene.xi = np.array([0.1, 0.0])
    assert scene.go() == (STANDS, STANDS)
    scene.push = np.array([5.0, 0.0])
    assert STEPS in scene.go()


def test_a_foot_that_cannot_lift_leaves_the_step_to_the_one_that_hangs(scene):
    scene.xi = np.array([0.0, 0.2])
    assert scene.go() == (STEPS, STANDS)
    scene.lift_off(RIGHT, 0.01)
    assert scene.go(STUCK_S + 2.0 * DT) == (STANDS, STEPS)


def test_a_foot_that_grazes_the_floor_far_from_its_goal_has_not_landed(scene):
    scene.xi = np.array([0.0, 0.2])
    scene.go()
    scene.lift_off(LEFT)
    scene.go(0.7 * STEP_S)
    scene.put_down(LEFT)
    assert scene.go() == (STEPS, STANDS)
    scene.place[LEFT] = scene.footing.feet[LEFT].goal[:2]
    assert scene.go() == (STANDS, STANDS)


def test_who_is_on_a_step_that_saves_the_balance_has_that_foot_too_to_fall_back_on(scene):
    scene.xi = np.array([0.0, 0.2])
    scene.go()
    scene.lift_off(LEFT)
    scene.place[LEFT] = 0.0, 0.5
    assert scene.footing.reach_hull(scene.soles())[:, 1].max() > 0.5 > scene.footing.hull(scene.soles(), 0.0)[:, 1].max()


def test_a_push_forward_is_caught_by_the_foot_that_trails(scene):
    scene.place[RIGHT, 0] = scene.wished[RIGHT, 0] = -0.12
    scene.xi = np.array([0.25, 0.0])
    assert scene.go() == (STANDS, STEPS)
    assert scene.footing.feet[RIGHT].goal[0] > 0.25


def test_a_fall_past_the_loaded_foot_of_a_wide_stance_is_caught_by_the_other(scene):
    """The loaded foot could only step from the far one, and never reach as far as the body falls meanwhile."""
    scene.place[:, 1] = scene.wished[:, 1] = 0.35, -0.35
    scene.xi = np.array([0.0, -0.42])
    assert scene.go() == (STEPS, STANDS)
    assert scene.footing.feet[LEFT].goal[1] <= -0.35 + LEAST_SIDE_M + 1e-9


def test_a_step_is_placed_where_the_capture_point_will_be(scene):
    """By touch-down the foot, with its margins, has the predicted capture point under it."""
    scene.xi = np.array([0.2, 0.02])
    scene.go()
    side = next(side for side in range(2) if scene.footing.feet[side].phase is STEPS)
    pivot = np.array([HALF_LENGTH - 0.01, 0.0])
    landing = pivot[0] + OVERSTEP[0] * (scene.xi[0] - pivot[0]) * np.exp(OMEGA * STEP_S)
    assert abs(scene.footing.feet[side].goal[0] - landing) < HALF_LENGTH


def test_a_step_keeps_clear_of_the_other_foot_and_does_not_overreach(scene):
    crossed = 0
    for apart in (0.1, 0.3):
        for angle in np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False):
            scene.__init__()
            scene.place[:, 1] = scene.wished[:, 1] = apart, -apart
            scene.xi = (apart + 0.35) * np.array([np.cos(angle), np.sin(angle)])
            scene.go()
            steps = [side for side in range(2) if scene.footing.feet[side].phase is STEPS]
            assert len(steps) == 1
            ahead, left = scene.footing.feet[steps[0]].goal[:2] - scene.place[1 - steps[0]]
            aside = left if steps[0] == LEFT else -left
            assert aside >= LEAST_SIDE_M - 1e-9 or (abs(ahead) >= CROSS_AHEAD_M - 1e-9 and aside >= -MOST_CROSS_M - 1e-9)
            assert np.hypot(ahead, left) <= REACH_M + 1e-9
            crossed += aside < LEAST_SIDE_M - 1e-9
    assert crossed > 0, "where the loaded foot is on the side of the fall, the other one crosses over"


def test_a_capture_point_a_little_outside_is_given_a_moment(scene):
    scene.xi = np.array([0.15 + 0.005, 0.0])
    assert scene.go(0.1) == (STANDS, STANDS)
    assert STEPS in scene.go(0.05)


def test_a_shove_that_passes_leaves_both_feet_where_they_are(scene):
    for _ in range(5):
        scene.xi = np.array([0.155, 0.0])
        assert scene.go(0.09) == (STANDS, STANDS)
        scene.xi = CENTRED.copy()
        assert scene.go(0.05) == (STANDS, STANDS)


def test_a_recovery_step_under_way_follows_the_capture_point(scene):
    scene.xi = np.array([0.3, 0.0])
    scene.go()
    side = next(side for side in range(2) if scene.footing.feet[side].phase is STEPS)
    scene.lift_off(side)
    before = scene.footing.feet[side].goal.copy()
    scene.xi = np.array([0.4, 0.0])
    scene.go(0.05)
    assert scene.footing.feet[side].goal[0] > before[0] + 0.05


def test_a_step_lands_when_it_touches_after_its_first_part(scene):
    scene.xi = np.array([0.0, 0.2])
    scene.go()
    assert scene.go(0.3 * STEP_S) == (STEPS, STANDS), "the sole still drags"
    scene.lift_off(LEFT)
    scene.go(0.4 * STEP_S)
    scene.place[LEFT] = scene.footing.feet[LEFT].goal[:2]
    scene.put_down(LEFT)
    assert scene.go() == (STANDS, STANDS)
