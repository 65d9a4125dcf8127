"""The Jacobian of the five end-effectors by joint rotations about the parents' axes (Eq. 3.1 of Zwennes 2014)."""

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import END_EFFECTOR_PARTS, JOINT_COUNT, PARENT, is_ancestor
from game.target.forward_kinematics import PosedSkeleton

Floats = NDArray[np.float64]

# joint j moves end-effector i when it lies strictly above the joint centre that i is
_CHAIN = np.array([[is_ancestor(j + 1, PARENT[part]) for j in range(JOINT_COUNT)] for part in END_EFFECTOR_PARTS])
_EFFECTOR, _JOINT = np.nonzero(_CHAIN)
_PARENT = np.array(PARENT)[_JOINT + 1]
_EFFECTOR_PART = np.array(END_EFFECTOR_PARTS)[_EFFECTOR]


def end_effector_jacobian(pose: PosedSkeleton) -> Floats:
    """(15, 42) metres per radian: rows x, y, z of each end-effector, world frame; columns x, y, z of each joint, parent's axes.

    Column v_j x (s_i - p_j), v_j the axis of the parent segment, p_j the joint centre, s_i the end-effector.
    """
    arm = pose.joint[_EFFECTOR_PART] - pose.joint[_JOINT + 1]
    axes = pose.turn[_PARENT]
    block = np.empty((len(_JOINT), 3, 3))
    # (v x arm) for the three columns v of each parent's orientation matrix at once
    block[:, 0, :] = axes[:, 1, :] * arm[:, 2, None] - axes[:, 2, :] * arm[:, 1, None]
    block[:, 1, :] = axes[:, 2, :] * arm[:, 0, None] - axes[:, 0, :] * arm[:, 2, None]
    block[:, 2, :] = axes[:, 0, :] * arm[:, 1, None] - axes[:, 1, :] * arm[:, 0, None]
    jacobian = np.zeros((len(END_EFFECTOR_PARTS), 3, JOINT_COUNT, 3))
    jacobian[_EFFECTOR, :, _JOINT, :] = block
    return jacobian.reshape(3 * len(END_EFFECTOR_PARTS), 3 * JOINT_COUNT)
