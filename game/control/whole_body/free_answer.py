"""The optimisation without its limits: where it keeps to them by itself, as it does in most ticks, it needs no QP solver."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.control.whole_body.inverse_dynamics import cholesky, motion_and_torque, solve_lower_both, wrench_cost

Floats = NDArray[np.float64]


class Answer(NamedTuple):
    """within: every wrench lies in its cone and every torque within its limits, so that it solves the limited problem too.

    torque (42,) N m, acceleration (48,), wrench (n,).
    """

    within: bool
    torque: Floats
    acceleration: Floats
    wrench: Floats


@compiled
def free_answer(
    free: Floats, mass: Floats, bias: Floats, response: Floats, schur_inverse: Floats, jacobian: Floats, price: Floats, cone: Floats,
    low: Floats, high: Floats,
) -> Answer:  # fmt: skip
    """Names as in `inverse_dynamics`; cone (k, n): rows that must not be positive; low, high (42,) N m."""
    quadratic, linear, residual = wrench_cost(free, mass, bias, schur_inverse, jacobian, price)
    wrench = solve_lower_both(cholesky(quadratic), -linear.reshape(1, -1))[0]
    acceleration, torque = motion_and_torque(wrench, free, residual, response, schur_inverse, mass, bias, jacobian)
    return Answer(in_cone(cone, wrench) and between(low, torque, high), torque, acceleration, wrench)


@compiled
def in_cone(cone: Floats, wrench: Floats) -> bool:
    """No row of cone (k, n) is positive."""
    for row in range(len(cone)):
        total = 0.0
        for n in range(len(wrench)):
            total += cone[row, n] * wrench[n]
        if not total <= 0.0:
            return False
    return True


@compiled
def between(low: Floats, values: Floats, high: Floats) -> bool:
    """Each of the values (n,) within its own limits."""
    for i in range(len(values)):  # noqa: SIM110 (a compiled loop)
        if not low[i] <= values[i] <= high[i]:
            return False
    return True
