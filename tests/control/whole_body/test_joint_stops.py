"""Ligaments: a body that keeps its balance is not held by them within its joints' ranges, and firmly past them."""

import numpy as np
import pytest

from game import rotation
from game.characters.joint_limits import HIGH, LOW, in_range_of
from game.characters.skeleton import JOINT_COUNT, JOINTS
from game.characters.strength import joint_strength
from game.control.whole_body.joint_stops import SLACK_RAD, STANDING_SOON_S, stopped
from tests.physics.standing import bent, original

STRENGTH = np.array(joint_strength(original()))
KNEE = 3 * JOINTS.index("knee_left") + 1
STRAIGHT = LOW.reshape(-1)[KNEE]
"""The most that a knee is bent back."""


def held(knee_rad: float, knee_rad_s: float = 0.0):
    """(rotation (14, 4), kp, speed, damping (42,)) of a body that plans to move every joint at 1 rad/s."""
    velocity, speed, damping = np.zeros(42), np.ones(42), np.full(42, 0.5)
    velocity[KNEE] = knee_rad_s
    rotations, kp = stopped(bent(knee_left=(0.0, knee_rad, 0.0)), velocity, STRENGTH, speed, damping)
    return rotations, kp, speed, damping


@pytest.mark.parametrize("knee_rad", [0.0, STRAIGHT, STRAIGHT - 0.9 * SLACK_RAD, HIGH.reshape(-1)[KNEE]])
def test_within_its_range_a_joint_is_left_to_its_plan(knee_rad):
    rotations, kp, speed, damping = held(knee_rad)
    assert not kp.any() and np.all(speed == 1.0) and np.all(damping == 0.5)
    np.testing.assert_array_equal(rotations, bent(knee_left=(0.0, knee_rad, 0.0)))


def test_past_it_the_joint_alone_is_pushed_back_and_braked():
    rotations, kp, speed, damping = held(STRAIGHT - 0.1)
    others = np.arange(42) != KNEE
    assert kp[KNEE] > 0.0 and speed[KNEE] == 0.0 and damping[KNEE] > 0.5
    assert not kp[others].any() and np.all(speed[others] == 1.0) and np.all(damping[others] == 0.5)
    assert rotation.log(rotations).reshape(-1)[KNEE] == pytest.approx(STRAIGHT - SLACK_RAD)


def test_a_joint_that_is_eleven_degrees_past_its_range_is_held_by_as_much_as_its_muscles():
    rotations, kp, _, _ = held(STRAIGHT - np.radians(11.0))
    back_nm = kp[KNEE] * (rotation.log(rotations).reshape(-1)[KNEE] - (STRAIGHT - np.radians(11.0)))
    assert back_nm > STRENGTH[1, KNEE]


def test_a_joint_that_flies_past_its_end_is_met_on_its_way():
    near = STRAIGHT - 0.5 * SLACK_RAD
    assert not held(near)[1].any()
    assert held(near, -2.0 * SLACK_RAD / STANDING_SOON_S)[1][KNEE] > 0.0


RAISED = (0.0, np.radians(-150.0), np.radians(-95.0))
"""Of the left shoulder: an arm over the head that is twisted 25 degrees past its range."""


def test_far_from_straight_a_joint_is_turned_back_the_shortest_way():
    pose, joint = bent(shoulder_left=RAISED), JOINTS.index("shoulder_left")
    speed, damping = np.ones(42), np.full(42, 0.5)
    rotations, kp = stopped(pose, np.zeros(42), STRENGTH, speed, damping)
    torque = kp.reshape(-1, 3)[joint] * rotation.log(rotation.multiply(rotation.conjugate(pose[joint]), rotations[joint]))
    angle = in_range_of(pose[joint], LOW[joint], HIGH[joint])
    inside = rotation.exp(np.clip(angle, LOW[joint] - SLACK_RAD, HIGH[joint] + SLACK_RAD))
    back = rotation.log(rotation.multiply(rotation.conjugate(pose[joint]), inside))
    np.testing.assert_allclose(torque / np.linalg.norm(torque), back / np.linalg.norm(back), atol=1e-9)
    assert np.argmax(np.abs(back)) != 2
    np.testing.assert_array_equal(np.delete(kp.reshape(-1, 3), joint, axis=0), 0.0)


def test_a_joint_still_within_its_range_is_only_braked():
    """A spring from where it will be would push before its time, and shake it."""
    pose = bent(knee_left=(0.0, STRAIGHT - 0.5 * SLACK_RAD, 0.0))
    rotations, kp, _, damping = held(STRAIGHT - 0.5 * SLACK_RAD, -2.0 * SLACK_RAD / STANDING_SOON_S)
    assert kp[KNEE] > 0.0 and damping[KNEE] > 0.5
    np.testing.assert_allclose(rotations, pose, atol=1e-12)


def test_a_mirrored_body_is_stopped_alike():
    left = held(STRAIGHT - 0.1)[1].reshape(JOINT_COUNT, 3)[JOINTS.index("knee_left")]
    speed, damping = np.ones(42), np.full(42, 0.5)
    _, kp = stopped(bent(knee_right=(0.0, STRAIGHT - 0.1, 0.0)), np.zeros(42), STRENGTH, speed, damping)
    np.testing.assert_allclose(kp.reshape(JOINT_COUNT, 3)[JOINTS.index("knee_right")], left)
