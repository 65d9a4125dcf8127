"""The bow of a step: how it swings out of the straight way, round the other leg or clear of the other foot."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Bow:
    """out (3,) m: where it is farthest from the straight way; late: it is so at three fifths of the time, else half-way."""

    out: Floats
    late: bool = False

    def motion(self, s: float) -> tuple[Floats, Floats, Floats]:
        """Place, and its first two derivatives (3,) by the share `s` of the time, from 0 to 1: at rest at both ends."""
        rise, scale = (3, 3125.0 / 108.0) if self.late else (2, 16.0)
        left = 1.0 - s
        place = s**rise * left**2
        rate = s ** (rise - 1) * left * (rise * left - 2.0 * s)
        surge = s ** (rise - 2) * (rise * (rise - 1) * left * left - 4.0 * rise * s * left + 2.0 * s * s)
        return scale * place * self.out, scale * rate * self.out, scale * surge * self.out


def bow(yaw: float, ahead_m: float, left_m: float, late: bool = False) -> Bow:
    """Of a step towards `yaw`, rad: so far ahead and to the left."""
    c, s = math.cos(yaw), math.sin(yaw)
    return Bow(np.array([c * ahead_m - s * left_m, s * ahead_m + c * left_m, 0.0]), late)


STRAIGHT = Bow(np.zeros(3))
