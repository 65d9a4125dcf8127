"""Forward kinematics: rigid bones in a chain, and a centre of mass that follows them."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import JOINTS, PARENT, PARTS
from game.target.forward_kinematics import pose_skeleton
from tests.target.players import NO_TURN, any_pose, idle

PLAN = load_body_plan("asymmetric")


def test_no_turn_at_all_is_the_idle_pose():
    pose = idle(PLAN)
    np.testing.assert_allclose(pose.joint, PLAN.joint, atol=1e-12)
    np.testing.assert_allclose(pose.box_centres(PLAN), PLAN.centre, atol=1e-12)
    assert pose.centre_of_mass(PLAN)[2] == pytest.approx(PLAN.idle_com_height)


@pytest.mark.parametrize("seed", range(3))
def test_every_joint_is_at_its_parents_end_in_any_pose(seed):
    pose = any_pose(PLAN, seed, 1.0)
    for part in range(1, 15):
        parent = PARENT[part]
        np.testing.assert_allclose(pose.joint[part], pose.joint[parent] + pose.turn[parent] @ PLAN.joint_offset[part], atol=1e-12)
        np.testing.assert_allclose(pose.turn[part], pose.turn[parent] @ rotation.matrix(pose.joint_rotation[part - 1]), atol=1e-12)
    np.testing.assert_allclose(rotation.matrix(pose.orientation), pose.turn, atol=1e-12)


def test_a_raised_left_arm_points_forward():
    rotations = NO_TURN.copy()
    rotations[JOINTS.index("shoulder_left")] = rotation.exp(np.array([0.0, -np.pi / 2.0, 0.0]))
    pose = pose_skeleton(PLAN, PLAN.joint[0], rotation.IDENTITY, rotations)
    shoulder, wrist = PARTS.index("upper_arm_left"), PARTS.index("hand_left")
    length = PLAN.joint[shoulder, 2] - PLAN.joint[wrist, 2]
    np.testing.assert_allclose(pose.joint[wrist] - pose.joint[shoulder], [length, 0.0, 0.0], atol=1e-12)


def test_the_centre_of_mass_moves_and_turns_with_the_root():
    pose = any_pose(PLAN, 5)
    turn, shift = rotation.exp(np.array([0.2, 0.4, -1.0])), np.array([1.0, 2.0, 3.0])
    moved = pose_skeleton(PLAN, pose.joint[0] + shift, rotation.multiply(turn, pose.root_orientation), pose.joint_rotation)
    arm = rotation.rotate(turn, pose.centre_of_mass(PLAN) - pose.joint[0])
    np.testing.assert_allclose(moved.centre_of_mass(PLAN), pose.joint[0] + shift + arm, atol=1e-12)
