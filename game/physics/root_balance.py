"""The compiled sums of the honesty meter: what of a root's momentum do contacts explain, and do the contacts keep to their cones?"""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import PART_COUNT
from game.compiled import compiled

Floats = NDArray[np.float64]
Indices = NDArray[np.int32]


@compiled
def root_momentum_change(
    mass: Floats, mass_count: Indices, mass_start: Indices, mass_column: Indices, after: Floats, before: Floats,
    first_rows: NDArray[np.int64], out: Floats,
) -> None:  # fmt: skip
    """Write into `out`, (characters, 6), the root rows of M (after - before), velocities (nv,).

    M as MuJoCo keeps it: of each row what lies on and left of the diagonal, `mass_count` numbers from `mass_start` on, in columns
    `mass_column`; a character's root comes first in all of its rows.
    """
    out[:] = 0.0
    rows = len(after) // len(first_rows)
    for character in range(len(first_rows)):
        first = first_rows[character]
        for row in range(first, first + rows):
            change = after[row] - before[row]
            start = mass_start[row]
            for at in range(start, start + min(mass_count[row], 6)):
                column = mass_column[at]
                out[character, column - first] += mass[at] * change
                if column != row and row < first + 6:
                    out[character, row - first] += mass[at] * (after[column] - before[column])


@compiled
def root_balance(
    residual: Floats, step_s: float, bias: Floats, first_rows: NDArray[np.int64], root_place: Floats, root_turn: Floats, count: int,
    point: Floats, frame: Floats, friction: Floats, geom: Indices, owner: Indices, wrench: Floats, pairs: NDArray[np.bool_],
) -> float:  # fmt: skip
    """Turn `residual`, (characters, 6), from M dv into what nothing explains in the root rows: M dv / h + c minus the contact forces.

    Notes in `pairs`, (bodies, bodies), who touched whom; returns how far the worst contact leaves its friction cone, N.
    root_place (characters, 3), root_turn (characters, 9); of the contacts, `count` of them: point (n, 3), frame (n, 9),
    friction (n, 5), geom (n, 2), wrench (n or more, 6); owner (geoms,): the body of each geom.
    """
    for character in range(len(first_rows)):
        first = first_rows[character]
        for row in range(6):
            residual[character, row] = residual[character, row] / step_s + bias[first + row]
    force, torque, arm = np.empty(3), np.empty(3), np.empty(3)
    for i in range(count):
        pairs[owner[geom[i, 0]], owner[geom[i, 1]]] = True
        for axis in range(3):
            force[axis] = frame[i, axis] * wrench[i, 0] + frame[i, 3 + axis] * wrench[i, 1] + frame[i, 6 + axis] * wrench[i, 2]
        for side in range(2):
            body = owner[geom[i, side]]
            if body == 0:
                continue
            character = (body - 1) // PART_COUNT
            sign = 1.0 if side == 1 else -1.0
            for axis in range(3):
                arm[axis] = point[i, axis] - root_place[character, axis]
            torque[:] = one.cross(arm, force)
            turn = root_turn[character]
            for axis in range(3):
                residual[character, axis] -= sign * force[axis]
                in_root = turn[axis] * torque[0] + turn[3 + axis] * torque[1] + turn[6 + axis] * torque[2]
                residual[character, 3 + axis] -= sign * in_root
    return cone_excess(wrench[:count], friction)


@compiled
def cone_excess(wrench: Floats, friction: Floats) -> float:
    """N, how far the worst contact leaves the friction cone: negative normal force, or tangential force beyond mu N."""
    worst = -np.inf
    for i in range(len(wrench)):
        tangential = math.sqrt(wrench[i, 1] * wrench[i, 1] + wrench[i, 2] * wrench[i, 2])
        worst = max(worst, -wrench[i, 0], tangential - friction[i, 0] * wrench[i, 0])
    return worst


@compiled
def keep_largest(residual: Floats, force: Floats, torque: Floats) -> None:
    """Raise `force` and `torque`, (characters,), to the lengths of the two halves of `residual`, (characters, 6), where they are longer."""
    for i in range(len(residual)):
        x, y, z, a, b, c = residual[i]
        force[i] = max(force[i], math.sqrt(x * x + y * y + z * z))
        torque[i] = max(torque[i], math.sqrt(a * a + b * b + c * c))
