"""Pelvis and trunk tilt no faster than a person's: in a deep bow the sensor flips between a folded and a short upright body."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game import rotation_compiled as one
from game.compiled import compiled
from game.intake.gate_legs import HIPS
from kinect.body import Joint

Floats = NDArray[np.float64]

_SPINE, _NECK, _HIPS = int(Joint.SPINE), int(Joint.SHOULDER_CENTER), (int(HIPS[0]), int(HIPS[1]))
_ABOVE = [j for j in Joint if Joint.SHOULDER_CENTER <= j < Joint.HIP_LEFT]


class TrunkTilt:
    """Limits how fast pelvis (the spine over the hips) and trunk (the shoulder centre over the spine) of one player may swing.

    Their directions follow at the limit until they have caught up.
    """

    def __init__(self) -> None:
        self._last = np.full((2, 3), np.nan)

    def apply(self, joints: Floats, largest_rad: float) -> None:
        """Moves joints (20, 3), world frame, in place; largest_rad: how far either may swing since the last frame."""
        if _slow(joints, largest_rad, self._last):
            return
        middle = 0.5 * (joints[HIPS[0]] + joints[HIPS[1]])
        back = self._correction(0, joints[Joint.SPINE] - middle, largest_rad)
        if back is not None:
            moved = middle + rotation.rotate(back, joints[Joint.SPINE] - middle)
            joints[_ABOVE] += moved - joints[Joint.SPINE]
            joints[Joint.SPINE] = moved
        back = self._correction(1, joints[Joint.SHOULDER_CENTER] - joints[Joint.SPINE], largest_rad)
        if back is not None:
            joints[_ABOVE] = joints[Joint.SPINE] + rotation.rotate(back, joints[_ABOVE] - joints[Joint.SPINE])

    def _correction(self, which: int, vector: Floats, largest_rad: float) -> Floats | None:
        """The rotation (4,) that takes `vector` (3,) back to where it may be, at most `largest_rad` from the last one; None: as it is."""
        last = self._last[which].copy()
        length, direction, angle = _swung(vector, last)
        if length < 1e-6:
            return None
        self._last[which] = direction
        if angle <= largest_rad:
            return None
        swing = rotation.log(rotation.between(last, direction))
        allowed = rotation.rotate(rotation.exp(swing * (largest_rad / angle)), last)
        self._last[which] = allowed
        return rotation.between(direction, allowed)


@compiled
def _swung(vector: Floats, last: Floats) -> tuple[float, Floats, float]:
    """Length and direction (3,) of a vector (3,), and the angle (rad) from the direction `last` (3,), 0 where that is NaN."""
    length = one.length(vector)
    direction = vector / max(length, 1e-6)
    if math.isnan(last[0]):
        return length, direction, 0.0
    return length, direction, math.acos(min(1.0, max(-1.0, one.dot(last, direction))))


@compiled
def _slow(joints: Floats, largest_rad: float, last: Floats) -> bool:
    """True where neither direction has swung too fast; `last` (2, 3) then has them both."""
    pelvis = joints[_SPINE] - 0.5 * (joints[_HIPS[0]] + joints[_HIPS[1]])
    pelvis_length, pelvis_direction, pelvis_angle = _swung(pelvis, last[0])
    trunk_length, trunk_direction, trunk_angle = _swung(joints[_NECK] - joints[_SPINE], last[1])
    if pelvis_length < 1e-6 or trunk_length < 1e-6 or pelvis_angle > largest_rad or trunk_angle > largest_rad:
        return False
    last[0], last[1] = pelvis_direction, trunk_direction
    return True
