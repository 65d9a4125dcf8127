"""Mending of the stance, told as scenes of the feet, the capture point and a push."""

import numpy as np
import pytest

from game.control.whole_body.footing import HANGS_M, PASS_M, RETURN_S, TURNS_SHARE
from game.control.whole_body.mending import (
    AMISS_S,
    ASTRAY_M,
    CALM_M,
    FAR_APART_M,
    GIVEN_UP_S,
    LEAN_M,
    PATIENT_S,
    SHAKEN_AMISS_S,
    SHAKEN_ASTRAY_M,
    SHAKEN_ASTRAY_RAD,
    SHAKEN_S,
    SLOW_M,
)
from game.control.whole_body.saving_step import STEP_S
from tests.control.whole_body.footing_scene import DT, HALF_LENGTH, HALF_WIDTH, LEFT, RIGHT, STAND, STANDS, STEPS, SWINGS, Scene

ASIDE = np.array([0.0, 0.3])


@pytest.fixture
def scene():
    return Scene()


@pytest.fixture
def shaken(scene):
    """A body that was thrown and has come to stand wide, the capture point over its left foot."""
    scene.thrown = True
    scene.go()
    scene.thrown = False
    scene.place[LEFT] = STAND[LEFT] + ASIDE
    scene.xi = scene.place[LEFT].copy()
    return scene


def test_after_a_push_the_foot_that_is_left_behind_is_soon_put_beside_the_other(shaken):
    assert shaken.go(SHAKEN_AMISS_S + 3 * DT) == (STANDS, STEPS)
    np.testing.assert_allclose(shaken.footing.feet[RIGHT].goal[:2], STAND[RIGHT] + ASIDE)


@pytest.mark.parametrize(("yaw", "sway_m", "mended"), [(1.2, 0.5, LEFT), (0.8, 0.5, RIGHT), (1.2, 1.1, RIGHT)])
def test_a_slow_body_puts_the_foot_beside_the_other_that_is_turned_too(shaken, yaw, sway_m, mended):
    """One step then puts place and turn right; who is fast has no choice of the foot to stand on."""
    shaken.yaw[LEFT] = yaw * SHAKEN_ASTRAY_RAD
    shaken.sway_m = sway_m * SLOW_M
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    shaken.xi, shaken.sway_m = shaken.place[1 - mended].copy(), 0.0
    shaken.go()
    assert shaken.phases()[mended] is STEPS and shaken.phases()[1 - mended] is STANDS


def test_it_waits_for_a_capture_point_that_still_runs(shaken):
    shaken.sway_m = SLOW_M + 0.01
    assert shaken.go(0.5) == (STANDS, STANDS)
    shaken.sway_m = SLOW_M - 0.01
    assert shaken.go(3 * DT) == (STANDS, STEPS)


def test_long_after_a_push_a_stance_is_mended_late_as_without_one(scene):
    scene.thrown = True
    scene.go()
    scene.thrown = False
    scene.go(SHAKEN_S + DT)
    scene.place[LEFT] = STAND[LEFT] + (2.0 * ASTRAY_M, 0.0)
    scene.xi = STAND[RIGHT].copy()
    assert scene.go(AMISS_S - 5 * DT) == (STANDS, STANDS)
    assert scene.go(10 * DT) == (STEPS, STANDS)


def test_what_the_sensor_may_drift_is_not_mended_unless_a_push_did_it(scene):
    scene.place[LEFT] = STAND[LEFT] + (1.2 * SHAKEN_ASTRAY_M, 0.0)
    scene.xi = STAND[RIGHT].copy()
    assert scene.go(3.0 * AMISS_S) == (STANDS, STANDS)
    scene.thrown = True
    scene.go()
    scene.thrown = False
    assert STEPS in scene.go(SHAKEN_AMISS_S + 3 * DT)


def test_while_the_weight_comes_over_the_other_foot_the_choice_stays(shaken):
    """For a while: a weight that does not come is given up."""
    shaken.xi = shaken.place[LEFT] - (0.0, 0.1)
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    assert shaken.footing.mending.side == RIGHT and shaken.footing.intended == LEFT
    shaken.xi = shaken.place[RIGHT] + (0.0, 0.15)
    shaken.go(0.5 * GIVEN_UP_S)
    assert shaken.footing.mending.side == RIGHT
    shaken.go(0.5 * GIVEN_UP_S)
    assert shaken.footing.mending.side != RIGHT


def test_a_weight_that_does_not_quite_come_over_the_other_foot_is_waited_for_and_then_stepped_in_from(shaken):
    """A leg spread wide cannot push it over."""
    shaken.xi = shaken.place[LEFT] - (0.0, HALF_WIDTH + LEAN_M - 0.005)
    assert shaken.go(SHAKEN_AMISS_S + PATIENT_S - 3 * DT) == (STANDS, STANDS)
    assert shaken.go(6 * DT) == (STANDS, STEPS)


def test_one_that_stays_far_off_is_not_stepped_in_from(shaken):
    shaken.xi = shaken.place[LEFT] - (0.0, HALF_WIDTH + LEAN_M + 0.005)
    assert shaken.go(SHAKEN_AMISS_S + GIVEN_UP_S) == (STANDS, STANDS)


def test_a_foot_on_its_way_to_mend_the_stance_turns_to_save_the_balance(shaken):
    assert shaken.go(SHAKEN_AMISS_S + 3 * DT) == (STANDS, STEPS)
    mending = shaken.footing.feet[RIGHT]
    shaken.lift_off(RIGHT)
    shaken.xi = shaken.place[LEFT] + (0.25, 0.0)
    assert mending.saving is None
    shaken.go()
    assert mending.saving is not None and mending.goal[0] > shaken.xi[0]


def test_a_foot_that_is_about_to_come_down_beside_the_other_does_so_first(shaken):
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    shaken.lift_off(RIGHT)
    shaken.go(TURNS_SHARE * RETURN_S)
    shaken.xi = shaken.place[LEFT] + (0.25, 0.0)
    shaken.go()
    assert shaken.footing.feet[RIGHT].saving is None and shaken.phases() == (STANDS, STEPS)


def test_a_body_that_sways_does_not_mend_what_no_push_did(scene):
    scene.place[LEFT] = STAND[LEFT] + (2.0 * ASTRAY_M, 0.0)
    scene.xi = STAND[RIGHT].copy()
    scene.sway_m = CALM_M + 0.01
    assert scene.go(2.0 * AMISS_S) == (STANDS, STANDS)


def test_a_foot_that_turns_back_swings_out_past_the_other_one(shaken):
    shaken.yaw[RIGHT] = -1.2
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    foot = shaken.footing.feet[RIGHT]
    np.testing.assert_allclose(foot.bow.out, [0.0, -HALF_LENGTH * np.sin(1.2), 0.0], atol=1e-12)
    shaken.yaw[RIGHT] = 0.0


def test_a_foot_that_a_step_pulls_off_the_floor_is_put_beside_the_other_at_once(scene):
    """The balance was saved by the left foot, and the leg of the right one is too short for so wide a stance."""
    scene.xi = np.array([0.0, 0.2])
    assert scene.go() == (STEPS, STANDS)
    scene.lift_off(LEFT)
    scene.go(0.7 * STEP_S)
    scene.place[LEFT] = scene.footing.feet[LEFT].goal[:2]
    scene.put_down(LEFT)
    scene.xi = scene.place[LEFT].copy()
    scene.go()
    scene.lift_off(RIGHT)
    assert scene.go() == (STANDS, STEPS)
    np.testing.assert_allclose(scene.footing.feet[RIGHT].goal[:2], scene.place[LEFT] + STAND[RIGHT] - STAND[LEFT])


def test_a_foot_that_hangs_over_the_floor_after_such_a_step_is_put_there_once_the_other_carries_all(scene):
    """The capture point was at the edge of the left sole when the right one lost the floor: it swings after the player's."""
    scene.xi = np.array([0.0, 0.2])
    scene.go()
    scene.lift_off(LEFT)
    scene.go(0.7 * STEP_S)
    scene.place[LEFT] = scene.footing.feet[LEFT].goal[:2]
    scene.put_down(LEFT)
    scene.xi = scene.place[LEFT] + (0.0, HALF_WIDTH - 0.005)
    scene.go()
    scene.lift_off(RIGHT)
    assert scene.go() == (STANDS, SWINGS)
    scene.height[RIGHT] = HANGS_M + 0.001
    scene.xi = scene.place[LEFT].copy()
    assert scene.go() == (STANDS, STEPS)
    np.testing.assert_allclose(scene.footing.feet[RIGHT].goal[:2], scene.place[LEFT] + STAND[RIGHT] - STAND[LEFT])


def test_a_foot_that_loses_the_floor_while_it_is_to_be_put_right_goes_there(shaken):
    shaken.sway_m = SLOW_M + 0.01
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    assert shaken.footing.mending.side == RIGHT
    shaken.lift_off(RIGHT)
    assert shaken.go() == (STANDS, STEPS)
    np.testing.assert_allclose(shaken.footing.feet[RIGHT].goal[:2], STAND[RIGHT] + ASIDE)


@pytest.mark.parametrize("sway_m", [0.5 * SLOW_M, 3.0 * SLOW_M])
def test_after_a_push_the_weight_goes_over_the_foot_that_stays_however_fast_it_comes(shaken, sway_m):
    shaken.sway_m = sway_m
    shaken.xi = shaken.place[LEFT] - (0.0, 0.1)
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    assert shaken.footing.intended == LEFT


def test_what_no_push_did_is_not_leaned_over_for_by_a_body_that_sways(scene):
    scene.place[LEFT] = STAND[LEFT] + (2.0 * ASTRAY_M, 0.0)
    scene.go(2.0 * AMISS_S)
    assert scene.footing.intended is not None
    scene.sway_m = SLOW_M + 0.01
    scene.go()
    assert scene.footing.intended is None


def test_a_player_who_marches_on_is_followed_once_the_feet_are_together(shaken):
    """The push has left the left foot far aside, the player lifts his left one: the right one comes first."""
    shaken.up = (True, False)
    assert shaken.go(SHAKEN_AMISS_S + 3 * DT) == (STANDS, STEPS)
    shaken.lift_off(RIGHT)
    shaken.go(0.9 * RETURN_S)
    shaken.place[RIGHT] = shaken.footing.feet[RIGHT].goal[:2]
    shaken.put_down(RIGHT)
    shaken.xi = shaken.place[RIGHT].copy()
    assert shaken.go(2 * DT) == (SWINGS, STANDS)


def test_feet_no_farther_apart_than_that_do_as_the_player_does(shaken):
    shaken.place[LEFT] = STAND[LEFT] + (0.0, 0.9 * FAR_APART_M)
    shaken.xi = shaken.place[RIGHT].copy()
    shaken.up = (True, False)
    assert shaken.go(SHAKEN_AMISS_S + 3 * DT) == (SWINGS, STANDS)


def test_a_foot_that_is_put_right_keeps_clear_of_the_other_one_on_its_way(shaken):
    """It stands before the other one's toes, too close to pass."""
    close_m = 1.5 * HALF_WIDTH
    shaken.place[RIGHT] = shaken.place[LEFT] + (0.3, -close_m)
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    foot = shaken.footing.feet[RIGHT]
    assert foot.mends
    np.testing.assert_allclose(foot.bow.out, [0.0, -(2.0 * HALF_WIDTH + PASS_M - close_m), 0.0], atol=1e-12)


def test_a_player_who_lifts_a_foot_is_followed_instead(shaken):
    shaken.sway_m = SLOW_M + 0.01
    shaken.go(SHAKEN_AMISS_S + 3 * DT)
    shaken.up = (False, True)
    shaken.go()
    assert shaken.footing.mending.side is None


def test_a_step_that_saved_the_balance_is_mended_as_soon_as_a_push(scene):
    """However lightly the body was pushed: the step itself has taken its feet apart."""
    scene.xi = np.array([0.0, 0.25])
    assert scene.go() == (STEPS, STANDS)
    scene.go(0.2)
    scene.put_down(LEFT)
    scene.place[LEFT] = STAND[LEFT] + ASIDE
    scene.xi = scene.place[LEFT].copy()
    scene.go(3 * DT)
    assert scene.go(SHAKEN_AMISS_S + 3 * DT) == (STANDS, STEPS)
