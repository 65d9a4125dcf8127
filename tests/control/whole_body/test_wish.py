"""Where the player's feet are wanted: as they are seen, unless no leg could hold them so."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import JOINT_COUNT
from game.control.whole_body.motion_window import Motion
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.sole import ahead_of_ankle
from game.control.whole_body.wish import INWARD_RAD, LEAST_APART_M, MOST_TURN_RAD, OUTWARD_RAD, wish_of

PLAN = load_body_plan("original")
BODY: Any = SimpleNamespace(plan=PLAN)


def wish(heading=0.0, feet_yaw=(0.0, 0.0), ankles=((0.0, 0.12), (0.0, -0.12)), facing=None):
    """What a player with this heading wants of a character whose pelvis has the heading `facing`, the player's where that is None."""
    turn, none = np.zeros((JOINT_COUNT + 3, 4)), np.zeros((JOINT_COUNT + 3, 3))
    turn[:, 0] = 1.0
    for row, yaw in ((JOINT_COUNT, heading), (JOINT_COUNT + 1, feet_yaw[0]), (JOINT_COUNT + 2, feet_yaw[1])):
        turn[row] = rotation.about_z(yaw)
    place = np.array([[0.0, 0.0, 0.9], [*ankles[0], 0.08], [*ankles[1], 0.08], [0.0, 0.0, 1.0]])
    body: Any = SimpleNamespace(plan=PLAN, orientation=rotation.about_z(heading if facing is None else facing)[None])
    return wish_of(PlayerStance(0.08), Motion(turn, none, none, place, np.zeros((4, 3)), np.zeros((4, 3))), body)


def test_feet_that_legs_can_hold_are_wanted_as_they_are():
    ankles = np.array([[0.0, 0.3], [0.1, -0.1]])
    seen = wish(feet_yaw=(0.3, -0.4), ankles=ankles)
    assert seen.yaw == pytest.approx((0.3, -0.4))
    for side in range(2):
        ahead = ahead_of_ankle(BODY) * np.array([math.cos(seen.yaw[side]), math.sin(seen.yaw[side])])
        np.testing.assert_allclose(seen.place[side], ankles[side] + ahead, atol=1e-12)


@pytest.mark.parametrize("heading", [0.0, 2.5, -3.0])
def test_a_foot_turned_as_no_leg_turns_points_as_far_as_one_can(heading):
    seen = wish(heading, (heading + 1.5, heading + 1.5), ((0.0, 0.0), (0.0, 0.0)))
    left, right = (math.remainder(yaw - heading, math.tau) for yaw in seen.yaw)
    assert left == pytest.approx(OUTWARD_RAD)
    assert right == pytest.approx(INWARD_RAD)


@pytest.mark.parametrize("heading", [0.0, 1.2])
def test_no_foot_is_wanted_on_the_other_one(heading):
    c, s = math.cos(heading), math.sin(heading)
    for left in (0.14, 0.05, 0.0, -0.2):
        seen = wish(heading, (heading, heading), ((-0.5 * left * s, 0.5 * left * c), (0.5 * left * s, -0.5 * left * c)))
        apart = seen.place[0] - seen.place[1]
        assert -s * apart[0] + c * apart[1] == pytest.approx(LEAST_APART_M)
        np.testing.assert_allclose(seen.place.mean(axis=0), wish(heading, (heading, heading)).place.mean(axis=0), atol=1e-12)


@pytest.mark.parametrize("facing", [0.4, -0.6])
def test_a_character_that_faces_nearly_as_the_player_is_asked_for_his_stance(facing):
    asked, his = wish(facing=facing), wish()
    np.testing.assert_allclose(asked.place, his.place)
    assert asked.yaw == his.yaw and asked.back_rad == 0.0


@pytest.mark.parametrize("facing", [1.5, -2.4, 3.1])
def test_a_character_that_faces_elsewhere_turns_to_the_player_in_steps(facing):
    asked, his = wish(facing=facing), wish()
    towards = facing - np.copysign(MOST_TURN_RAD, facing)
    assert asked.yaw == pytest.approx((towards, towards)) and asked.back_rad == pytest.approx(towards)
    np.testing.assert_allclose(asked.place.mean(axis=0), his.place.mean(axis=0), atol=1e-12)
    apart = asked.place[0] - asked.place[1]
    assert np.hypot(*apart) == pytest.approx(np.hypot(*(his.place[0] - his.place[1])))
    assert np.arctan2(-apart[0], apart[1]) == pytest.approx(towards)
