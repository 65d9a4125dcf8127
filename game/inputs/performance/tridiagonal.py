"""Tridiagonal systems by parallel cyclic reduction, and the C2 cubic spline that rests on them."""

import numpy as np

from kinect.body import Floats


def solve_tridiagonal(lower: Floats, diagonal: Floats, upper: Floats, right: Floats) -> Floats:
    """x of A x = right for diagonally dominant A.

    lower, diagonal, upper: (N,), lower[0] and upper[-1] are ignored. right: (N, K). Returns (N, K).
    """
    a, b, c, d = lower.copy(), diagonal.copy(), upper.copy(), right.copy()
    a[0] = c[-1] = 0.0
    count, stride = len(b), 1
    while stride < count:
        up = np.zeros(count)
        down = np.zeros(count)
        up[stride:] = -a[stride:] / b[:-stride]
        down[:-stride] = -c[:-stride] / b[stride:]
        next_a, next_b, next_c, next_d = np.zeros(count), b.copy(), np.zeros(count), d.copy()
        next_b[stride:] += up[stride:] * c[:-stride]
        next_b[:-stride] += down[:-stride] * a[stride:]
        next_d[stride:] += up[stride:, None] * d[:-stride]
        next_d[:-stride] += down[:-stride, None] * d[stride:]
        next_a[stride:] = up[stride:] * a[:-stride]
        next_c[:-stride] = down[:-stride] * c[stride:]
        a, b, c, d = next_a, next_b, next_c, next_d
        stride *= 2
    return d / b[:, None]


class Spline:
    """A natural cubic spline through (N, K) values a fixed step apart, first one at time 0; held constant outside."""

    def __init__(self, values: Floats, step_s: float) -> None:
        self._values, self._step = values, step_s
        bend = np.zeros_like(values)
        inner = len(values) - 2
        right = 6.0 * (values[2:] - 2.0 * values[1:-1] + values[:-2]) / step_s**2
        bend[1:-1] = solve_tridiagonal(np.ones(inner), np.full(inner, 4.0), np.ones(inner), right)
        self._bend = bend

    def __call__(self, t: Floats) -> Floats:
        """(T, K) values at times t (T,), seconds."""
        place = np.clip(t / self._step, 0.0, len(self._values) - 1.0)
        left = np.minimum(place.astype(int), len(self._values) - 2)
        v = (place - left)[:, None]
        u = 1.0 - v
        straight = u * self._values[left] + v * self._values[left + 1]
        curved = (u**3 - u) * self._bend[left] + (v**3 - v) * self._bend[left + 1]
        return straight + curved * self._step**2 / 6.0
