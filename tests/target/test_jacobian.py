"""The Jacobian says how the end-effectors move when a joint turns: held against finite differences of the forward kinematics."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import END_EFFECTOR_PARTS, JOINTS, PARTS
from game.rotation import Floats
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from game.target.jacobian import end_effector_jacobian
from tests.target.players import any_pose, idle

PLAN = load_body_plan("original")
ROWS = [PARTS[part] for part in END_EFFECTOR_PARTS]


def turned(pose: PosedSkeleton, column: int, angle: float) -> Floats:
    """(15,) end-effector coordinates after one joint turned about one axis of its parent."""
    vectors = np.zeros((14, 3))
    vectors.flat[column] = angle
    rotations = rotation.multiply(rotation.exp(vectors), pose.joint_rotation)
    return pose_skeleton(PLAN, pose.joint[0], pose.root_orientation, rotations).joint[list(END_EFFECTOR_PARTS)].reshape(-1)


@pytest.mark.parametrize("pose", [idle(PLAN), *(any_pose(PLAN, seed, 0.8) for seed in range(4))], ids=["idle", "a", "b", "c", "d"])
def test_all_fifteen_by_42_entries_are_the_central_differences(pose):
    step = 1e-5
    differences = np.array([(turned(pose, k, step) - turned(pose, k, -step)) / (2.0 * step) for k in range(42)]).T
    jacobian = end_effector_jacobian(pose)
    assert jacobian.shape == (15, 42)
    np.testing.assert_allclose(jacobian, differences, atol=1e-9)
    assert np.abs(jacobian).max() > 0.3


def test_a_joint_moves_only_the_end_effectors_that_hang_on_it():
    jacobian = end_effector_jacobian(any_pose(PLAN, 9)).reshape(5, 3, 14, 3)
    moved = {(ROWS[e], JOINTS[j]) for e in range(5) for j in range(14) if np.any(jacobian[e, :, j])}
    arms = {(f"hand_{side}", joint) for side in ("left", "right") for joint in ("spine", f"shoulder_{side}", f"elbow_{side}")}
    legs = {(f"foot_{side}", f"{joint}_{side}") for side in ("left", "right") for joint in ("hip", "knee")}
    assert moved == arms | legs | {("head", "spine")}


def test_the_jacobian_turns_with_the_root_and_does_not_feel_its_place():
    pose = any_pose(PLAN, 10)
    turn = rotation.exp(np.array([0.3, -0.7, 1.9]))
    moved = pose_skeleton(PLAN, pose.joint[0] + [3.0, -2.0, 1.0], rotation.multiply(turn, pose.root_orientation), pose.joint_rotation)
    expected = np.einsum("ab,ebk->eak", rotation.matrix(turn), end_effector_jacobian(pose).reshape(5, 3, 42)).reshape(15, 42)
    np.testing.assert_allclose(end_effector_jacobian(moved), expected, atol=1e-12)
