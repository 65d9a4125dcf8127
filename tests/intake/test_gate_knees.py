"""Knees bend forward: what the sensor shows otherwise is moved as little as legs need, hips and ankles stay."""

import numpy as np
import pytest

from game import rotation
from game.intake.gate_knees import BACK, SIDE, bend_forward
from game.intake.gate_legs import LEGS
from game.rotation import Floats
from kinect.body import Joint
from tests.intake.gated_players import gated, joints, standing

KNEES = [Joint.KNEE_LEFT, Joint.KNEE_RIGHT]
THIGH, SHIN = 0.42, 0.40


def bent(angle_rad: float, aside_rad: float = 0.0, *, hip_rad: float = 0.0, heading_rad: float = 0.0) -> Floats:
    """(20, 3) somebody who faces `heading_rad` with both knees bent forward and aside (outward), thighs swung forward by `hip_rad`."""
    out = standing()
    turn, swing = rotation.about_z(heading_rad), rotation.exp(np.array([0.0, -hip_rad, 0.0]))
    for side, (hip, knee, ankle) in enumerate(LEGS):
        sign = 1.0 if side == 0 else -1.0
        shin = rotation.multiply(swing, rotation.exp(np.array([sign * aside_rad, angle_rad, 0.0])))
        out[hip] = rotation.rotate(turn, np.array([0.0, sign * 0.09, 0.9]))
        out[knee] = out[hip] + rotation.rotate(rotation.multiply(turn, swing), np.array([0.0, 0.0, -THIGH]))
        out[ankle] = out[knee] + rotation.rotate(rotation.multiply(turn, shin), np.array([0.0, 0.0, -SHIN]))
    return out


def corrected(seen: Floats) -> Floats:
    out = seen.copy()
    bend_forward(out)
    return out


def off_line(body: Floats, side: int) -> Floats:
    """(3,) m from the line between hip and ankle to the knee."""
    hip, knee, ankle = body[LEGS[side]]
    along = (ankle - hip) / np.linalg.norm(ankle - hip)
    return knee - hip - ((knee - hip) @ along) * along


@pytest.mark.parametrize("hip_rad", [0.0, 0.6, 1.4])
@pytest.mark.parametrize("angle_rad", [0.0, 0.4, 1.2, 2.0])
@pytest.mark.parametrize("heading_rad", [0.0, 1.1])
def test_a_leg_that_bends_as_legs_do_stays_as_it_is(hip_rad, angle_rad, heading_rad):
    seen = bent(angle_rad, hip_rad=hip_rad, heading_rad=heading_rad)
    np.testing.assert_allclose(corrected(seen), seen, atol=1e-9)


def test_a_thigh_turned_out_in_a_crouch_stays_turned_out():
    seen = bent(1.2, 0.8)
    np.testing.assert_allclose(corrected(seen), seen, atol=1e-12)


@pytest.mark.parametrize("heading_rad", [0.0, -0.8])
def test_a_knee_bent_back_is_nearly_straight_afterwards(heading_rad):
    out = corrected(bent(-0.5, heading_rad=heading_rad))
    reach = THIGH * SHIN / (THIGH + SHIN)
    ahead = rotation.rotate(rotation.about_z(heading_rad), np.array([1.0, 0.0, 0.0]))
    for side in range(2):
        assert -1.2 * BACK * reach < off_line(out, side) @ ahead < 0.0


def test_a_straight_knee_bent_aside_leans_by_its_range():
    out = corrected(bent(0.0, 0.7))
    for side in range(2):
        thigh, shin = (out[LEGS[side, k + 1]] - out[LEGS[side, k]] for k in range(2))
        angle = np.arccos(thigh @ shin / np.linalg.norm(thigh) / np.linalg.norm(shin))
        assert SIDE < np.sin(angle) < 1.2 * SIDE


def test_only_knees_move_and_only_off_the_line_from_hip_to_ankle():
    seen = bent(-0.4, 0.6, hip_rad=0.3)
    out = corrected(seen)
    others = [joint for joint in Joint if joint not in KNEES]
    np.testing.assert_array_equal(out[others], seen[others])
    for side in range(2):
        hip, knee, ankle = LEGS[side]
        assert abs((out[knee] - seen[knee]) @ (seen[ankle] - seen[hip])) < 1e-12 < np.linalg.norm(out[knee] - seen[knee])


def test_hips_on_one_spot_tell_no_front_and_knees_stay():
    seen = bent(-0.5)
    seen[Joint.HIP_RIGHT] = seen[Joint.HIP_LEFT]
    np.testing.assert_array_equal(corrected(seen), seen)


def test_the_gate_bends_knees_forward_unless_that_is_turned_off():
    seen = np.repeat(bent(-0.5)[None], 5, axis=0)
    on, off = (joints(gated(seen, gate__knees=wanted))[-1, KNEES, 0] for wanted in (True, False))
    assert np.all(on > off + 0.05)
