"""PD gains of every axis from one stiffness: the dynamic ratio of Eq. 3.8, or ratios fixed by hand (Zwennes 2014, 3.4.2)."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import JOINTS, LEG_JOINTS
from game.control.joint_command import BodyState

Floats = NDArray[np.float64]

T0_KG_M = 10.0
"""t_0 of Eq. 3.8, the spine's x axis in the idle pose of the original character; fixed, so that gains compare across bodies."""

LEAST_RADIUS_SHARE = 0.3
"""An axis that points at the centre of mass (a twist) still counts this share of the distance as its radius."""

_LEGS = list(LEG_JOINTS)

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
    mass = state.subtree_mass[1:].copy()
    total = state.subtree_mass[0]
    affected = state.subtree_com[1:].copy()
    moment = total * state.subtree_com[0] - mass[_LEGS, None] * affected[_LEGS]
    mass[_LEGS] = total - mass[_LEGS]
    affected[_LEGS] = moment / mass[_LEGS, None]
    arm = rotation.turn_back(state.turn[1:], affected - state.joint[1:])
    squared = arm * arm
    length_squared = squared.sum(axis=1, keepdims=True)
    radius = np.sqrt(np.maximum(length_squared - squared, LEAST_RADIUS_SHARE**2 * length_squared))
    return (radius * mass[:, None]).reshape(-1) / T0_KG_M


def gains(state: BodyState, kp_hat: float, ratio: str) -> tuple[Floats, Floats]:
    """(kp, kd), (42,) each: kp = kp_hat times the ratio, kd = 2 sqrt(kp)."""
    kp = kp_hat * (MANUAL_RATIO if ratio == "manual" else dynamic_ratio(state))
    return kp, 2.0 * np.sqrt(kp)
