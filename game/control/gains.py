"""PD gains of every axis from one stiffness: the dynamic ratio of Eq. 3.8, or ratios fixed by hand (Zwennes 2014, 3.4.2)."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import JOINT_COUNT, JOINTS, LEG_JOINTS
from game.compiled import compiled
from game.control.joint_command import BodyState

Floats = NDArray[np.float64]

T0_KG_M = 10.0
"""t_0 of Eq. 3.8, the spine's x axis in the idle pose of the original character; fixed, so that gains compare across bodies."""

LEAST_RADIUS_SHARE = 0.3
"""An axis that points at the centre of mass (a twist) still counts this share of the distance as its radius."""

_IS_LEG = np.array([j in LEG_JOINTS for j in range(JOINT_COUNT)])

_MANUAL = {
    "spine": (1.0, 1.25, 0.5),
    "neck": (0.09, 0.09, 0.03),
    "shoulder": (0.27, 0.25, 0.08),
    "elbow": (0.09, 0.09, 0.03),
    "wrist": (0.012, 0.012, 0.004),
    "hip": (1.4, 1.1, 0.8),
    "knee": (4.4, 4.4, 2.0),
    "ankle": (8.2, 8.1, 2.5),
}
MANUAL_RATIO: Floats = np.array([_MANUAL[name.split("_")[0]] for name in JOINTS]).reshape(-1)
"""(42,) ratios tuned by hand to the original character's standing pose."""


def dynamic_ratio(state: BodyState) -> Floats:
    """(42,) t_i / t_0 = r_c m_c / t_0 of each axis in the child frame, Eq. 3.8.

    The parts an axis moves are those beyond the joint; for the legs, whose feet stand, all the rest of the body.
    """
    return _dynamic_ratio(state.subtree_mass, state.subtree_com, state.joint, state.turn)


@compiled
def _dynamic_ratio(subtree_mass: Floats, subtree_com: Floats, joint: Floats, turn: Floats) -> Floats:
    ratio, arm, to_com = np.empty(3 * JOINT_COUNT), np.empty(3), np.empty(3)
    total = subtree_mass[0]
    for j in range(JOINT_COUNT):
        part, mass = j + 1, subtree_mass[j + 1]
        rest = total - mass
        for axis in range(3):
            affected = subtree_com[part, axis]
            if _IS_LEG[j]:
                affected = (total * subtree_com[0, axis] - mass * affected) / rest
            to_com[axis] = affected - joint[part, axis]
        mass = rest if _IS_LEG[j] else mass
        for axis in range(3):
            arm[axis] = turn[part, 0, axis] * to_com[0] + turn[part, 1, axis] * to_com[1] + turn[part, 2, axis] * to_com[2]
        squared = one.dot(arm, arm)
        for axis in range(3):
            radius_squared = max(squared - arm[axis] * arm[axis], LEAST_RADIUS_SHARE * LEAST_RADIUS_SHARE * squared)
            ratio[3 * j + axis] = math.sqrt(radius_squared) * mass / T0_KG_M
    return ratio


def gains(state: BodyState, kp_hat: float, ratio: str) -> tuple[Floats, Floats]:
    """(kp, kd), (42,) each: kp = kp_hat times the ratio, kd = 2 sqrt(kp)."""
    return _gains(kp_hat, MANUAL_RATIO if ratio == "manual" else dynamic_ratio(state))


@compiled
def _gains(kp_hat: float, ratio: Floats) -> tuple[Floats, Floats]:
    kp, kd = np.empty(len(ratio)), np.empty(len(ratio))
    for row in range(len(ratio)):
        kp[row] = kp_hat * ratio[row]
        kd[row] = 2.0 * math.sqrt(kp[row])
    return kp, kd
