"""The joint torques that hold a standing body against gravity, so that the PD law need not sag to find them."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import ANKLES, FEET, JOINT_COUNT, JOINTS
from game.control.joint_command import BodyState

Floats = NDArray[np.float64]

_LEFT_LEG = [j for j, name in enumerate(JOINTS) if name in ("hip_left", "knee_left")]
_RIGHT_LEG = [j for j, name in enumerate(JOINTS) if name in ("hip_right", "knee_right")]
_ANKLES = list(ANKLES)


def gravity_torque(state: BodyState, left_share: float) -> Floats:
    """(42,) N m in the child frame; `left_share` of the weight stands on the left foot, the rest on the right.

    Static balance of the parts beyond each joint: their weight and, for the legs, the floor's push at the foot. The ankles
    are left to the balance strategy.
    """
    gravity = np.array([0.0, 0.0, -state.gravity])
    joint = state.joint[1:]
    moment = rotation.cross(state.subtree_com[1:] - joint, state.subtree_mass[1:, None] * gravity)
    weight = state.subtree_mass[0] * gravity
    for leg, foot, share in ((_LEFT_LEG, FEET[0], left_share), (_RIGHT_LEG, FEET[1], 1.0 - left_share)):
        moment[leg] -= rotation.cross(state.box_centre[foot] - joint[leg], share * weight)
    moment[_ANKLES] = 0.0
    assert moment.shape == (JOINT_COUNT, 3)
    return rotation.turn_back(state.turn[1:], -moment).reshape(-1)
