"""The wrenches of the standing soles: friction, centre of pressure and torque limits as rows, solved by DAQP.

A wrench is (fx, fy, fz) in the world and (mx, my, mz) in the axes of the sole, at the sole's centre. DAQP: Arnstrom, Bemporad &
Axehill 2022, a dual active-set solver for small dense problems.
"""

import daqp
import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]

CONE_ROWS = 11
_OPEN = -1e30


@compiled
def cone_rows(count: int, friction: float, half_length: float, half_width: float, twist_m: float) -> Floats:
    """(11 n, 6 n): rows that must not be positive for n soles: unilateral, friction pyramid, pressure inside the sole, twist."""
    out = np.zeros((CONE_ROWS * count, 6 * count))
    for foot in range(count):
        first, column = CONE_ROWS * foot, 6 * foot
        out[first, column + 2] = -1.0
        row = first + 1
        for sx in (-1.0, 1.0):
            for sy in (-1.0, 1.0):
                out[row, column], out[row, column + 1], out[row, column + 2] = sx, sy, -friction
                row += 1
        reach = (half_width, half_length, twist_m)
        for axis in range(3):
            for sign in (-1.0, 1.0):
                out[row, column + 3 + axis], out[row, column + 2] = sign, -reach[axis]
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
