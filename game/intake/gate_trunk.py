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

_ABOVE = [j for j in Joint if Joint.SHOULDER_CENTER <= j < Joint.HIP_LEFT]


class TiltLimit:
    """Limits how fast a direction may swing; the direction follows at the limit until it has caught up."""

    def __init__(self) -> None:
        self._last: Floats | None = None

    def correction(self, vector: Floats, largest_rad: float) -> Floats | None:
        """The rotation (4,) that takes `vector` (3,) back to where it may be, at most `largest_rad` from the last one; None: as it is."""
        last = self._last
        length, direction, angle = _swung(vector, vector if last is None else last)
        if length < 1e-6:
            return None
        self._last = direction
        if last is None or angle <= largest_rad:
            return None
        swing = rotation.log(rotation.between(last, direction))
        allowed = rotation.rotate(rotation.exp(swing * (largest_rad / angle)), last)
        self._last = allowed
        return rotation.between(direction, allowed)


@compiled
def _swung(vector: Floats, last: Floats) -> tuple[float, Floats, float]:
    """Length and direction (3,) of a vector (3,), and the angle (rad) from the direction `last` (3,)."""
    length = one.length(vector)
    direction = vector / max(length, 1e-6)
    return length, direction, math.acos(min(1.0, max(-1.0, one.dot(last, direction))))


class TrunkTilt:
    """Both limits of one player: the pelvis by the spine over the hips, the trunk by the shoulder centre over the spine."""

    def __init__(self) -> None:
        self._pelvis, self._trunk = TiltLimit(), TiltLimit()

    def apply(self, joints: Floats, largest_rad: float) -> None:
        """Moves joints (20, 3), world frame, in place; largest_rad: how far either may swing since the last frame."""
        middle = 0.5 * (joints[HIPS[0]] + joints[HIPS[1]])
        back = self._pelvis.correction(joints[Joint.SPINE] - middle, largest_rad)
        if back is not None:
            moved = middle + rotation.rotate(back, joints[Joint.SPINE] - middle)
            joints[_ABOVE] += moved - joints[Joint.SPINE]
            joints[Joint.SPINE] = moved
        back = self._trunk.correction(joints[Joint.SHOULDER_CENTER] - joints[Joint.SPINE], largest_rad)
        if back is not None:
            joints[_ABOVE] = joints[Joint.SPINE] + rotation.rotate(back, joints[_ABOVE] - joints[Joint.SPINE])
