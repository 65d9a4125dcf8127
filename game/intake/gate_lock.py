"""A planted foot keeps its place: sideways it drifts slowly with the sensor, and it stands on the floor, never in it."""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.intake.gate_legs import FOOT_JOINTS

Floats = NDArray[np.float64]

HEEL_M = 0.02
"""A planted ankle that rises by more than this over its toes is let up: the player stands on them."""


class FootLock:
    """Places ankle and toes of one foot. What the lock has changed fades away after the foot lifts, so nothing leaps."""

    def __init__(self, side: int) -> None:
        self._side = side
        self._down = False
        # ankle and toes: where they are held, and how far that is from where they are seen
        self._held, self._offset = np.zeros((2, 3)), np.zeros((2, 3))

    def lifted(self, joints: Floats, dt: float, fade_s: float, foot: Floats) -> None:
        """Fill ankle and toes (2, 3) of a foot off the floor, from joints (20, 3), world metres."""
        self._down = False
        _released(joints, self._side, math.exp(-dt / max(fade_s, 1e-3)), self._offset, foot)

    def planted(self, joints: Floats, dt: float, floor_m: float, foot: Floats, *, heel_m: float, drift_s: float, fade_s: float) -> None:
        """Fill ankle and toes (2, 3) of a foot on the floor. floor_m: height at which ankles rest; heel_m: how far the ankle has risen over
        the toes; drift_s: time constant of the drift, infinite where the sensor does not show the foot."""
        drift, fall = 1.0 - math.exp(-dt / max(drift_s, 1e-3)), 1.0 - math.exp(-dt / max(fade_s, 1e-3))
        wanted = floor_m + max(0.0, heel_m - HEEL_M)
        _kept(joints, self._side, not self._down, wanted, drift, fall, self._held, self._offset, foot)
        self._down = True


@compiled
def _released(joints: Floats, side: int, share: float, offset: Floats, foot: Floats) -> None:
    """Fill `foot` (2, 3) with the foot as it is seen in joints (20, 3), off by what is left of its offset (2, 3)."""
    for k in range(2):
        for axis in range(3):
            offset[k, axis] *= share
            foot[k, axis] = joints[FOOT_JOINTS[side, k], axis] + offset[k, axis]


@compiled
def _kept(
    joints: Floats, side: int, fresh: bool, ankle_m: float, drift: float, fall: float, held: Floats, offset: Floats, foot: Floats
) -> None:
    """Fill `foot` (2, 3) with where it is `held` (2, 3), at first where it is; it drifts to where it is seen in joints (20, 3), its ankle
    to the height `ankle_m`, by a share each; offset (2, 3): between the two."""
    for k in range(2):
        for axis in range(3):
            sensed = joints[FOOT_JOINTS[side, k], axis]
            if fresh:
                held[k, axis] = sensed + offset[k, axis]
            if k == 0 and axis == 2:
                held[k, axis] += fall * (ankle_m - held[k, axis])
            else:
                held[k, axis] += drift * (sensed - held[k, axis])
            offset[k, axis] = held[k, axis] - sensed
            foot[k, axis] = held[k, axis]
