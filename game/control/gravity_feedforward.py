"""The joint torques that hold a standing body against gravity, so that the PD law need not sag to find them."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import ANKLES, FEET, JOINTS
from game.control.joint_command import BodyState

Floats = NDArray[np.float64]

_LEG_JOINTS = [JOINTS.index(name) for name in ("hip_left", "knee_left", "hip_right", "knee_right")]
_LEG_FEET = [FEET[0], FEET[0], FEET[1], FEET[1]]
_ANKLES = list(ANKLES)


def leg_moments(state: BodyState, left_force: Floats, right_force: Floats) -> Floats:
    """(4, 3) N m about left hip, left knee, right hip, right knee of forces (3,) N that the floor puts on the feet, world frame."""
    arm = state.box_centre[_LEG_FEET] - state.joint[1:][_LEG_JOINTS]
    return rotation.cross(arm, np.array((left_force, left_force, right_force, right_force)))


def gravity_torque(state: BodyState, left_share: float) -> Floats:
    """(42,) N m in the child frame; `left_share` of the weight stands on the left foot, the rest on the right.

    Static balance of the parts beyond each joint: their weight and, for the legs, the floor's push at the foot. The ankles
    are left to the balance strategy.
    """
    gravity = np.array([0.0, 0.0, -state.gravity])
    joint = state.joint[1:]
    moment = rotation.cross(state.subtree_com[1:] - joint, state.subtree_mass[1:, None] * gravity)
    weight = state.subtree_mass[0] * gravity
    moment[_LEG_JOINTS] -= leg_moments(state, left_share * weight, (1.0 - left_share) * weight)
    moment[_ANKLES] = 0.0
    return rotation.turn_back(state.turn[1:], -moment).reshape(-1)
