"""The pelvis as high as the legs that bear it reach: raised where a bow has sunk it, lowered where the sensor stretches the legs."""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.intake.gate_legs import HIPS, Leg
from game.intake.smooth_step import smooth_step
from kinect.body import Joint

Floats = NDArray[np.float64]

BENT_RAD = 0.5
"""A knee straighter than this hides a bow, one bent twice as much is a crouch."""

STOOP_M = 0.1
"""A shoulder centre this much lower than in standing begins a bow, one twice as low is one."""

STRETCH_SHARE = 0.02
"""Legs may seem this much too long before the pelvis is lowered."""

SETTLING_S = 0.08
"""How fast the correction follows what is needed."""

_PELVIS = np.array([Joint.HIP_CENTER, Joint.SPINE, *HIPS])
_UPPER = np.array([j for j in Joint if j < Joint.HIP_LEFT] + [Joint.HIP_LEFT, Joint.HIP_RIGHT])


def needed_rise(leg: Leg, ankle_rise_m: float, leg_m: float, stoop_m: float, slack_share: float) -> float:
    """How far the hip over a planted foot should go up (negative: down), metres; stoop_m: how low the shoulders have come.

    A shortage within the slack is noise; a bent knee is believed, since a crouch shortens the sight of a thigh too.
    """
    rise = leg.rise_m + ankle_rise_m
    if rise < 0.0:
        return min(0.0, rise + STRETCH_SHARE * leg_m)
    short = smooth_step((rise / leg_m - slack_share) / max(slack_share, 1e-3))
    straight = 1.0 - smooth_step(leg.bend_rad / BENT_RAD - 1.0)
    return short * straight * smooth_step(stoop_m / STOOP_M - 1.0) * rise


class PelvisHeight:
    """Moves the pelvis by what its legs need; shoulders, head and arms come along downward only, a bow leaves them where they are."""

    def __init__(self) -> None:
        self.rise_m = 0.0

    def apply(self, joints: Floats, dt: float, needed_m: float, most_m: float) -> None:
        """Moves joints (20, 3) in place towards `needed_m`, never up by more than `most_m`, where the legs are stretched."""
        self.rise_m += (1.0 - math.exp(-dt / SETTLING_S)) * (needed_m - self.rise_m)
        self.rise_m = min(self.rise_m, max(0.0, most_m))
        if self.rise_m != 0.0:
            _raise(joints, _PELVIS if self.rise_m > 0.0 else _UPPER, self.rise_m)


@compiled
def _raise(joints: Floats, which: NDArray[np.int64], rise_m: float) -> None:
    """Some of the joints (20, 3), in place."""
    for joint in which:
        joints[joint, 2] += rise_m
