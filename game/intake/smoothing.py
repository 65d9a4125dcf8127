"""The Kinect SDK's joint filter: Holt's double exponential smoothing with jitter and deviation limits.

After the SDK's documented parameters and the filter it describes (M. Azimi, Skeletal Joint Smoothing White Paper, 2012).
"""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]

SMOOTHING, CORRECTION, PREDICTION = 0.5, 0.5, 0.5
JITTER_RADIUS_M, MAX_DEVIATION_M = 0.05, 0.04
"""The SDK's defaults, reached at strength 1."""


class JointSmoothing:
    """Filters joints (20, 3) frame by frame; strength 0 passes them through, 1 is the SDK's default, 2 twice as strong."""

    def __init__(self) -> None:
        self._filtered: Floats | None = None
        self._trend: Floats = np.zeros((20, 3))

    def apply(self, joints: Floats, strength: float) -> Floats:
        """The filtered joints, world or sensor frame, metres."""
        if self._filtered is None or strength <= 0.0:
            self._filtered, self._trend = joints, np.zeros_like(joints)
            return joints
        self._filtered, self._trend, smoothed = _smooth(joints, self._filtered, self._trend, strength)
        return smoothed


@compiled
def _smooth(joints: Floats, last: Floats, last_trend: Floats, strength: float) -> tuple[Floats, Floats, Floats]:
    """Filtered joints, their trend and the output, (20, 3) each, from the new joints, the last filtered ones and their trend."""
    smoothing = min(SMOOTHING * strength, 0.95)
    radius, limit = JITTER_RADIUS_M * strength, MAX_DEVIATION_M * strength
    filtered, trend, out = np.empty_like(joints), np.empty_like(joints), np.empty_like(joints)
    for j in range(len(joints)):
        # small moves are jitter: they are pulled towards the last output in proportion
        calm = min(1.0, _distance(joints[j], last[j]) / radius)
        for axis in range(3):
            before, slope = last[j, axis], last_trend[j, axis]
            now = (1.0 - smoothing) * (before + (joints[j, axis] - before) * calm) + smoothing * (before + slope)
            filtered[j, axis] = now
            trend[j, axis] = CORRECTION * (now - before) + (1.0 - CORRECTION) * slope
            out[j, axis] = now + PREDICTION * trend[j, axis]
        # the output may not stray from the sensor's word by more than the deviation limit
        share = min(1.0, limit / max(_distance(out[j], joints[j]), 1e-12))
        for axis in range(3):
            out[j, axis] = joints[j, axis] + (out[j, axis] - joints[j, axis]) * share
    return filtered, trend, out


@compiled
def _distance(a: Floats, b: Floats) -> float:
    """Between two points (3,)."""
    x, y, z = a[0] - b[0], a[1] - b[1], a[2] - b[2]
    return math.sqrt(x * x + y * y + z * z)
