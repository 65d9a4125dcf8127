"""A control tick posed as one optimisation, in one compiled call: every task, what stays of them in the wrenches, and the free answer."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import DOF_COUNT, FEET, JOINT_COUNT
from game.compiled import compiled
from game.control.whole_body.free_answer import Answer, free_answer
from game.control.whole_body.inverse_dynamics import eliminate
from game.control.whole_body.joint_limits import soft_limits
from game.control.whole_body.joint_tasks import joint_accelerations, joint_errors, turn_acceleration, turn_error, way_back
from game.control.whole_body.task_stack import add_com, add_sole, add_spin, diagonal_tasks, wrench_rows
from game.control.whole_body.torque_limits import limits_at

Floats = NDArray[np.float64]

LARGEST_SHARE = 0.7
"""Of what a joint's strength could do to its own inertia: no task asks for more."""

ROOT_STIFFNESS, ROOT_DAMPING, LARGEST_ROOT = 200.0, 26.0, 60.0
"""1/s^2, 1/s, rad/s^2: of the pelvis's orientation."""


class Body(NamedTuple):
    """The character as it is: mass (48, 48), bias (48,), velocity (48,), rotation (14, 4), orientation (15, 4), turn (15, 3, 3),
    joint (15, 3), com (3,), total_mass kg, gravity m/s^2."""

    mass: Floats
    bias: Floats
    velocity: Floats
    rotation: Floats
    orientation: Floats
    turn: Floats
    joint: Floats
    com: Floats
    total_mass: float
    gravity: float


class Wanted(NamedTuple):
    """What is asked of it: rotation (14, 4), spin and spin_rate (17, 3) of the target, upright (4,) of the pelvis; of each sole its centre
    (3,), and, two rows, weight, goal and velocity-product acceleration (2, 6); pushes: which soles may; com_goal, com_weight (3,)."""

    rotation: Floats
    spin: Floats
    spin_rate: Floats
    upright: Floats
    centre: tuple[Floats, Floats]
    weight: Floats
    goal: Floats
    product: Floats
    pushes: tuple[bool, bool]
    com_goal: Floats
    com_weight: Floats


class Numbers(NamedTuple):
    """The tunables of a tick, as they are called in `game.tunables`; planned: share of the strength that is planned with."""

    pose_stiffness: float
    pose_damping: float
    pelvis_weight: float
    spin_weight: float
    spin_rate: float
    back_rate: float
    largest_back: float
    hold: float
    planned: float
    held_by_rad_s: float
    dt: float


class Posed(NamedTuple):
    """The tick's optimisation; names as in `torque_limits.Problem`. low, high: torques (42,) N m left at this speed; weight (42,) of the
    joint tasks; inertia, firmness (42,); momentum (3,)."""

    gradient: Floats
    lower: Floats
    response: Floats
    schur_inverse: Floats
    jacobian: Floats
    low: Floats
    high: Floats
    weight: Floats
    inertia: Floats
    firmness: Floats
    momentum: Floats


@compiled
def pose(body: Body, wanted: Wanted, numbers: Numbers, strength: Floats, joint_weight: Floats) -> Posed:
    """All tasks as one cost, accelerations eliminated. strength (2, 42): least and largest torque at rest; joint_weight (42,)."""
    mass, velocity = body.mass, body.velocity
    low, high = limits_at(strength[0], strength[1], velocity[6:])
    weight, inertia = joint_weight.copy(), np.empty(3 * JOINT_COUNT)
    largest, firmness = np.empty(3 * JOINT_COUNT), np.empty(3 * JOINT_COUNT)
    for row in range(3 * JOINT_COUNT):
        inertia[row] = mass[6 + row, 6 + row]
        strongest = max(-strength[0, row], strength[1, row])
        largest[row] = LARGEST_SHARE * strongest / inertia[row]
        firmness[row] = numbers.hold * max(inertia[row] / numbers.dt, strongest / numbers.held_by_rad_s)
    error, root_error = joint_errors(body.rotation, wanted.rotation), turn_error(body.orientation[0], wanted.upright)
    goal = joint_accelerations(error, velocity[6:], wanted.spin, wanted.spin_rate, numbers.pose_stiffness, numbers.pose_damping, largest)
    soft_limits(body.rotation, velocity[6:], weight, goal)
    root = turn_acceleration(root_error, velocity[3:6], wanted.spin[JOINT_COUNT], ROOT_STIFFNESS, ROOT_DAMPING, LARGEST_ROOT)
    hessian, gradient = diagonal_tasks(weight, goal, numbers.pelvis_weight, root)
    jacobian = np.empty((12, DOF_COUNT))
    count = 0
    for side in range(2):
        asked = wanted.goal[side] - wanted.product[side]
        of_sole = add_sole(hessian, gradient, side, wanted.centre[side], body.joint, body.turn, wanted.weight[side], asked)
        if wanted.pushes[side]:
            jacobian[count : count + 6] = wrench_rows(of_sole, body.turn[FEET[side]])
            count += 6
    if count > 0:
        add_com(hessian, gradient, mass, body.bias, body.gravity, body.total_mass, wanted.com_weight, wanted.com_goal)
    arm = body.com - body.joint[0]
    way = way_back(error, root_error, numbers.back_rate, numbers.largest_back)
    momentum = add_spin(hessian, gradient, mass, body.bias, velocity, way, body.turn[0], arm, numbers.spin_weight, numbers.spin_rate)
    lower, response, schur_inverse = eliminate(hessian, mass)
    return Posed(gradient, lower, response, schur_inverse, jacobian[:count], low, high, weight, inertia, firmness, momentum)


def pose_and_answer(
    body: Body, wanted: Wanted, numbers: Numbers, strength: Floats, joint_weight: Floats, price: Floats, cone: Floats
) -> tuple[Posed, Answer]:
    """`pose`, and what the body would do were no limit in the way: see `Answer.within`."""
    # numba takes a plain tuple much faster than one with names
    return _pose_and_answer(tuple(body), tuple(wanted), tuple(numbers), strength, joint_weight, price, cone)


@compiled
def _pose_and_answer(
    body_fields: tuple, wanted_fields: tuple, number_fields: tuple, strength: Floats, joint_weight: Floats, price: Floats, cone: Floats
) -> tuple[Posed, Answer]:
    body, numbers = Body(*body_fields), Numbers(*number_fields)
    posed = pose(body, Wanted(*wanted_fields), numbers, strength, joint_weight)
    answer = free_answer(
        posed.gradient, posed.lower, body.mass, body.bias, posed.response, posed.schur_inverse, posed.jacobian, price, cone,
        numbers.planned * posed.low, numbers.planned * posed.high,
    )  # fmt: skip
    return posed, answer
