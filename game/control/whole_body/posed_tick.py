"""A control tick posed as one optimisation, in one compiled call: every task, what stays of them in the wrenches, and the free answer."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import DOF_COUNT, FEET, JOINT_COUNT
from game.compiled import compiled
from game.control.whole_body.free_answer import free_answer
from game.control.whole_body.hold_damping import hold
from game.control.whole_body.inverse_dynamics import eliminate
from game.control.whole_body.joint_limits import soft_limits
from game.control.whole_body.joint_tasks import joint_accelerations, turn_acceleration, turn_error, way_back
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
    """The tick's optimisation; names as in `torque_limits.Problem`. weight (42,) of the joint tasks; inertia (42,); firmness (42,) with
    which the joints may be held to their plan."""

    gradient: Floats
    lower: Floats
    response: Floats
    schur_inverse: Floats
    free: Floats
    jacobian: Floats
    weight: Floats
    inertia: Floats
    firmness: Floats


def room_for_posed() -> Posed:
    """Arrays to be filled; the Jacobian has rows for two soles."""
    dof, joints = DOF_COUNT, 3 * JOINT_COUNT
    shapes = (dof, (dof, dof), (6, dof), (6, 6), dof, (12, dof), joints, joints, joints)
    return Posed(*(np.zeros(shape) for shape in shapes))


class Outcome(NamedTuple):
    """What a tick comes to: the torques N m that the joints have left at their speed, least and largest, the torques that they are to
    have, damping N m s/rad and speed rad/s that hold them to the plan (42,); acceleration (48,), wrench (n,), momentum (3,)."""

    low: Floats
    high: Floats
    torque: Floats
    damping: Floats
    speed: Floats
    acceleration: Floats
    wrench: Floats
    momentum: Floats


@compiled
def pose(body: Body, wanted: Wanted, numbers: Numbers, strength: Floats, joint_weight: Floats) -> tuple[Posed, Floats, Floats, Floats]:
    """All tasks as one cost, accelerations eliminated; the torques left, least and largest (42,), and the momentum (3,).

    strength (2, 42): least and largest torque at rest; joint_weight (42,).
    """
    mass, velocity = body.mass, body.velocity
    low, high = limits_at(strength[0], strength[1], velocity[6:])
    weight, inertia = joint_weight.copy(), np.empty(3 * JOINT_COUNT)
    largest, firmness = np.empty(3 * JOINT_COUNT), np.empty(3 * JOINT_COUNT)
    for row in range(3 * JOINT_COUNT):
        inertia[row] = mass[6 + row, 6 + row]
        strongest = max(-strength[0, row], strength[1, row])
        largest[row] = LARGEST_SHARE * strongest / inertia[row]
        firmness[row] = numbers.hold * max(inertia[row] / numbers.dt, strongest / numbers.held_by_rad_s)
    error, root_error = one.turns_to(body.rotation, wanted.rotation), turn_error(body.orientation[0], wanted.upright)
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
    lower, response, schur_inverse, free = eliminate(hessian, mass, gradient)
    posed = Posed(gradient, lower, response, schur_inverse, free, jacobian[:count], weight, inertia, firmness)
    return posed, low, high, momentum


def pose_and_answer(
    body: Body, wanted: Wanted, numbers: Numbers, strength: Floats, joint_weight: Floats, price: Floats, cone: Floats, posed: Posed
) -> tuple[bool, Outcome]:
    """`pose`, and what the body does where no limit is in its way, which is told first: see `Answer.within`.

    Where one is, `posed` is filled, and the outcome's torque, damping and speed are still to be found within the limits.
    """
    # arrays made here and plain tuples: handing out arrays and taking tuples with names costs numba much more
    low, high, torque, damping, speed = np.empty((5, 3 * JOINT_COUNT))
    outcome = Outcome(low, high, torque, damping, speed, np.empty(DOF_COUNT), np.empty(len(price)), np.empty(3))
    within = _pose_and_answer(
        tuple(body), tuple(wanted), tuple(numbers), strength, joint_weight, price, cone, tuple(posed), tuple(outcome)
    )  # fmt: skip
    return within, outcome


@compiled
def _pose_and_answer(
    body_fields: tuple, wanted_fields: tuple, number_fields: tuple, strength: Floats, joint_weight: Floats, price: Floats, cone: Floats,
    posed_fields: tuple, outcome_fields: tuple,
) -> bool:  # fmt: skip
    body, numbers, out = Body(*body_fields), Numbers(*number_fields), Outcome(*outcome_fields)
    posed, low, high, momentum = pose(body, Wanted(*wanted_fields), numbers, strength, joint_weight)
    answer = free_answer(
        posed.free, body.mass, body.bias, posed.response, posed.schur_inverse, posed.jacobian, price, cone,
        numbers.planned * low, numbers.planned * high,
    )  # fmt: skip
    out.low[:], out.high[:], out.momentum[:] = low, high, momentum
    if answer.within:
        out.torque[:], out.acceleration[:], out.wrench[:] = answer.torque, answer.acceleration, answer.wrench
        hold(posed.firmness, answer.torque, low, high, body.velocity, answer.acceleration, numbers.dt, out.damping, out.speed)
    else:
        _fill(posed, Posed(*posed_fields))
    return answer.within


@compiled
def _fill(posed: Posed, out: Posed) -> None:
    """Copy the first into the arrays of the second."""
    out.gradient[:], out.lower[:], out.response[:], out.schur_inverse[:] = posed.gradient, posed.lower, posed.response, posed.schur_inverse
    out.free[:], out.jacobian[: len(posed.jacobian)] = posed.free, posed.jacobian
    out.weight[:], out.inertia[:], out.firmness[:] = posed.weight, posed.inertia, posed.firmness
