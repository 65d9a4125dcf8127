"""When a body that was shoved over counts as standing again, held against bodies that are moved by hand."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import FEET, PARTS
from game.report.up_again import HELD_S, UpAgain, is_down
from game.rotation import Floats
from game.target.forward_kinematics import pose_skeleton
from tests.report.observed import target_of

PLAN = load_body_plan("original")
IDLE = pose_skeleton(PLAN, PLAN.joint[0], rotation.IDENTITY, np.tile(rotation.IDENTITY, (14, 1)))
TARGET = target_of(PLAN, IDLE)
DT = 1.0 / 60.0


@dataclass
class Body:
    com: Floats
    turn: Floats
    foot_contact: tuple[bool, bool] = (True, True)


STANDING = Body(IDLE.centre_of_mass(PLAN), rotation.matrix(IDLE.orientation))
CROUCHING = replace(STANDING, com=STANDING.com * 0.7)
TILTED = replace(STANDING, turn=rotation.matrix(np.tile(rotation.exp(np.array([0.0, 1.2, 0.0])), (15, 1))))
ON_ONE_LEG = replace(STANDING, foot_contact=(True, False))


def watched(*spans):
    """(seconds, body, what of it touches the floor) one after the other."""
    rule, frame = UpAgain(), 0
    for seconds, body, on_floor in spans:
        for _ in range(round(seconds / DT)):
            frame += 1
            rule.see(frame * DT, body, TARGET, on_floor)
    return rule


@pytest.mark.parametrize("body", [CROUCHING, TILTED])
def test_who_is_low_or_tilted_is_down(body):
    assert is_down(body, TARGET, FEET) and not is_down(STANDING, TARGET, FEET)


def test_a_hand_on_the_floor_is_down_too_and_so_is_what_is_not_a_number():
    assert is_down(STANDING, TARGET, (*FEET, PARTS.index("hand_left")))
    assert is_down(replace(STANDING, com=np.full(3, np.nan)), TARGET, FEET)


def test_it_is_up_again_once_both_feet_bear_it_and_it_has_lasted():
    rule = watched((1.0, CROUCHING, FEET), (0.5, ON_ONE_LEG, FEET), (HELD_S + 0.1, STANDING, FEET))
    assert rule.fell and rule.up_s == pytest.approx(1.5, abs=2 * DT)


def test_a_moment_on_its_feet_is_not_enough():
    rule = watched((1.0, CROUCHING, FEET), (HELD_S - 0.1, STANDING, FEET))
    assert rule.fell and rule.up_s is None


def test_a_second_fall_takes_it_back():
    rule = watched((0.5, CROUCHING, FEET), (1.0, STANDING, FEET), (0.1, TILTED, FEET))
    assert rule.up_s is None


def test_who_never_fell_has_stood_all_the_time():
    rule = watched((1.0, STANDING, FEET))
    assert not rule.fell and rule.up_s == pytest.approx(DT)
