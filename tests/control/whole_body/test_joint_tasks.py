"""What joints and pelvis are asked for: zero where they are on target, back to it where they are not, never more than the limit."""

import numpy as np

from game import rotation
from game import rotation_compiled as one
from game.characters.skeleton import JOINT_COUNT, JOINTS
from game.control.whole_body.joint_tasks import (
    LARGEST_SPIN,
    LARGEST_SPIN_RATE,
    joint_accelerations,
    turn_acceleration,
    turn_error,
    way_back,
)
from tests.physics.standing import bent, idle_joints

REST, STILL = np.zeros(42), np.zeros((JOINT_COUNT, 3))
ENOUGH = np.full(42, 1e6)
ELBOW = JOINTS.index("elbow_left")


def asked(now, wanted, velocity=REST, spin=STILL, rate=STILL, limit=ENOUGH):
    return joint_accelerations(one.turns_to(now, wanted), velocity, spin, rate, 250.0, 28.0, limit)


def test_on_target_at_its_speed_a_joint_follows_the_target_s_own_acceleration():
    joints = bent(elbow_left=(0.1, -0.8, 0.2))
    spin, rate = np.full((JOINT_COUNT, 3), 2.0), np.full((JOINT_COUNT, 3), 30.0)
    np.testing.assert_allclose(asked(joints, joints, np.full(42, 2.0), spin, rate), 30.0, atol=1e-9)


def test_an_error_is_pulled_at_in_the_axes_of_the_child():
    joints, error = bent(elbow_left=(0.0, -1.0, 0.0)), np.array([0.05, -0.1, 0.02])
    wanted = joints.copy()
    wanted[ELBOW] = rotation.multiply(joints[ELBOW], rotation.exp(error))
    out = asked(joints, wanted).reshape(JOINT_COUNT, 3)
    np.testing.assert_allclose(out[ELBOW], 250.0 * error, atol=1e-9)
    assert not np.delete(out, ELBOW, axis=0).any()


def test_a_joint_that_moves_is_slowed_to_the_target_s_speed():
    velocity = np.zeros(42)
    velocity[5] = 3.0
    spin = STILL.copy()
    spin[1, 2] = 1.0
    out = asked(idle_joints(), idle_joints(), velocity, spin)
    assert out[5] == 28.0 * (1.0 - 3.0)
    assert not np.delete(out, 5).any()


def test_a_quaternion_and_its_negative_are_the_same_target():
    joints = bent(shoulder_left=(0.3, -0.5, 0.1))
    np.testing.assert_allclose(asked(idle_joints(), joints), asked(idle_joints(), -joints), atol=1e-12)


def test_no_axis_is_asked_for_more_than_its_limit():
    limit = np.linspace(1.0, 42.0, 42)
    joints = bent(hip_left=(1.0, -1.0, 1.0), shoulder_right=(-2.0, 1.0, 0.0))
    assert np.all(np.abs(asked(idle_joints(), joints, np.full(42, 9.0), limit=limit)) <= limit)


def test_what_no_body_does_in_the_target_is_taken_for_the_sensor():
    wild, calm = np.full((JOINT_COUNT, 3), 90.0), np.full((JOINT_COUNT, 3), LARGEST_SPIN)
    surge = np.full((JOINT_COUNT, 3), 9999.0)
    out = asked(idle_joints(), idle_joints(), REST, wild, surge)
    np.testing.assert_array_equal(out, asked(idle_joints(), idle_joints(), REST, calm, np.full_like(surge, LARGEST_SPIN_RATE)))


def test_a_pelvis_turns_towards_its_target_and_no_harder_than_allowed():
    now = rotation.exp(np.array([0.3, 0.2, -0.4]))
    error = np.array([0.0, 0.05, -0.1])
    wanted = rotation.multiply(now, rotation.exp(error))
    out = turn_acceleration(turn_error(now, wanted), np.zeros(3), np.zeros(3), 200.0, 26.0, 60.0)
    np.testing.assert_allclose(out, 200.0 * error, atol=1e-9)
    hard = turn_acceleration(turn_error(now, wanted), np.zeros(3), np.zeros(3), 200.0, 26.0, 5.0)
    np.testing.assert_allclose(hard, 5.0 * error / np.linalg.norm(error), atol=1e-9)


def test_a_pelvis_where_it_should_be_is_left_alone():
    now = rotation.exp(np.array([0.3, 0.2, -0.4]))
    spin = np.array([1.0, 2.0, 3.0])
    np.testing.assert_allclose(turn_acceleration(turn_error(now, now), spin, spin, 200.0, 26.0, 60.0), 0.0, atol=1e-9)


def test_the_way_back_from_the_target_is_none():
    joints, upright = bent(elbow_left=(0.1, -0.8, 0.2)), rotation.exp(np.array([0.1, 0.2, 0.3]))
    np.testing.assert_allclose(way_back(one.turns_to(joints, joints), turn_error(upright, -upright), 4.0, 2.0), np.zeros(48), atol=1e-12)


def test_the_way_back_is_the_error_a_second_at_its_rate_and_never_faster_than_allowed():
    joints, error = bent(elbow_left=(0.0, -1.0, 0.0)), np.array([0.05, -0.1, 0.9])
    wanted = joints.copy()
    wanted[ELBOW] = rotation.multiply(joints[ELBOW], rotation.exp(error))
    lean = np.array([0.2, -0.3, 0.0])
    way = way_back(one.turns_to(joints, wanted), turn_error(rotation.exp(np.zeros(3)), rotation.exp(lean)), 4.0, 2.0)
    np.testing.assert_allclose(way[:3], 0.0)
    np.testing.assert_allclose(way[3:6], 4.0 * lean, atol=1e-12)
    np.testing.assert_allclose(way[6:].reshape(JOINT_COUNT, 3)[ELBOW], [0.2, -0.4, 2.0], atol=1e-12)
