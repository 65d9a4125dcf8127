"""A leap counts from straight legs, and hips that rise without one are stopped before the legs are straight."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from game.characters.body_plan import load_body_plan
from game.characters.skeleton import FEET
from game.control.whole_body.contact_states import Phase
from game.control.whole_body.footing import Footing
from game.control.whole_body.leap import BRAKE, BRAKE_RATE, HIGHEST_LEAP_M, LEAST_LEAP_M, SEEN_SHORT, ComHeight, leap_speed
from game.control.whole_body.leg_kinematics import LEG_PARTS
from game.control.whole_body.motion_window import MotionWindow
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.sole import leg_reach, rise_left
from tests.control.whole_body.moving_target import standing_at, target_at

PLAN, GRAVITY = load_body_plan("original"), 9.81
PLAYER = PlayerStance(float(PLAN.joint[FEET[0], 2]))


def body(joint=PLAN.joint, com_z: float = PLAN.idle_com_height, speed: float = 0.0) -> Any:
    """A body in the idle pose unless its joints (15, 3) are given, that rises as a whole at `speed`."""
    velocity = np.zeros(48)
    velocity[2] = speed
    com = np.array([0.0, 0.0, com_z])
    return SimpleNamespace(plan=PLAN, gravity=GRAVITY, joint=joint, com=com, com_velocity=velocity[:3], velocity=velocity)


def crouched(drop_m: float):
    """Joints of somebody whose every joint above the ankles has come down; knees aside."""
    joint = PLAN.joint.copy()
    joint[[part for part in range(len(joint)) if part not in FEET], 2] -= drop_m
    return joint


def seen(low_m: float, speed: float) -> MotionWindow:
    """The last third of a second of a player whose hips rise at a constant speed and are now `low_m` below standing."""
    window = MotionWindow()
    for k in range(10):
        time_s = (k - 9) / 30.0
        window.add(target_at(time_s, standing_at(z=speed * time_s - low_m)), 0.2)
    return window


def test_a_player_who_only_gets_up_does_not_leap():
    assert leap_speed(seen(0.2, math.sqrt(2.0 * GRAVITY * (0.2 + 0.9 * LEAST_LEAP_M) / SEEN_SHORT)), PLAYER, body()) == 0.0


def test_bent_legs_go_on_pushing_so_the_swing_counts_from_standing():
    speed, low = 2.2, 0.1
    swing = SEEN_SHORT * speed**2 / (2.0 * GRAVITY)
    assert LEAST_LEAP_M + low < swing < HIGHEST_LEAP_M
    wanted = leap_speed(seen(low, speed), PLAYER, body(com_z=PLAN.idle_com_height - low))
    assert wanted == pytest.approx(math.sqrt(2.0 * GRAVITY * (swing + low)), rel=1e-6)


def test_nobody_is_followed_higher_than_people_leap():
    assert leap_speed(seen(0.1, 5.0), PLAYER, body()) == pytest.approx(math.sqrt(2.0 * GRAVITY * HIGHEST_LEAP_M))


def test_what_is_left_of_a_leg_is_what_the_hip_can_rise():
    for side in range(2):
        joint = crouched(0.1)
        left = rise_left(body(joint), side)
        assert 0.05 < left < 0.1
        thigh, _, _ = LEG_PARTS[side]
        joint[thigh, 2] += left
        assert leg_reach(body(joint), side) == pytest.approx(0.995, abs=1e-9)


def asked(of: Any, speed: float, newest: float = 0.0) -> float:
    """m/s^2 upwards asked of a body whose player rises at `speed`, and in the newest frame at another."""
    window, footing = seen(0.0, speed), Footing()
    assert all(foot.phase is Phase.STANCE for foot in footing.feet)
    return ComHeight().acceleration(window.moment(0.0), newest, leap_speed(window, PLAYER, of), PLAYER, footing, of)


def test_hips_that_rise_fast_on_nearly_straight_legs_are_braked():
    slow, fast = 0.3, 1.0
    room = rise_left(body(crouched(0.03)), 0)
    assert slow**2 < 2.0 * BRAKE * room < fast**2
    assert asked(body(crouched(0.2), speed=fast), 0.9) == pytest.approx(20.0 * (0.9 - fast))
    assert asked(body(crouched(0.03), speed=fast), 0.9) == pytest.approx(-BRAKE_RATE * (fast - math.sqrt(2.0 * BRAKE * room)))
    assert asked(body(crouched(0.03), speed=slow), 0.9) == asked(body(crouched(0.2), speed=slow), 0.9)


def test_hips_are_not_braked_below_the_speed_at_which_the_player_rises():
    """Who pushes off is on straight legs before his leap can be told from getting up."""
    free = asked(body(crouched(0.2), speed=1.0), 0.9)
    assert asked(body(crouched(0.03), speed=1.0), 0.9, newest=1.0) == free
    assert asked(body(crouched(0.03), speed=1.0), 0.9, newest=0.8) == pytest.approx(-BRAKE_RATE * 0.2)


def test_a_leap_is_never_braked():
    assert asked(body(crouched(0.03), speed=1.2), 2.5) > 0.0


def test_a_landing_comes_to_rest_and_rises_once_the_player_has_landed_too():
    """While he is still up in the air the body is not thrown after him again."""
    window, footing, height = seen(0.0, 0.0), Footing(), ComHeight()
    footing.landed_s = 0.01
    deep = body(com_z=PLAN.idle_com_height - 0.15)

    def asked_of(player: PlayerStance) -> float:
        return height.acceleration(window.moment(0.0), 0.0, 0.0, player, footing, deep)

    aloft = PlayerStance(PLAYER.floor_z)
    aloft.flight = True
    assert asked_of(aloft) == 0.0 < asked_of(PLAYER)
