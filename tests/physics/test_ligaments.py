"""Ligaments: nothing within a joint's range, firm past it, whoever commands the joint or nobody."""

import numpy as np
import pytest

from game import rotation
from game.characters.joint_limits import HIGH, LOW, in_range_of, joint_angles
from game.characters.skeleton import DOF_COUNT, JOINT_COUNT, JOINTS
from game.characters.strength import joint_strength
from game.physics import actuation
from game.physics.ligaments import FIRM_RAD, MUSCLES, SOON_S, add_ligaments
from tests.physics.standing import bent, original, run, unexplained, world_of

STRENGTH = np.array(joint_strength(original()))
STEP_S = 1.0 / 480.0
KNEE = 3 * JOINTS.index("knee_left") + 1
STRAIGHT = LOW.reshape(-1)[KNEE]
"""The most that a knee is bent back."""


def held(joints, velocity=None):
    """(torque, damping (42,)) of the ligaments alone."""
    torque, damping = np.zeros(42), np.zeros(42)
    low, high = STRENGTH
    add_ligaments(joints.reshape(-1), np.zeros(42) if velocity is None else velocity, low, high, STEP_S, torque, damping)
    return torque, damping


def knee(angle_rad):
    return bent(knee_left=(0.0, angle_rad, 0.0))


@pytest.mark.parametrize("knee_rad", [0.0, STRAIGHT + 1e-6, HIGH.reshape(-1)[KNEE] - 1e-6])
def test_within_its_range_a_joint_is_free(knee_rad):
    torque, damping = held(knee(knee_rad))
    assert not torque.any() and not damping.any()


def test_past_it_the_joint_alone_is_pushed_back_and_braked_and_the_farther_the_harder():
    near, damping = held(knee(STRAIGHT - 0.05))
    far = held(knee(STRAIGHT - 0.1))[0]
    others = np.arange(42) != KNEE
    assert near[KNEE] > 0.0 and damping[KNEE] > 0.0
    np.testing.assert_allclose(near[others], 0.0, atol=1e-9)
    assert far[KNEE] == pytest.approx(2.0 * near[KNEE])


def test_seven_degrees_past_its_range_a_joint_is_held_by_a_multiple_of_its_muscles():
    assert held(knee(STRAIGHT - FIRM_RAD))[0][KNEE] == pytest.approx(MUSCLES * STRENGTH[1, KNEE])


def test_a_joint_that_flies_past_its_end_is_braked_on_its_way_and_not_pushed_before_its_time():
    near, fast = knee(STRAIGHT + 0.01), np.zeros(42)
    assert not held(near)[1].any()
    fast[KNEE] = -0.02 / SOON_S
    torque, damping = held(near, fast)
    assert damping[KNEE] > 0.0 and not torque.any()


RAISED = (0.0, np.radians(-150.0), np.radians(-95.0))
"""Of the left shoulder: an arm over the head that is twisted 25 degrees past its range."""


def test_far_from_straight_a_joint_is_turned_back_the_shortest_way():
    pose, joint = bent(shoulder_left=RAISED), JOINTS.index("shoulder_left")
    torque = held(pose)[0].reshape(-1, 3)
    angle = in_range_of(pose[joint], LOW[joint], HIGH[joint])
    inside = rotation.exp(np.clip(angle, LOW[joint], HIGH[joint]))
    back = rotation.log(rotation.multiply(rotation.conjugate(pose[joint]), inside))
    np.testing.assert_allclose(torque[joint] / np.linalg.norm(torque[joint]), back / np.linalg.norm(back), atol=1e-9)
    assert np.argmax(np.abs(back)) != 2
    np.testing.assert_array_equal(np.delete(torque, joint, axis=0), 0.0)


def test_a_mirrored_body_is_held_alike():
    left = held(knee(STRAIGHT - 0.1))[0].reshape(JOINT_COUNT, 3)[JOINTS.index("knee_left")]
    right = held(bent(knee_right=(0.0, STRAIGHT - 0.1, 0.0)))[0].reshape(JOINT_COUNT, 3)[JOINTS.index("knee_right")]
    np.testing.assert_allclose(left, right, atol=1e-9)


def farthest_deg(joint_speed_rad_s: float) -> float:
    """How far past its range any joint of a limp body in the air gets whose shins swing forward."""
    world = world_of((0.0, 0.0, 5.0))
    for name in ("knee_left", "knee_right"):
        world.data.qvel[6 + 3 * JOINTS.index(name) + 1] = -joint_speed_rad_s
    world.meter.accept_state()
    past = 0.0
    for _ in range(120):
        run(world, 1, lambda *_: None)
        angles = joint_angles(world.characters[0].joint_rotation)
        past = max(past, float(np.maximum(LOW - angles, angles - HIGH).max()))
    assert max(unexplained(world)) < 1e-6
    return float(np.degrees(past))


def test_a_limp_limb_flung_at_the_end_of_its_range_stays_within_ten_degrees_of_it(monkeypatch):
    assert farthest_deg(20.0) < 10.0
    monkeypatch.setattr(actuation, "add_ligaments", lambda *_: None)
    monkeypatch.setattr(actuation, "write_torque", actuation.write_torque.py_func)
    assert farthest_deg(20.0) > 30.0, "without ligaments it flies on"


def test_what_the_ligaments_do_is_in_the_torque_that_is_told():
    world = world_of((0.0, 0.0, 5.0), joints=knee(STRAIGHT - 0.1))
    run(world, 1, lambda *_: None)
    assert world.actuation.torque[DOF_COUNT - 42 + KNEE] > 10.0


def test_the_explicit_law_does_without_them():
    world = world_of((0.0, 0.0, 5.0), joints=knee(STRAIGHT - 0.1), physics__integrator="explicit")
    run(world, 1, lambda *_: None)
    assert world.actuation.torque[DOF_COUNT - 42 + KNEE] == pytest.approx(0.0, abs=1e-9)
