"""The player's world laid over the character's: where it stands there, which way it faces, where the floor is."""

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import FEET
from game.control.whole_body.motion_window import MotionWindow
from game.control.whole_body.player_stance import PlayerStance
from game.intake.foot_contacts import FootContacts
from tests.control.whole_body.moving_target import standing_at, target_at
from tests.physics.standing import original

RESTING_M = float(original().joint[FEET[0], 2])
FEET_LIST = list(FEET)


def ankles_of(x, y, yaw=0.0):
    """(2, 3) ankles of a character that stands at (x, y)."""
    turn = rotation.matrix(rotation.about_z(yaw))
    return np.array([x, y, 0.0]) + original().joint[FEET_LIST] @ turn.T


def settled(character=(0.0, 0.0, 0.0), player=(2.0, -1.0, 0.3), player_yaw=0.0, height=0.0):
    stance = PlayerStance(RESTING_M)
    target = target_at(0.0, standing_at(player[0], player[1], height), rotation.about_z(player_yaw))
    stance.settle(target, ankles_of(*character), character[2])
    return stance, target


def test_at_first_the_player_stands_where_the_character_stands():
    stance, target = settled(character=(0.5, 0.7, 1.0), player_yaw=0.4)
    theirs = target.pose.joint[FEET_LIST]
    middle = np.mean([stance.place(ankle) for ankle in theirs], axis=0)
    np.testing.assert_allclose(middle[:2], ankles_of(0.5, 0.7, 1.0).mean(axis=0)[:2], atol=1e-12)


def test_at_first_the_player_faces_as_the_character_does():
    stance, target = settled(character=(0.0, 0.0, 1.0), player_yaw=0.4)
    facing = stance.orientation(target.root_orientation)
    assert abs(facing @ rotation.about_z(1.0)) == pytest.approx(1.0)
    np.testing.assert_allclose(stance.direction(np.array([np.cos(0.4), np.sin(0.4), 0.5])), [np.cos(1.0), np.sin(1.0), 0.5], atol=1e-12)


def test_the_player_s_floor_is_the_character_s_floor():
    stance, target = settled(height=0.12)
    for ankle in target.pose.joint[FEET_LIST]:
        assert stance.place(ankle)[2] == pytest.approx(RESTING_M)


def test_a_step_of_the_player_is_as_long_and_goes_the_same_way_seen_from_the_body():
    stance, _ = settled(character=(0.0, 0.0, np.pi / 2), player_yaw=0.0)
    here, there = np.array([1.0, 1.0, 0.1]), np.array([1.4, 1.0, 0.1])
    np.testing.assert_allclose(stance.place(there) - stance.place(here), [0.0, 0.4, 0.0], atol=1e-12)


def test_places_and_directions_belong_together():
    stance, _ = settled(character=(0.3, 0.1, 0.8), player_yaw=-0.5)
    point, way = np.array([0.4, 0.2, 1.0]), np.array([0.3, -0.1, 0.2])
    np.testing.assert_allclose(stance.place(point + way) - stance.place(point), stance.direction(way), atol=1e-12)


def test_a_player_who_slides_away_slides_back_under_the_character_in_about_a_second():
    stance, _ = settled()
    slid = target_at(0.1, standing_at(2.1, -1.0))
    start = gap(stance, slid)
    assert start == pytest.approx(0.1)
    for _ in range(120):
        stance.drift(slid, ankles_of(0.0, 0.0), None, False, 1.0 / 120.0)
    assert gap(stance, slid) == pytest.approx(start * np.exp(-1.0), rel=0.02)


@pytest.mark.parametrize("pivot", [0, 1])
def test_the_foot_that_stays_while_the_other_is_put_right_is_soon_where_the_player_has_his(pivot):
    """However far apart the two stand: the other one is not asked."""
    stance, _ = settled()
    ankles = ankles_of(0.0, 0.0)
    ankles[1 - pivot, :2] += 0.4, 0.3
    ankles[pivot, :2] += 0.1, -0.05
    still = target_at(0.1, standing_at(2.0, -1.0))
    for _ in range(60):
        stance.drift(still, ankles, pivot, False, 1.0 / 120.0)
    place = stance.place(still.pose.joint[FEET_LIST[pivot]])
    assert np.hypot(*(place - ankles[pivot])[:2]) < 0.005


def test_where_steps_of_its_own_have_led_the_body_the_players_place_is_soon_too():
    gaps = []
    for moved in (False, True):
        stance, _ = settled()
        slid = target_at(0.1, standing_at(2.3, -1.0))
        for _ in range(36):
            stance.drift(slid, ankles_of(0.0, 0.0), None, moved, 1.0 / 120.0)
        gaps.append(gap(stance, slid))
    assert gaps[1] < 0.1 * gaps[0]


def gap(stance, target):
    there = np.mean([stance.place(ankle) for ankle in target.pose.joint[FEET_LIST]], axis=0)
    return float(np.hypot(*(there - ankles_of(0.0, 0.0).mean(axis=0))[:2]))


def test_a_floor_that_was_measured_wrong_is_mended_slowly():
    stance, _ = settled()
    higher = target_at(0.1, standing_at(2.0, -1.0, 0.05))
    for _ in range(600):
        stance.drift(higher, ankles_of(0.0, 0.0), None, False, 1.0 / 120.0)
    assert stance.place(higher.pose.joint[FEET[0]])[2] == pytest.approx(RESTING_M, abs=0.001)


def test_it_says_which_feet_are_up_and_whether_it_is_a_jump():
    stance, _ = settled()
    assert stance.up == [False, False] and not stance.flight
    stance.watch(target_at(0.1, standing_at(), contacts=FootContacts(left_planted=False)))
    assert stance.up == [True, False] and not stance.flight
    stance.watch(target_at(0.2, standing_at(), contacts=FootContacts(False, False, True)))
    assert stance.up == [True, True] and stance.flight
    stance.settle(target_at(0.3, standing_at()), ankles_of(0.0, 0.0), 0.0)
    assert stance.up == [False, False]


def test_an_ankle_of_the_motion_is_placed_like_any_point():
    stance, target = settled(character=(0.5, 0.7, 1.0), player_yaw=0.4)
    window = MotionWindow()
    window.add(target, 0.1)
    motion = window.moment(0.0)
    for side in range(2):
        np.testing.assert_allclose(stance.place(motion.place[1 + side]), stance.place(target.pose.joint[FEET[side]]), atol=1e-12)


def test_what_is_handed_in_is_left_as_it_was():
    stance, _ = settled(character=(0.5, 0.7, 1.0))
    point = np.array([0.4, 0.2, 1.0])
    stance.place(point)
    stance.direction(point)
    np.testing.assert_array_equal(point, [0.4, 0.2, 1.0])
