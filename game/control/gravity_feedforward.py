"""The joint torques that hold a standing body against gravity, so that the PD law need not sag to find them."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET, JOINTS
from game.compiled import compiled
from game.control.joint_command import BodyState

Floats = NDArray[np.float64]

_ANKLE = np.array([name.startswith("ankle") for name in JOINTS])
_SIDE = np.array([1 if name == "hip_left" or name == "knee_left" else 2 if name in ("hip_right", "knee_right") else 0 for name in JOINTS])
_FOOT = np.array([0, FEET[0], FEET[1]])


def gravity_torque(state: BodyState, left_share: float) -> Floats:
    """(42,) N m in the child frame; `left_share` of the weight stands on the left foot, the rest on the right.

    Static balance of the parts beyond each joint: their weight and, for the legs, the floor's push at the foot. The ankles
    are left to the balance strategy.
    """
    return _gravity_torque(state.subtree_mass, state.subtree_com, state.joint, state.box_centre, state.turn, state.gravity, left_share)


@compiled
def _gravity_torque(
    subtree_mass: Floats, subtree_com: Floats, joint: Floats, box_centre: Floats, turn: Floats, gravity: float, left_share: float
) -> Floats:
    torque = np.zeros(3 * len(_SIDE))
    share = (0.0, left_share, 1.0 - left_share)
    for j in range(len(_SIDE)):
        if _ANKLE[j]:
            continue
        part = j + 1
        # (x, y, z) x (0, 0, weight) = (y weight, -x weight, 0)
        weight = -gravity * subtree_mass[part]
        roll = (subtree_com[part, 1] - joint[part, 1]) * weight
        pitch = -((subtree_com[part, 0] - joint[part, 0]) * weight)
        side = _SIDE[j]
        if side > 0:
            foot, weight = _FOOT[side], -gravity * subtree_mass[0] * share[side]
            roll -= (box_centre[foot, 1] - joint[part, 1]) * weight
            pitch += (box_centre[foot, 0] - joint[part, 0]) * weight
        for axis in range(3):
            torque[3 * j + axis] = -(turn[part, 0, axis] * roll + turn[part, 1, axis] * pitch)
    return torque


@compiled
def leg_torques(joint: Floats, box_centre: Floats, turn: Floats, left_force: Floats, right_force: Floats) -> Floats:
    """(42,) N m, child frames, of hips and knees that hold against forces (3,) N of the floor on the two feet: J^T F of each leg."""
    torque = np.zeros(3 * len(_SIDE))
    for j in range(len(_SIDE)):
        side = _SIDE[j]
        if side > 0:
            moment = one.cross(box_centre[_FOOT[side]] - joint[j + 1], left_force if side == 1 else right_force)
            torque[3 * j : 3 * j + 3] = -one.turn_back(turn[j + 1], moment)
    return torque
