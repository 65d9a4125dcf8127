"""Steps that save the balance, told as scenes."""

import numpy as np
import pytest

from game.control.whole_body.saving_step import CROSS_AHEAD_M, CROSS_SIDE_M, LEAST_SIDE_M, OVERSTEP, REACH_M, STEP_S
from tests.control.whole_body.footing_scene import CENTRED, HALF_LENGTH, LEFT, OMEGA, RIGHT, STAND, STANDS, STEPS, Scene


@pytest.fixture
def scene():
    return Scene()


def test_a_push_sideways_makes_the_foot_on_that_side_step_out(scene):
    scene.xi = np.array([0.0, 0.2])
    assert scene.go() == (STEPS, STANDS)
    foot = scene.footing.feet[LEFT]
    assert foot.duration_s == STEP_S
    assert foot.goal[1] > STAND[LEFT, 1] + 0.1 and foot.goal[2] == 0.0


def test_a_hard_push_sideways_makes_the_other_foot_cross_over(scene):
    scene.xi = np.array([0.0, 0.45])
    assert scene.go() == (STANDS, STEPS)
    goal = scene.footing.feet[RIGHT].goal
    assert goal[1] > STAND[LEFT, 1] + 0.1 and abs(goal[0]) >= CROSS_AHEAD_M - 1e-9


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
    landing = pivot[0] + OVERSTEP * (scene.xi[0] - pivot[0]) * np.exp(OMEGA * STEP_S)
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
            assert aside >= LEAST_SIDE_M - 1e-9 or (abs(ahead) >= CROSS_AHEAD_M - 1e-9 and aside >= -CROSS_SIDE_M - 1e-9)
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
