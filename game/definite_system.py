"""Small symmetric positive definite systems of equations, solved in compiled code: for so few unknowns LAPACK is slower to call."""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]


@compiled
def solve_definite(a: Floats, x: Floats) -> None:
    """Turn x (n,) into the solution y of a y = x, a (n, n) symmetric and positive definite, by Cholesky; the lower triangle becomes L."""
    count = len(x)
    for i in range(count):
        for j in range(i + 1):
            total = a[i, j]
            for k in range(j):
                total -= a[i, k] * a[j, k]
            a[i, j] = math.sqrt(max(total, 1e-300)) if i == j else total / a[j, j]
        for k in range(i):
            x[i] -= a[i, k] * x[k]
        x[i] /= a[i, i]
    for i in range(count - 1, -1, -1):
        x[i] /= a[i, i]
        for k in range(i):
            x[k] -= a[i, k] * x[i]
