"""Pelvis and shoulders face where a person can: what the sensor loses in its depth is neither followed nor believed."""

import numpy as np
import pytest

from game import rotation
from game.intake.gate_heading import FARTHEST_RAD, HIPS_SHARE, MOST_SLANT_RAD, BodyHeading
from game.intake.intake import Intake
from game.rotation import Floats
from game.tunables import Settings
from kinect.body import Joint
from kinect.clip import ClipSource
from tests.intake.gated_players import HZ, standing
from tests.kinect.recordings import SHARED

HIPS, SHOULDERS = (Joint.HIP_LEFT, Joint.HIP_RIGHT), (Joint.SHOULDER_LEFT, Joint.SHOULDER_RIGHT)
LEG_M, FASTEST, TWIST = 0.85, 5.0, 0.6


def turned(joints: Floats, angle_rad: float, only: tuple[Joint, Joint] | None = None) -> Floats:
    """Joints (20, 3) turned about the vertical through the spine, or two of them about their middle."""
    which = list(only or Joint)
    centre = joints[which].mean(axis=0) if only else joints[Joint.SPINE]
    out = joints.copy()
    out[which] = centre + rotation.rotate(rotation.about_z(angle_rad), joints[which] - centre)
    return out


def heading(joints: Floats, line: tuple[Joint, Joint]) -> float:
    across = joints[line[0]] - joints[line[1]]
    return float(np.arctan2(-across[0], across[1]))


def placed(frames: list[Floats]) -> list[Floats]:
    """The frames at 30 Hz through a player's heading."""
    body, out = BodyHeading(), []
    for frame in frames:
        out.append(frame.copy())
        body.apply(out[-1], 1.0 / HZ, LEG_M, FASTEST, TWIST)
    return out


def test_a_turn_to_seventy_degrees_at_three_radians_a_second_passes_as_it_came():
    frames = [turned(standing(), angle) for angle in np.minimum(np.arange(30) * 3.0 / HZ, np.radians(70.0))]
    for frame, out in zip(frames, placed(frames), strict=True):
        np.testing.assert_array_equal(frame, out)


def test_a_pelvis_twists_against_the_shoulders_as_far_as_a_spine_can():
    frames = [turned(standing(), angle, HIPS) for angle in np.minimum(np.arange(20) * 2.0 / HZ, 0.5)]
    np.testing.assert_array_equal(placed(frames)[-1], frames[-1])


def test_hips_that_jump_and_come_back_are_hardly_followed():
    frames = [standing(), turned(standing(), 1.0, HIPS), standing()]
    out = placed(frames)
    assert abs(heading(out[1], HIPS) - heading(frames[0], HIPS)) < 0.05
    np.testing.assert_allclose(heading(out[2], HIPS), heading(frames[0], HIPS), atol=1e-12)


@pytest.mark.parametrize("wrong", [HIPS, SHOULDERS])
def test_the_line_that_stays_is_believed_and_the_other_brought_within_a_spine_s_twist(wrong):
    right = SHOULDERS if wrong == HIPS else HIPS
    out = placed([standing()] + [turned(standing(), 1.2, wrong)] * 60)
    stood = heading(standing(), right)
    assert abs(heading(out[-1], right) - stood) < TWIST + 1e-9
    assert abs(heading(out[-1], wrong) - heading(out[-1], right)) <= TWIST + 1e-9


def test_ends_that_are_mixed_up_turn_nobody_round():
    frames = [turned(standing(), angle) for angle in (0.0, 0.2)] + [turned(turned(standing(), 0.2), np.pi, HIPS)] * 5
    assert abs(heading(frames[-1], HIPS)) > FARTHEST_RAD
    assert abs(heading(placed(frames)[-1], HIPS) - heading(frames[1], HIPS)) < 0.25


def test_hips_lost_in_the_depth_lie_square_across_the_back_where_they_faced():
    lost = standing()
    middle = 0.5 * (lost[HIPS[0]] + lost[HIPS[1]])
    lost[HIPS[0]], lost[HIPS[1]] = middle + [0.012, 0.0, 0.02], middle - [0.012, 0.0, 0.02]
    out = placed([standing(), *[lost] * 10])[-1]
    across, up = out[HIPS[0]] - out[HIPS[1]], out[Joint.SPINE] - middle
    np.testing.assert_allclose(np.linalg.norm(across), HIPS_SHARE * LEG_M, atol=1e-12)
    assert abs(across @ up) < 1e-12
    stood = heading(standing(), HIPS)
    assert abs(heading(out, HIPS) - stood) < 0.25 * abs(heading(lost, HIPS) - stood)
    np.testing.assert_allclose(0.5 * (out[HIPS[0]] + out[HIPS[1]]), middle, atol=1e-12)


def test_no_hip_hangs_lower_than_a_pelvis_tilts():
    slanted = standing()
    slanted[HIPS[0], 2] += 0.15
    out = placed([slanted])[0]
    across, up = out[HIPS[0]] - out[HIPS[1]], out[Joint.SPINE] - 0.5 * (out[HIPS[0]] + out[HIPS[1]])
    slant = np.arcsin(across @ up / np.linalg.norm(across) / np.linalg.norm(up))
    np.testing.assert_allclose(abs(slant), MOST_SLANT_RAD, atol=1e-9)


def test_elbows_come_half_of_their_shoulders_way_and_hands_stay():
    out = placed([standing(), turned(standing(), 1.5, SHOULDERS)])[1]
    back = out[list(SHOULDERS)] - turned(standing(), 1.5, SHOULDERS)[list(SHOULDERS)]
    moved = out[[Joint.ELBOW_LEFT, Joint.ELBOW_RIGHT]] - standing()[[Joint.ELBOW_LEFT, Joint.ELBOW_RIGHT]]
    np.testing.assert_allclose(moved, 0.5 * back, atol=1e-12)
    np.testing.assert_array_equal(out[Joint.WRIST_LEFT], standing()[Joint.WRIST_LEFT])


@pytest.mark.skipif(not SHARED.is_dir(), reason=f"no recordings in {SHARED}")
def test_a_player_seen_from_the_side_turns_no_faster_than_a_person():
    source = ClipSource(SHARED / "v1_gk_profile.npz")
    intake = Intake(Settings(), mirrored=False)
    frames = [frame for frame in (intake.apply(frame) for frame in source.poll(1e3)) if frame is not None]
    speeds = []
    for line in (HIPS, SHOULDERS):
        faced = np.unwrap([heading(frame.joints, line) for frame in frames])
        speeds.append(np.abs(np.diff(faced)) / np.diff([frame.time_s for frame in frames]))
        raw = np.unwrap([heading(frame.raw, line) for frame in frames])
        assert np.abs(np.diff(raw)).max() * HZ > 30.0
    # hips across a back that tilts meanwhile turn a little with it
    assert speeds[0].max() <= 1.25 * FASTEST and speeds[1].max() <= 1.001 * FASTEST
