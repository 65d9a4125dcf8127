"""Half a second of quiet standing tells how a player is built and how the sensor sees it."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import PARTS
from game.rotation import Floats
from game.target.calibration import OFFSET_LIMIT_M, QUIET_S, calibrate, quietest_stretch
from game.target.kinematic_target import map_input
from game.target.mapping import bone_directions
from kinect.body import Joint
from tests.target.players import Player, any_pose, idle

PLAN = load_body_plan("original")
PLAYER = Player(PLAN, 0.95, 0.3, (0.1, -0.2))
STANDING = PLAYER.joints(idle(PLAN))


def quiet(joints: Floats, frames: int = 15) -> Floats:
    return np.repeat(joints[None], frames, axis=0)


def shifted(joint: Joint, by: tuple[float, float, float]) -> Floats:
    """The standing player with one joint seen elsewhere, relative to the player's heading."""
    joints = STANDING.copy()
    joints[joint] += rotation.rotate(rotation.about_z(PLAYER.heading_rad), np.array(by))
    return joints


@pytest.mark.parametrize(
    ("joint", "by"),
    [
        (Joint.SPINE, (-0.05, 0.02, 0.0)),
        (Joint.SHOULDER_CENTER, (0.06, 0.0, 0.01)),
        (Joint.KNEE_LEFT, (0.06, 0.03, 0.0)),
        (Joint.HEAD, (0.03, 0.0, 0.0)),
        (Joint.FOOT_RIGHT, (0.0, -0.03, -0.02)),
    ],
)
def test_what_the_sensor_sees_askew_in_quiet_standing_is_taken_for_idle(joint, by):
    joints = shifted(joint, by)
    mapped = map_input(joints, calibrate(PLAN, quiet(joints)))
    np.testing.assert_allclose(rotation.log(mapped.joint_rotation), 0.0, atol=1e-7)
    assert rotation.yaw(mapped.root_orientation) == pytest.approx(PLAYER.heading_rad, abs=0.1)
    assert rotation.rotate(mapped.root_orientation, np.array([0.0, 0.0, 1.0]))[2] == pytest.approx(1.0)


def test_arms_held_out_while_calibrating_are_not_taken_for_idle():
    joints = STANDING.copy()
    out = rotation.rotate(rotation.about_z(PLAYER.heading_rad), np.array([0.0, 0.25, 0.25]))
    joints[Joint.ELBOW_LEFT] = joints[Joint.SHOULDER_LEFT] + out
    joints[[Joint.WRIST_LEFT, Joint.HAND_LEFT]] = joints[Joint.ELBOW_LEFT] + np.outer([1.0, 1.3], out)
    mapped = map_input(joints, calibrate(PLAN, quiet(joints)))
    turn = rotation.log(mapped.joint_rotation[PARTS.index("upper_arm_left") - 1])
    np.testing.assert_allclose(turn, [0.75 * np.pi, 0.0, 0.0], atol=1e-7)


def test_a_leg_far_from_straight_is_not_taken_for_idle():
    joints = shifted(Joint.KNEE_LEFT, (0.3, 0.0, 0.1))
    calibration = calibrate(PLAN, quiet(joints))
    thigh, shin = PARTS.index("upper_leg_left"), PARTS.index("lower_leg_left")
    np.testing.assert_array_equal(calibration.idle_direction[[thigh, shin]], [[0.0, 0.0, -1.0]] * 2)


def test_hips_and_shoulders_seen_a_little_off_are_moved_onto_the_characters():
    joints = shifted(Joint.HIP_CENTER, (0.0, 0.0, -0.05))
    calibration = calibrate(PLAN, quiet(joints))
    np.testing.assert_allclose(calibration.root_offset, [0.0, 0.0, 0.05 / PLAYER.size], atol=1e-9)
    np.testing.assert_allclose(map_input(joints, calibration).root_position, PLAN.joint[0], atol=1e-9)


def test_a_hip_centre_far_off_is_moved_no_farther_than_build_can_explain():
    calibration = calibrate(PLAN, quiet(shifted(Joint.HIP_CENTER, (0.0, 0.0, -0.5))))
    np.testing.assert_allclose(calibration.root_offset, [0.0, 0.0, OFFSET_LIMIT_M], atol=1e-9)


def test_a_floor_that_is_seen_too_high_is_lowered_to_the_characters_soles():
    joints = STANDING + [0.0, 0.0, 0.07]
    calibration = calibrate(PLAN, quiet(joints))
    ankles = map_input(joints, calibration).end_effector[:2, 2]
    np.testing.assert_allclose(ankles, PLAN.joint[PARTS.index("foot_left"), 2], atol=1e-9)


def test_one_wild_frame_among_fifteen_changes_nothing():
    frames = quiet(STANDING)
    wild = frames.copy()
    wild[4] = np.random.default_rng(1).normal(size=(20, 3))
    calm, disturbed = calibrate(PLAN, frames), calibrate(PLAN, wild)
    assert disturbed.scale == pytest.approx(calm.scale)
    np.testing.assert_allclose(disturbed.idle_direction, calm.idle_direction, atol=1e-12)
    np.testing.assert_allclose(disturbed.origin, calm.origin, atol=1e-12)


def recording(still_from: int, still_to: int, still: Floats, frames: int = 120) -> tuple[Floats, Floats]:
    """Times and joints of a player who sways, but for one stretch in which `still` is held."""
    t = np.arange(frames) / 30.0
    joints = quiet(STANDING, frames)
    joints[:, :, 0] += 0.3 * np.sin(4.0 * t)[:, None] * joints[:, :, 2]
    joints[still_from:still_to] = still
    return t, joints


def is_about(found: slice, start: int) -> bool:
    """Half a second from `start`, give or take a frame: the calibration takes medians."""
    return found.stop - found.start == 15 and abs(found.start - start) <= 1


@pytest.mark.parametrize("start", [0, 40, 105])
def test_the_quietest_half_second_is_found(start):
    t, joints = recording(start, start + 15, STANDING)
    assert is_about(quietest_stretch(t, joints), start)


def test_a_quiet_crouch_is_passed_over_for_a_quiet_stand():
    crouch = STANDING.copy()
    crouch[[Joint.KNEE_LEFT, Joint.KNEE_RIGHT], 0] += 0.3
    t, joints = recording(10, 40, crouch)
    joints[70:85] = STANDING + np.random.default_rng(2).normal(scale=1e-3, size=(15, 20, 3))
    assert is_about(quietest_stretch(t, joints), 70)


def test_waving_hands_do_not_make_a_stand_unquiet():
    t, joints = recording(50, 65, STANDING)
    joints[50:65, Joint.HAND_LEFT] = np.random.default_rng(3).normal(size=(15, 3))
    assert is_about(quietest_stretch(t, joints), 50)


def test_frames_that_are_not_numbers_are_passed_over():
    t, joints = recording(20, 60, STANDING)
    joints[35, Joint.KNEE_LEFT] = np.nan
    stretch = quietest_stretch(t, joints)
    assert np.all(np.isfinite(joints[stretch]))
    np.testing.assert_array_equal(joints[stretch], quiet(STANDING))


def test_a_slower_recording_gives_half_a_second_too():
    t, joints = recording(40, 80, STANDING)
    stretch = quietest_stretch(2.0 * t, joints)
    assert stretch.stop - stretch.start == round(15.0 * QUIET_S)


@pytest.mark.parametrize("frames", [1, 2, 3, 15])
def test_a_recording_shorter_than_half_a_second_is_taken_whole(frames):
    assert quietest_stretch(np.arange(frames) / 30.0, quiet(STANDING, frames)) == slice(0, frames)


def test_bone_directions_are_unit_and_those_of_a_point_are_none():
    np.testing.assert_allclose(np.linalg.norm(bone_directions(PLAYER.joints(any_pose(PLAN, 1))), axis=1), 1.0)
    np.testing.assert_array_equal(bone_directions(np.zeros((20, 3))), 0.0)
