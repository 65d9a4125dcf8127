"""The hold between two ticks: firm where there is room, and never beyond the strength of a joint within the speeds it allows for."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from game.control.whole_body.hold_damping import SPARE_RAD_S, held_speed, hold_damping


def held(wanted, torque, low=-100.0, high=60.0):
    return float(hold_damping(np.array([wanted]), np.array([torque]), np.array([low]), np.array([high]))[0])


def test_a_joint_with_room_is_held_as_firmly_as_wanted():
    assert held(3.0, 10.0) == 3.0


def test_a_joint_at_its_limit_is_not_held_at_all():
    assert held(3.0, 60.0) == held(3.0, -100.0) == 0.0


def test_a_torque_beyond_its_limit_does_not_turn_the_hold_round():
    assert held(3.0, 75.0) == 0.0


@given(st.floats(0.0, 500.0), st.floats(-100.0, 60.0), st.floats(-SPARE_RAD_S, SPARE_RAD_S))
def test_torque_and_hold_together_stay_within_the_strength(wanted, torque, off_rad_s):
    together = torque - held(wanted, torque) * off_rad_s
    assert -100.0 - 1e-9 <= together <= 60.0 + 1e-9


@given(st.floats(0.0, 500.0), st.floats(-100.0, 60.0))
def test_no_joint_is_held_more_firmly_than_wanted(wanted, torque):
    assert 0.0 <= held(wanted, torque) <= wanted


def test_a_hold_follows_the_plan_but_never_whirls_a_limb() -> None:
    velocity, gain = np.zeros(42), np.zeros(42)
    velocity[:4], gain[:4] = (1.0, 1.0, 24.0, -300.0), (2.0, 900.0, 5.0, -5.0)
    held = held_speed(velocity, gain)
    np.testing.assert_allclose(held[:4], (3.0, 6.0, 25.0, -295.0))
    np.testing.assert_array_equal(held[4:], 0.0)
