"""All tasks of a tick as one quadratic cost of the accelerations, and the Jacobian of the soles that can push."""

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import DOF_COUNT
from game.compiled import compiled
from game.control.whole_body.inverse_dynamics import add_full_tasks, add_task
from game.control.whole_body.leg_kinematics import sole_jacobian

Floats = NDArray[np.float64]

_LEAST = 1e-5
"""Weight of every acceleration, so that the cost is strictly convex."""


@compiled
def diagonal_tasks(joint_weight: Floats, joint_goal: Floats, pelvis_weight: float, pelvis_goal: Floats) -> tuple[Floats, Floats]:
    """Hessian (48, 48) and gradient (48,) of the tasks that ask single axes for accelerations."""
    hessian, gradient = np.zeros((DOF_COUNT, DOF_COUNT)), np.zeros(DOF_COUNT)
    for i in range(DOF_COUNT):
        hessian[i, i] = _LEAST
    for axis in range(3):
        hessian[3 + axis, 3 + axis] += pelvis_weight
        gradient[3 + axis] += pelvis_weight * pelvis_goal[axis]
    for row in range(len(joint_goal)):
        hessian[6 + row, 6 + row] += joint_weight[row]
        gradient[6 + row] += joint_weight[row] * joint_goal[row]
    return hessian, gradient


@compiled
def add_sole(
    hessian: Floats, gradient: Floats, side: int, sole: Floats, joint: Floats, turn: Floats, weight: Floats, goal: Floats
) -> Floats:
    """Add the task of one sole, goal (6,) less the velocity-product acceleration; gives its Jacobian (6, 48), world."""
    jacobian = sole_jacobian(side, sole, joint, turn)
    add_task(hessian, gradient, jacobian, weight, goal)
    return jacobian


@compiled
def wrench_rows(jacobian: Floats, foot_turn: Floats) -> Floats:
    """(6, 48) the Jacobian with its moments in the axes of the foot."""
    out = jacobian.copy()
    for axis in range(3):
        for column in range(DOF_COUNT):
            total = 0.0
            for k in range(3):
                total += foot_turn[k, axis] * jacobian[3 + k, column]
            out[3 + axis, column] = total
    return out


@compiled
def add_com(
    hessian: Floats, gradient: Floats, mass: Floats, bias: Floats, gravity: float, total_mass: float, weight: Floats, goal: Floats
) -> None:
    """Add the acceleration of the centre of mass: the first three rows of M qdd + h are the force on it, weight apart."""
    rows = mass[:3] / total_mass
    rest = bias[:3] / total_mass
    rest[2] -= gravity
    add_full_tasks(hessian, gradient, rows, weight, goal - rest)


@compiled
def add_spin(
    hessian: Floats, gradient: Floats, mass: Floats, bias: Floats, velocity: Floats, wanted_velocity: Floats,
    root_turn: Floats, arm: Floats, weight: float, rate: float,
) -> Floats:  # fmt: skip
    """Add the wish that angular momentum about the COM becomes that of `wanted_velocity` (48,) at `rate` (1/s); gives it (3,), world.

    arm (3,) from the root to the COM. Orin, Goswami & Lee 2013: the centroidal momentum from the root rows of M.
    """
    rows, rest = np.empty((3, DOF_COUNT)), np.empty(3)
    for axis in range(3):
        after, last = (axis + 1) % 3, (axis + 2) % 3
        r0, r1, r2, p, q = root_turn[axis, 0], root_turn[axis, 1], root_turn[axis, 2], arm[after], arm[last]
        for column in range(DOF_COUNT):
            turned = r0 * mass[3, column] + r1 * mass[4, column] + r2 * mass[5, column]
            rows[axis, column] = turned - p * mass[last, column] + q * mass[after, column]
        rest[axis] = r0 * bias[3] + r1 * bias[4] + r2 * bias[5] - p * bias[last] + q * bias[after]
    momentum, excess = np.zeros(3), np.zeros(3)
    for axis in range(3):
        for column in range(DOF_COUNT):
            momentum[axis] += rows[axis, column] * velocity[column]
            excess[axis] += rows[axis, column] * (velocity[column] - wanted_velocity[column])
    add_full_tasks(hessian, gradient, rows, np.full(3, weight), -rate * excess - rest)
    return momentum
