"""The bow of a step: how it swings out of the straight way, round the other leg or clear of the other foot."""

import math
from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Farthest(Enum):
    """When a bow is farthest from the straight way, as the powers of the time gone and of the time left that make it: at two fifths,
    half-way, at three fifths."""

    EARLY = (2, 3)
    HALF_WAY = (2, 2)
    LATE = (3, 2)


@dataclass(frozen=True, eq=False)
class Bow:
    """out (3,) m: where it is farthest from the straight way."""

    out: Floats
    farthest: Farthest = Farthest.HALF_WAY

    def motion(self, s: float) -> tuple[Floats, Floats, Floats]:
        """Place, and its first two derivatives (3,) by the share `s` of the time, from 0 to 1: at rest at both ends."""
        a, b = self.farthest.value
        left, scale = 1.0 - s, (a + b) ** (a + b) / (a**a * b**b)
        place = s**a * left**b
        rate = s ** (a - 1) * left ** (b - 1) * (a * left - b * s)
        surge = s ** (a - 2) * left ** (b - 2) * (a * (a - 1) * left * left - 2.0 * a * b * s * left + b * (b - 1) * s * s)
        return scale * place * self.out, scale * rate * self.out, scale * surge * self.out


def bow(yaw: float, ahead_m: float, left_m: float, farthest: Farthest = Farthest.HALF_WAY) -> Bow:
    """Of a step towards `yaw`, rad: so far ahead and to the left."""
    c, s = math.cos(yaw), math.sin(yaw)
    return Bow(np.array([c * ahead_m - s * left_m, s * ahead_m + c * left_m, 0.0]), farthest)


NO_BOW = Bow(np.zeros(3))
