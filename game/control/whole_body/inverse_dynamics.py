"""Joint accelerations, contact wrenches and torques that serve weighted tasks at once, in closed form but for the wrenches.

min 1/2 sum W |A qdd - b|^2 + 1/2 w' E w  subject to the six unactuated rows M_u qdd + h_u = J_u' w. With H = sum A' W A the
accelerations are qdd = H^-1 (g + M_u' l), so that only the wrenches w remain (twelve numbers at most) for the QP in
`contact_wrenches`; the torques follow as tau = M_a qdd + h_a - J_a' w. Inverse-dynamics QP: Abe, da Silva & Popovic 2007;
de Lasa, Mordatch & Hertzmann 2010.
"""

import math

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import DOF_COUNT
from game.compiled import compiled

Floats = NDArray[np.float64]

_ROOT_ROWS = 6
_SIDES = 8
_PANEL = 6
"""Columns that `cholesky` takes at a time; it unrolls them by hand, and all it is given are multiples."""


@compiled
def add_task(hessian: Floats, gradient: Floats, rows: Floats, weight: Floats, wanted: Floats) -> None:
    """Add 1/2 sum_i weight_i (rows_i qdd - wanted_i)^2 to the cost; rows (k, 48), lower triangle of hessian (48, 48) only."""
    used = np.empty(DOF_COUNT, np.int64)
    for task in range(len(rows)):
        row = rows[task]
        count = 0
        for i in range(DOF_COUNT):
            if row[i] != 0.0:
                used[count] = i
                count += 1
        for at in range(count):
            i = used[at]
            scaled = weight[task] * row[i]
            gradient[i] += scaled * wanted[task]
            for other in range(at + 1):
                hessian[i, used[other]] += scaled * row[used[other]]


@compiled
def add_full_tasks(hessian: Floats, gradient: Floats, rows: Floats, weight: Floats, wanted: Floats) -> None:
    """`add_task` of three tasks, rows (3, 48), that every degree of freedom serves."""
    for i in range(DOF_COUNT):
        a, b, c = weight[0] * rows[0, i], weight[1] * rows[1, i], weight[2] * rows[2, i]
        gradient[i] = gradient[i] + a * wanted[0] + b * wanted[1] + c * wanted[2]
        for j in range(i + 1):
            hessian[i, j] = hessian[i, j] + a * rows[0, j] + b * rows[1, j] + c * rows[2, j]


@compiled
def cholesky(a: Floats) -> Floats:
    """(n, n) lower triangular L with L L' = a; n a multiple of 6; only a's lower triangle is read.

    Six columns at a time: loops that vectorise.
    """
    count = len(a)
    out = np.zeros((count, count))
    column = np.empty((_PANEL, count))
    for i in range(count):
        for j in range(i + 1):
            out[i, j] = a[i, j]
    for first in range(0, count, _PANEL):
        last = min(first + _PANEL, count)
        for k in range(first, last):
            pivot = math.sqrt(max(out[k, k], 1e-300))
            out[k, k] = pivot
            for i in range(k + 1, count):
                scale = out[i, k] / pivot
                column[k - first, i] = scale
                out[i, k] = scale
                for j in range(k + 1, min(last, i + 1)):
                    out[i, j] -= scale * column[k - first, j]
        for i in range(last, count):
            p, q, r, s, t, u = column[0, i], column[1, i], column[2, i], column[3, i], column[4, i], column[5, i]
            for j in range(last, i + 1):
                less = out[i, j] - p * column[0, j] - q * column[1, j] - r * column[2, j]
                out[i, j] = less - s * column[3, j] - t * column[4, j] - u * column[5, j]
    return out


@compiled
def solve_lower_both(lower: Floats, right: Floats) -> Floats:
    """(m, n) rows x with L L' x = right, one right-hand side a row."""
    count = len(lower)
    out = np.empty((len(right), count))
    # several right-hand sides side by side, empty ones among them: an inner loop of fixed length vectorises
    x, one_x = np.empty((count, _SIDES)), np.empty(_SIDES)
    for first in range(0, len(right), _SIDES):
        sides = min(len(right) - first, _SIDES)
        x[:] = 0.0
        for side in range(sides):
            x[:, side] = right[first + side]
        for i in range(count):
            one_x[:] = x[i]
            for k in range(i):
                scale = lower[i, k]
                for side in range(_SIDES):
                    one_x[side] -= scale * x[k, side]
            for side in range(_SIDES):
                x[i, side] = one_x[side] / lower[i, i]
        for i in range(count - 1, -1, -1):
            for side in range(_SIDES):
                one_x[side] = x[i, side] / lower[i, i]
                x[i, side] = one_x[side]
            for k in range(i):
                scale = lower[i, k]
                for side in range(_SIDES):
                    x[k, side] -= scale * one_x[side]
        for side in range(sides):
            out[first + side] = x[:, side]
    return out


@compiled
def eliminate(hessian: Floats, mass: Floats, gradient: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """What stays when the accelerations are eliminated: L of H, (H^-1 M_u')' (6, 48), S^-1 (6, 6) of S = M_u H^-1 M_u', and H^-1 g (48,),
    the accelerations that would serve the tasks best on a body pushed from outside."""
    lower = cholesky(hessian)
    # the gradient costs nothing beside the six rows of M_u
    right = np.empty((_ROOT_ROWS + 1, DOF_COUNT))
    right[:_ROOT_ROWS], right[_ROOT_ROWS] = mass[:_ROOT_ROWS], gradient
    solved = solve_lower_both(lower, right)
    response = solved[:_ROOT_ROWS]
    schur = np.zeros((_ROOT_ROWS, _ROOT_ROWS))
    for k in range(DOF_COUNT):
        for i in range(_ROOT_ROWS):
            for j in range(_ROOT_ROWS):
                schur[i, j] += mass[i, k] * response[j, k]
    return lower, response, solve_lower_both(cholesky(schur), np.eye(_ROOT_ROWS)), solved[_ROOT_ROWS]


@compiled
def wrench_cost(
    free: Floats, mass: Floats, bias: Floats, schur_inverse: Floats, jacobian: Floats, price: Floats
) -> tuple[Floats, Floats, Floats]:
    """The QP in the wrenches, 1/2 w' Q w + f' w, and what the free accelerations (48,) leave of the six unactuated rows, (6,).

    jacobian (n, 48): one row a wrench component; price (n,): the diagonal of E.
    """
    count = len(jacobian)
    residual = bias[:_ROOT_ROWS].copy()
    for i in range(_ROOT_ROWS):
        for k in range(DOF_COUNT):
            residual[i] += mass[i, k] * free[k]
    reached = np.zeros((count, _ROOT_ROWS))
    for n in range(count):
        for i in range(_ROOT_ROWS):
            for j in range(_ROOT_ROWS):
                reached[n, i] += jacobian[n, j] * schur_inverse[j, i]
    quadratic, linear = np.zeros((count, count)), np.zeros(count)
    for n in range(count):
        for m in range(count):
            for i in range(_ROOT_ROWS):
                quadratic[n, m] += reached[n, i] * jacobian[m, i]
        quadratic[n, n] += price[n]
        for i in range(_ROOT_ROWS):
            linear[n] -= reached[n, i] * residual[i]
    return quadratic, linear, residual


@compiled
def free_accelerations(lower: Floats, gradient: Floats) -> Floats:
    """(48,) H^-1 g."""
    return solve_lower_both(lower, gradient.reshape(1, -1))[0]


@compiled
def motion_and_torque(
    wrench: Floats, free: Floats, residual: Floats, response: Floats, schur_inverse: Floats, mass: Floats, bias: Floats, jacobian: Floats
) -> tuple[Floats, Floats]:
    """Accelerations (48,) and joint torques (42,) N m of wrenches (n,)."""
    force = -residual
    for n in range(len(wrench)):
        for i in range(_ROOT_ROWS):
            force[i] += jacobian[n, i] * wrench[n]
    acceleration = free.copy()
    for i in range(_ROOT_ROWS):
        multiplier = 0.0
        for j in range(_ROOT_ROWS):
            multiplier += schur_inverse[i, j] * force[j]
        for k in range(DOF_COUNT):
            acceleration[k] += response[i, k] * multiplier
    torque = bias[_ROOT_ROWS:].copy()
    for row in range(DOF_COUNT - _ROOT_ROWS):
        for k in range(DOF_COUNT):
            torque[row] += mass[_ROOT_ROWS + row, k] * acceleration[k]
        for n in range(len(wrench)):
            torque[row] -= jacobian[n, _ROOT_ROWS + row] * wrench[n]
    return acceleration, torque


@compiled
def torque_of_wrench(rows: NDArray[np.int64], response: Floats, schur_inverse: Floats, mass: Floats, jacobian: Floats) -> Floats:
    """(k, n): how the torques of joint rows `rows` (k,) answer to the wrenches, accelerations included."""
    count = len(jacobian)
    out = np.zeros((len(rows), count))
    answer = np.zeros((DOF_COUNT, _ROOT_ROWS))
    for k in range(DOF_COUNT):
        for i in range(_ROOT_ROWS):
            for j in range(_ROOT_ROWS):
                answer[k, i] += response[j, k] * schur_inverse[j, i]
    for at in range(len(rows)):
        row = _ROOT_ROWS + rows[at]
        for i in range(_ROOT_ROWS):
            moved = 0.0
            for k in range(DOF_COUNT):
                moved += mass[row, k] * answer[k, i]
            for n in range(count):
                out[at, n] += moved * jacobian[n, i]
        for n in range(count):
            out[at, n] -= jacobian[n, row]
    return out
