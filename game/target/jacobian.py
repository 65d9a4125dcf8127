"""The Jacobian of the five end-effectors by joint rotations about the parents' axes (Eq. 3.1 of Zwennes 2014)."""

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import END_EFFECTOR_PARTS, JOINT_COUNT, PARENT
from game.compiled import compiled
from game.target.forward_kinematics import PosedSkeleton

Floats = NDArray[np.float64]

_EFFECTOR_PART = np.array(END_EFFECTOR_PARTS)
_PARENT = np.array(PARENT)


def end_effector_jacobian(pose: PosedSkeleton) -> Floats:
    """(15, 42) metres per radian: rows x, y, z of each end-effector, world frame; columns x, y, z of each joint, parent's axes.

    Column v_j x (s_i - p_j), v_j the axis of the parent segment, p_j the joint centre, s_i the end-effector; only joints between
    the end-effector and the root move it.
    """
    return jacobian_of(pose.turn, pose.joint)


@compiled
def jacobian_of(turn: Floats, joint: Floats) -> Floats:
    """The same of turn (15, 3, 3) and joint (15, 3)."""
    jacobian = np.zeros((3 * len(_EFFECTOR_PART), 3 * JOINT_COUNT))
    for i in range(len(_EFFECTOR_PART)):
        effector = _EFFECTOR_PART[i]
        # the effector is its own part's joint centre, which that part's rotation does not move
        part = _PARENT[effector]
        while part > 0:
            x, y, z = joint[effector] - joint[part]
            axes = turn[_PARENT[part]]
            for axis in range(3):
                column = 3 * (part - 1) + axis
                # axis x arm
                jacobian[3 * i, column] = axes[1, axis] * z - axes[2, axis] * y
                jacobian[3 * i + 1, column] = axes[2, axis] * x - axes[0, axis] * z
                jacobian[3 * i + 2, column] = axes[0, axis] * y - axes[1, axis] * x
            part = _PARENT[part]
    return jacobian
