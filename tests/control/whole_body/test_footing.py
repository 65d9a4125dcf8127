"""When feet lift, land and step, told as scenes: a body over its soles, a capture point, and what the player does."""

import numpy as np
import pytest

from game.control.whole_body.capture_point import natural_frequency
from game.control.whole_body.contact_states import Phase
from game.control.whole_body.footing import RETURN_S, Footing
from game.control.whole_body.saving_step import CROSS_AHEAD_M, CROSS_SIDE_M, LEAST_SIDE_M, OVERSTEP, REACH_M, STEP_S
from game.control.whole_body.sole import Sole
from game.control.whole_body.support_polygon import convex_hull, distance_inside
from game.control.whole_body.wish import Wish

LEFT, RIGHT = 0, 1
OMEGA = natural_frequency(9.81, 0.95)
DT = 1.0 / 120.0
HALF_LENGTH, HALF_WIDTH = 0.15, 0.045
STAND = np.array([[0.0, 0.1], [0.0, -0.1]])
CENTRED = np.zeros(2)


class Scene:
    """Two feet, a capture point and a player, all moved by hand."""

    def __init__(self):
        self.footing = Footing()
        self.place, self.height, self.yaw = STAND.copy(), [0.0, 0.0], [0.0, 0.0]
        self.touches = [True, True]
        self.xi = CENTRED.copy()
        self.up, self.flight = (False, False), False
        self.wished, self.wished_yaw = STAND.copy(), (0.0, 0.0)
        self.calm, self.taking_off = True, False

    def soles(self) -> tuple[Sole, Sole]:
        return self.sole(LEFT), self.sole(RIGHT)

    def sole(self, side: int) -> Sole:
        centre, ankle = np.array([*self.place[side], self.height[side]]), np.array([*self.place[side], 0.09])
        return Sole(centre, self.yaw[side], ankle, self.touches[side], HALF_LENGTH, HALF_WIDTH)

    def go(self, seconds=DT):
        for _ in range(max(1, round(seconds / DT))):
            wish = Wish(self.up, self.flight, self.wished.copy(), self.wished_yaw)
            self.footing.update(self.soles(), self.xi, OMEGA, wish, self.calm, self.taking_off, DT)
        return self.phases()

    def phases(self):
        return tuple(foot.phase for foot in self.footing.feet)

    def lift_off(self, side, height=0.05):
        self.touches[side], self.height[side] = False, height

    def put_down(self, side):
        self.touches[side], self.height[side] = True, 0.0


@pytest.fixture
def scene():
    return Scene()


STANDS, SWINGS, STEPS = Phase.STANCE, Phase.SWING, Phase.STEP


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
    scene.put_down(LEFT)
    assert scene.go() == (STANDS, STANDS)


def test_a_foot_that_brushes_the_floor_while_the_player_has_it_up_swings_on(scene):
    scene.up, scene.xi = (True, False), STAND[RIGHT].copy()
    scene.go()
    scene.lift_off(LEFT)
    scene.go(0.3)
    scene.put_down(LEFT)
    assert scene.go(0.2) == (SWINGS, STANDS)


def test_a_push_sideways_makes_the_foot_on_that_side_step_out(scene):
    scene.xi = np.array([0.0, 0.2])
    assert scene.go() == (STEPS, STANDS)
    foot = scene.footing.feet[LEFT]
    assert foot.duration_s == STEP_S
    assert foot.goal[1] > STAND[LEFT, 1] + 0.1 and foot.goal[2] == 0.0


def test_a_hard_push_sideways_makes_the_other_foot_cross_over(scene):
    scene.xi = np.array([0.0, 0.35])
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
    assert scene.footing.feet[LEFT].goal[1] < -0.2


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
    scene.calm = False
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
