"""The wrenches of the standing soles: friction, centre of pressure, twist and torque limits as rows, solved by DAQP.

A wrench is (fx, fy, fz) in the world and (mx, my, mz) in the axes of the sole, at the sole's centre. DAQP: Arnstrom, Bemporad &
Axehill 2022, a dual active-set solver for small dense problems.
"""

import math

import daqp
import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]

CONE_ROWS = 17
_OPEN = -1e30


@compiled
def cone_rows(yaws: tuple[float, ...], friction: float, half_length: float, half_width: float) -> Floats:
    """(17 n, 6 n): rows that must not be positive for n soles that face `yaws` (rad): what forces at their corners can make.

    Unilateral, friction pyramid, pressure inside the sole; and what twists it, whose limits shrink to nothing where the pressure
    comes to a corner (Caron, Pham & Nakamura 2015, with the largest square in the friction circle).
    """
    count = len(yaws)
    square = math.sqrt(0.5) * friction
    out = np.zeros((CONE_ROWS * count, 6 * count))
    for foot in range(count):
        first, column = CONE_ROWS * foot, 6 * foot
        out[first, column + 2] = -1.0
        row = first + 1
        for sx in (-1.0, 1.0):
            for sy in (-1.0, 1.0):
                out[row, column], out[row, column + 1], out[row, column + 2] = sx, sy, -friction
                row += 1
        reach = (half_width, half_length)
        for axis in range(2):
            for sign in (-1.0, 1.0):
                out[row, column + 3 + axis], out[row, column + 2] = sign, -reach[axis]
                row += 1
        c, s = math.cos(yaws[foot]), math.sin(yaws[foot])
        for sign in (-1.0, 1.0):
            for sx in (-1.0, 1.0):
                for sy in (-1.0, 1.0):
                    # forces along the sole and across it, from the world's
                    along, across = sx * half_width, sy * half_length
                    out[row, column], out[row, column + 1] = along * c - across * s, along * s + across * c
                    out[row, column + 2] = -square * (half_length + half_width)
                    out[row, column + 3], out[row, column + 4] = sign * sx * square, sign * sy * square
                    out[row, column + 5] = sign
                    row += 1
    return out


def solve_wrenches(quadratic: Floats, linear: Floats, cone: Floats, limited: Floats, low: Floats, high: Floats) -> Floats | None:
    """(n,) wrenches, or None where no wrench meets every row.

    cone (k, n) rows <= 0; limited (m, n) rows between low (m,) and high (m,).
    """
    rows = np.concatenate((cone, limited))
    upper = np.concatenate((np.zeros(len(cone)), high))
    lower = np.concatenate((np.full(len(cone), _OPEN), low))
    wrench, _, flag, _ = daqp.solve(quadratic, linear, rows, upper, lower)
    return wrench if flag > 0 else None
