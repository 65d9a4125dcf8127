"""When feet lift and land, told as scenes."""

import numpy as np
import pytest

from game.control.whole_body.footing import LIFT_AGAIN_M, RETURN_S
from game.control.whole_body.support_polygon import convex_hull, distance_inside
from tests.control.whole_body.footing_scene import CENTRED, HALF_WIDTH, LEFT, RIGHT, STAND, STANDS, STEPS, SWINGS, Scene


@pytest.fixture
def scene():
    return Scene()


def test_who_stands_goes_on_standing(scene):
    assert scene.go(2.0) == (STANDS, STANDS)
    assert scene.footing.intended is None


def test_a_foot_that_the_player_lifts_waits_until_the_weight_is_on_the_other(scene):
    scene.up = (True, False)
    assert scene.go(0.5) == (STANDS, STANDS)
    assert scene.footing.intended == RIGHT
    assert distance_inside(scene.footing.goal_hull(scene.soles(), 0.02), STAND[RIGHT]) > 0.0
    assert distance_inside(scene.footing.goal_hull(scene.soles(), 0.02), CENTRED) < 0.0
    scene.xi = STAND[RIGHT].copy()
    assert scene.go() == (SWINGS, STANDS)


def test_the_capture_point_must_be_over_the_other_sole(scene):
    scene.up = (True, False)
    edge = STAND[RIGHT] + [0.0, HALF_WIDTH]
    scene.xi = edge + [0.0, 0.003]
    assert scene.go(0.2) == (STANDS, STANDS)
    scene.xi = edge - [0.0, 0.003]
    assert scene.go() == (SWINGS, STANDS)


def test_a_foot_that_had_to_come_down_again_is_lifted_only_once_the_weight_is_well_over_the_other(scene):
    """A player who marches is followed at the edge; one who goes on standing on one leg gets a stand that lasts."""
    scene.up = (True, False)
    edge = STAND[RIGHT] + [0.0, HALF_WIDTH]
    scene.xi = edge - [0.0, 0.003]
    scene.go()
    scene.lift_off(LEFT)
    scene.xi = edge + [0.0, 0.02]
    assert scene.go(0.2)[LEFT] is STEPS
    scene.put_down(LEFT)
    scene.xi = edge - [0.0, 0.003]
    assert scene.go(0.3) == (STANDS, STANDS)
    scene.xi = edge - [0.0, LIFT_AGAIN_M + 0.001]
    assert scene.go() == (SWINGS, STANDS)


def test_a_new_lift_of_the_player_is_followed_at_the_edge_again(scene):
    scene.up, scene.footing.missed = (True, False), [True, False]
    scene.xi = STAND[RIGHT] + [0.0, HALF_WIDTH - 0.003]
    assert scene.go() == (STANDS, STANDS)
    scene.up = (False, False)
    scene.go()
    scene.up = (True, False)
    assert scene.go() == (SWINGS, STANDS)


def test_no_foot_lifts_off_another_that_has_no_floor_under_it(scene):
    scene.up, scene.xi = (True, False), STAND[RIGHT].copy()
    scene.touches[RIGHT], scene.height[RIGHT] = False, 0.01
    assert scene.go(0.3) == (STANDS, STANDS)


def test_on_one_leg_all_the_weight_is_meant_to_be_there(scene):
    scene.up, scene.xi = (True, False), STAND[RIGHT].copy()
    scene.go()
    scene.lift_off(LEFT)
    assert scene.go(5.0) == (SWINGS, STANDS), "as long as asked"
    assert scene.footing.intended == RIGHT
    assert distance_inside(scene.footing.hull(scene.soles(), 0.0), CENTRED) < 0.0, "the polygon is the right sole alone"


def test_a_foot_that_comes_down_stands_once_it_touches(scene):
    scene.up, scene.xi = (True, False), STAND[RIGHT].copy()
    scene.go()
    scene.lift_off(LEFT)
    scene.go(0.5)
    scene.up = (False, False)
    assert scene.go(0.1) == (SWINGS, STANDS), "still in the air"
    assert scene.footing.intended is None
    assert distance_inside(scene.footing.goal_hull(scene.soles(), 0.0), CENTRED) > 0.0, "the weight is meant to come between the feet"
    assert distance_inside(scene.footing.hull(scene.soles(), 0.0), CENTRED) < 0.0, "which nothing holds up yet"
    scene.put_down(LEFT)
    assert scene.go() == (STANDS, STANDS)


def test_a_foot_that_brushes_the_floor_while_the_player_has_it_up_swings_on(scene):
    scene.up, scene.xi = (True, False), STAND[RIGHT].copy()
    scene.go()
    scene.lift_off(LEFT)
    scene.go(0.3)
    scene.put_down(LEFT)
    assert scene.go(0.2) == (SWINGS, STANDS)


def test_a_foot_that_stands_amiss_is_set_right_after_a_while(scene):
    scene.place[LEFT] = STAND[LEFT] + [0.15, 0.0]
    scene.go(0.55)
    assert scene.footing.intended is None, "not yet"
    scene.go(0.1)
    assert scene.footing.intended == RIGHT
    scene.xi = STAND[RIGHT].copy()
    assert scene.go() == (STEPS, STANDS)
    foot = scene.footing.feet[LEFT]
    np.testing.assert_allclose(foot.goal[:2], STAND[LEFT])
    assert foot.duration_s == RETURN_S


def test_a_body_that_is_not_calm_does_not_mend_its_stance(scene):
    scene.place[LEFT] = STAND[LEFT] + [0.15, 0.0]
    scene.sway_m = 0.06
    scene.go(3.0)
    assert scene.footing.intended is None


def test_a_foot_turned_by_more_than_the_player_s_is_set_right_too(scene):
    scene.wished_yaw = (0.0, -0.6)
    scene.go(0.7)
    assert scene.footing.intended == LEFT
    scene.xi = STAND[LEFT].copy()
    assert scene.go() == (STANDS, STEPS)
    assert scene.footing.feet[RIGHT].goal_yaw == pytest.approx(-0.6)


def test_a_slight_difference_is_left_alone(scene):
    scene.place[LEFT] = STAND[LEFT] + [0.05, 0.02]
    scene.wished_yaw = (0.2, -0.2)
    assert scene.go(3.0) == (STANDS, STANDS)
    assert scene.footing.intended is None


def test_a_jump_takes_both_feet_off_and_the_first_to_touch_lands_it(scene):
    scene.up, scene.flight, scene.taking_off = (True, True), True, True
    assert scene.go() == (SWINGS, SWINGS)
    assert scene.footing.flying
    scene.taking_off = False
    scene.lift_off(LEFT)
    scene.lift_off(RIGHT)
    assert scene.go(0.3) == (SWINGS, SWINGS)
    scene.put_down(LEFT)
    scene.height[RIGHT] = 0.02
    assert scene.go() == (STANDS, STANDS)
    assert not scene.footing.flying and scene.footing.landed_s == pytest.approx(0.0)


def test_a_jump_that_the_body_does_not_make_is_not_begun(scene):
    scene.up, scene.flight = (True, True), True
    assert scene.go(0.3) == (STANDS, STANDS)
    assert not scene.footing.flying


def test_a_body_thrown_into_the_air_while_the_player_jumps_flies(scene):
    scene.up, scene.flight = (True, True), True
    scene.lift_off(LEFT, 0.01)
    scene.lift_off(RIGHT, 0.01)
    scene.go()
    assert scene.footing.flying


def test_a_standing_foot_that_lost_the_floor_is_brought_back(scene):
    scene.xi = STAND[RIGHT].copy()
    scene.lift_off(LEFT, 0.05)
    assert scene.go() == (SWINGS, STANDS)
    scene.go(0.1)
    scene.put_down(LEFT)
    assert scene.go() == (STANDS, STANDS)


def test_a_foot_that_only_tips_is_not_lost(scene):
    scene.touches[LEFT], scene.height[LEFT] = False, 0.01
    assert scene.go(0.5) == (STANDS, STANDS)


def test_the_polygon_is_that_of_the_feet_that_stand(scene):
    both = scene.footing.hull(scene.soles(), 0.01)
    expected = convex_hull(np.concatenate([sole.corners(0.01) for sole in scene.soles()]))
    np.testing.assert_array_equal(both, expected)
    assert distance_inside(both, CENTRED) > 0.1


def test_a_margin_makes_every_sole_smaller_all_round(scene):
    sole = scene.soles()[LEFT]
    assert distance_inside(sole.corners(0.01), sole.centre[:2]) == pytest.approx(HALF_WIDTH - 0.01)
    assert distance_inside(sole.corners(9.0), sole.centre[:2]) > 0.0, "never turned inside out"
