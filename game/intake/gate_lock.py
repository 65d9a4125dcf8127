"""A planted foot keeps its place: sideways it drifts slowly with the sensor, and it stands on the floor, never in it."""

import math

import numpy as np
from numpy.typing import NDArray

from game.intake.gate_legs import ANKLES, FEET

Floats = NDArray[np.float64]

HEEL_M = 0.02
"""A planted ankle that rises by more than this over its toes is let up: the player stands on them."""


class FootLock:
    """Places ankle and toes of one foot. What the lock has changed fades away after the foot lifts, so nothing leaps."""

    def __init__(self, side: int) -> None:
        self._joints = [ANKLES[side], FEET[side]]
        self._held: Floats | None = None
        self._offset: Floats = np.zeros((2, 3))

    def lifted(self, joints: Floats, dt: float, fade_s: float) -> Floats:
        """(2, 3) ankle and toes of a foot off the floor, from joints (20, 3), world metres."""
        self._held = None
        self._offset = self._offset * math.exp(-dt / max(fade_s, 1e-3))
        return joints[self._joints] + self._offset

    def planted(self, joints: Floats, dt: float, floor_m: float, *, heel_m: float, drift_s: float, fade_s: float) -> Floats:
        """(2, 3) ankle and toes of a foot on the floor. floor_m: height at which ankles rest; heel_m: how far the ankle has risen over
        the toes; drift_s: time constant of the drift, infinite where the sensor does not show the foot."""
        sensed = joints[self._joints]
        if self._held is None:
            self._held = sensed + self._offset
        drift, fall = (1.0 - math.exp(-dt / max(time_s, 1e-3)) for time_s in (drift_s, fade_s))
        wanted = floor_m + max(0.0, heel_m - HEEL_M)
        height = self._held[0, 2] + fall * (wanted - self._held[0, 2])
        self._held = self._held + drift * (sensed - self._held)
        self._held[0, 2] = height
        self._offset = self._held - sensed
        return self._held.copy()
