"""Where a sole is, how fast it moves, and how joint accelerations move it: Jacobian and velocity-product acceleration."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import DOF_COUNT, FEET, PARENT
from game.compiled import compiled

Floats = NDArray[np.float64]


def _chain(foot: int) -> list[int]:
    parts = [foot]
    while PARENT[parts[0]] > 0:
        parts.insert(0, PARENT[parts[0]])
    return parts


LEG_PARTS = np.array([_chain(foot) for foot in FEET])
"""(2, 3) thigh, shank, foot of the left and right leg."""


@compiled
def sole_jacobian(side: int, sole: Floats, joint: Floats, turn: Floats) -> Floats:
    """(6, 48): linear (world) and angular (world) velocity of the foot at the point `sole` (3,) for each degree of freedom.

    joint (15, 3) joint centres, turn (15, 3, 3) parts to world. Free root: linear in the world, angular in the root frame.
    """
    out = np.zeros((6, DOF_COUNT))
    for axis in range(3):
        out[axis, axis] = 1.0
    _columns(out, 3, sole - joint[0], turn[0])
    for part in LEG_PARTS[side]:
        _columns(out, 3 + 3 * part, sole - joint[part], turn[part])
    return out


@compiled
def _columns(out: Floats, first: int, arm: Floats, turn: Floats) -> None:
    for axis in range(3):
        column = np.ascontiguousarray(turn[:, axis])
        swept = one.cross(column, arm)
        for row in range(3):
            out[row, first + axis] = swept[row]
            out[3 + row, first + axis] = column[row]


@compiled
def sole_motions(left: Floats, right: Floats, joint: Floats, turn: Floats, velocity: Floats, twist: Floats, product: Floats) -> None:
    """Fill twist and product, (2, 6) each, with the `sole_motion` of the left and of the right sole."""
    twist[0], product[0] = sole_motion(0, left, joint, turn, velocity)
    twist[1], product[1] = sole_motion(1, right, joint, turn, velocity)


@compiled
def sole_motion(side: int, sole: Floats, joint: Floats, turn: Floats, velocity: Floats) -> tuple[Floats, Floats]:
    """Twist (6,) of the sole and its acceleration (6,) at zero generalised acceleration; linear, angular, world frame."""
    twist, bias = np.zeros(6), np.zeros(6)
    linear, spin, acceleration, spin_rate = twist[:3], twist[3:], bias[:3], bias[3:]
    arm, swept, relative = np.empty(3), np.empty(3), np.empty(3)
    linear[:] = velocity[:3]
    one.add_turned(spin, turn[0], velocity[3:6])
    last = 0
    for k in range(4):
        for axis in range(3):
            arm[axis] = (sole[axis] if k == 3 else joint[LEG_PARTS[side, k], axis]) - joint[last, axis]
        swept[:] = 0.0
        one.add_cross(swept, spin, arm)
        linear += swept
        one.add_cross(acceleration, spin_rate, arm)
        one.add_cross(acceleration, spin, swept)
        if k < 3:
            last = LEG_PARTS[side, k]
            relative[:] = 0.0
            one.add_turned(relative, turn[last], velocity[3 + 3 * last : 6 + 3 * last])
            one.add_cross(spin_rate, spin, relative)
            spin += relative
    return twist, bias
