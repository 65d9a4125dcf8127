"""The torques that keep within the strength of the joints: limits stand inside the optimisation, not behind it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import JOINT_COUNT
from game.compiled import compiled
from game.control.whole_body.contact_wrenches import solve_wrenches
from game.control.whole_body.inverse_dynamics import free_accelerations, motion_and_torque, torque_of_wrench, wrench_cost

Floats = NDArray[np.float64]

SLOW_RAD_S, FAST_RAD_S = 18.0, 28.0
"""Up to the first speed a joint has all its strength, at the second none to go faster."""

_LEG_ROWS = [np.array([3 * j + axis for j in legs for axis in range(3)]) for legs in ((8, 9, 10), (11, 12, 13))]
_HELD: dict[tuple[int, ...], NDArray[np.int64]] = {
    (): np.zeros(0, np.int64),
    (0,): _LEG_ROWS[0],
    (1,): _LEG_ROWS[1],
    (0, 1): np.concatenate(_LEG_ROWS),
}
_NO_ROWS = {count: np.zeros((0, 6 * count)) for count in range(3)}
_NONE = np.zeros(0)


@dataclass(frozen=True)
class Problem:
    """What a tick's optimisation is made of; names as in `inverse_dynamics`. standing: the feet that can push, in order."""

    gradient: Floats
    lower: Floats
    response: Floats
    schur_inverse: Floats
    free: Floats
    mass: Floats
    bias: Floats
    jacobian: Floats
    price: Floats
    cone: Floats
    standing: tuple[int, ...]


@compiled
def limits_at(low: Floats, high: Floats, velocity: Floats) -> tuple[Floats, Floats]:
    """Torques (42,) each that a joint of strength low and high (N m at rest) has left at a velocity (42,).

    A muscle that shortens fast has no force left, one that is stretched has all of it (Hill 1938).
    """
    low_left, high_left = np.empty(len(low)), np.empty(len(high))
    for i in range(len(low)):
        high_left[i] = high[i] * min(max((FAST_RAD_S - velocity[i]) / (FAST_RAD_S - SLOW_RAD_S), 0.0), 1.0)
        low_left[i] = low[i] * min(max((FAST_RAD_S + velocity[i]) / (FAST_RAD_S - SLOW_RAD_S), 0.0), 1.0)
    return low_left, high_left


def within_limits(problem: Problem, low: Floats, high: Floats, weight: Floats, inertia: Floats) -> tuple[Floats, Floats, Floats]:
    """Torques (42,), accelerations (48,) and wrenches (n,) that keep low <= torque <= high.

    Standing legs get rows of their own in the QP; every other joint asks for less, 1.1 times its excess over its inertia (42,),
    at most twice; weight (42,) of the joint tasks.
    """
    p = problem
    held = _HELD[p.standing]
    gradient, free = p.gradient, p.free
    for attempt in range(3):
        if attempt > 0:
            free = free_accelerations(p.lower, gradient)
        quadratic, linear, residual = wrench_cost(free, p.mass, p.bias, p.schur_inverse, p.jacobian, p.price)
        wrench = _NONE
        if p.standing:
            solved = solve_wrenches(quadratic, linear, p.cone, _NO_ROWS[len(p.standing)], _NONE, _NONE)
            wrench = solved if solved is not None else np.zeros(len(linear))
        moved = motion_and_torque(wrench, free, residual, p.response, p.schur_inverse, p.mass, p.bias, p.jacobian)
        broken = _broken(moved[1], low, high, held)
        if len(broken):
            rows = torque_of_wrench(broken, p.response, p.schur_inverse, p.mass, p.jacobian)
            rest = moved[1][broken] - rows @ wrench
            solved = solve_wrenches(quadratic, linear, p.cone, rows, low[broken] - rest, high[broken] - rest)
            if solved is not None:
                wrench = solved
                moved = motion_and_torque(wrench, free, residual, p.response, p.schur_inverse, p.mass, p.bias, p.jacobian)
        acceleration, torque = moved
        if attempt == 2 or not _ask_less(gradient, torque, low, high, weight, inertia, held):
            break
    return np.minimum(np.maximum(torque, low), high), acceleration, wrench


@compiled
def _broken(torque: Floats, low: Floats, high: Floats, held: NDArray[np.int64]) -> NDArray[np.int64]:
    """Those of the rows `held` that leave their limits."""
    out = np.empty(len(held), np.int64)
    count = 0
    for row in held:
        if torque[row] > high[row] or torque[row] < low[row]:
            out[count] = row
            count += 1
    return out[:count]


@compiled
def _ask_less(
    gradient: Floats, torque: Floats, low: Floats, high: Floats, weight: Floats, inertia: Floats, held: NDArray[np.int64]
) -> bool:
    """Lower the demand of every other row that leaves its limits; False where there is none."""
    found = False
    for row in range(3 * JOINT_COUNT):
        excess = max(torque[row] - high[row], 0.0) - max(low[row] - torque[row], 0.0)
        if excess == 0.0 or (held == row).any():
            continue
        gradient[6 + row] -= weight[row] * 1.1 * excess / inertia[row]
        found = True
    return found
