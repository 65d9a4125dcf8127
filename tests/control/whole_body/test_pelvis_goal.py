"""Which way the pelvis may face: as the player's, unless that would wring the legs that stand."""

import numpy as np
import pytest

from game import rotation
from game.control.whole_body.pelvis_goal import TWIST_RAD, held_by_feet

BOTH, LEFT_ONLY, NONE = (True, True), (True, False), (False, False)
BOW = rotation.exp(np.array([0.0, 0.4, 0.0]))
SPIN = np.array([0.3, -0.2, 2.0])


def facing(heading, yaws=(0.0, 0.0), stands=BOTH):
    """A bowed pelvis that is to turn to `heading`, what the feet let of that, and what is left of its spin."""
    upright, spin = rotation.multiply(rotation.about_z(heading), BOW), SPIN.copy()
    out = held_by_feet(upright, spin, yaws, stands)
    return upright, out, spin


@pytest.mark.parametrize("heading", [0.0, 0.3, -0.55])
def test_what_the_legs_can_turn_is_left_alone(heading):
    upright, out, spin = facing(heading)
    assert np.array_equal(out, upright) and np.array_equal(spin, SPIN)


@pytest.mark.parametrize("heading", [0.8, -1.3, 2.5])
def test_a_pelvis_turns_no_farther_than_its_feet_let_it_and_stays_bowed(heading):
    _, out, _ = facing(heading)
    assert rotation.yaw(out) == pytest.approx(np.copysign(TWIST_RAD, heading))
    assert rotation.matrix(out)[2, 2] == pytest.approx(np.cos(0.4))


def test_where_it_is_held_it_is_not_asked_to_turn_on():
    upright, _, spin = facing(1.5)
    before, after = rotation.matrix(upright) @ SPIN, rotation.matrix(upright) @ spin
    assert after[2] == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(after[:2], before[:2])


def test_the_foot_that_it_would_leave_farther_behind_holds_it():
    _, out, _ = facing(1.0, (0.2, -0.1))
    assert rotation.yaw(out) == pytest.approx(TWIST_RAD - 0.1)
    _, out, _ = facing(1.0, (0.2, -0.1), LEFT_ONLY)
    assert rotation.yaw(out) == pytest.approx(TWIST_RAD + 0.2)


def test_feet_in_the_air_hold_nothing():
    upright, out, spin = facing(2.0, stands=NONE)
    assert np.array_equal(out, upright) and np.array_equal(spin, SPIN)


def test_a_heading_across_half_a_turn_is_near_feet_that_face_there():
    upright, out, _ = facing(3.1, (-3.1, -3.0))
    np.testing.assert_allclose(np.abs(out @ upright), 1.0)
