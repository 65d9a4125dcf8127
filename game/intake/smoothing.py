"""The Kinect SDK's joint filter: Holt's double exponential smoothing with jitter and deviation limits.

After the SDK's documented parameters and the filter it describes (M. Azimi, Skeletal Joint Smoothing White Paper, 2012).
"""

import numpy as np
from numpy.typing import NDArray

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
        smoothing = min(SMOOTHING * strength, 0.95)
        radius = JITTER_RADIUS_M * strength
        # small moves are jitter: they are pulled towards the last output in proportion
        move = joints - self._filtered
        distance = np.sqrt(np.sum(move * move, axis=1, keepdims=True))
        calm = self._filtered + move * np.minimum(1.0, distance / radius)
        filtered = (1.0 - smoothing) * calm + smoothing * (self._filtered + self._trend)
        trend = CORRECTION * (filtered - self._filtered) + (1.0 - CORRECTION) * self._trend
        predicted = filtered + PREDICTION * trend
        self._filtered, self._trend = filtered, trend
        # the output may not stray from the sensor's word by more than the deviation limit
        stray = predicted - joints
        length = np.sqrt(np.sum(stray * stray, axis=1, keepdims=True))
        return joints + stray * np.minimum(1.0, MAX_DEVIATION_M * strength / np.maximum(length, 1e-12))
