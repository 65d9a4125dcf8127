"""The books of a physics step, closed in one compiled call: was it sound, which torques acted, what do contacts leave unexplained?"""

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.physics.actuation import settle_torque
from game.physics.guard import well_within_bounds
from game.physics.root_balance import Indices, keep_largest, root_balance, root_momentum_change

Floats = NDArray[np.float64]


@compiled
def copy_state(position: Floats, velocity: Floats, to_position: Floats, to_velocity: Floats) -> None:
    """Copy qpos and qvel."""
    for i in range(len(position)):
        to_position[i] = position[i]
    for i in range(len(velocity)):
        to_velocity[i] = velocity[i]


@compiled
def note_state(position: Floats, velocity: Floats, trail: Floats, row: int) -> None:
    """qpos and qvel, one after the other, into a row of `trail`, (n, nq + nv)."""
    copy_state(position, velocity, trail[row, : len(position)], trail[row, len(position) :])


@compiled
def close_step(
    position: Floats, velocity: Floats, end_position: Floats, end_velocity: Floats, trail: Floats, row: int,
    applied: Floats, damping: Floats, torque: Floats, peak: Floats,
    mass: Floats, mass_count: Indices, mass_start: Indices, mass_column: Indices, bias: Floats, step_s: float,
    first_rows: NDArray[np.int64], root_place: Floats, root_turn: Floats, count: int, point: Floats, frame: Floats, friction: Floats,
    geom: Indices, owner: Indices, wrench: Floats, pairs: NDArray[np.bool_], residual: Floats, metered: bool, force_n: Floats,
    torque_nm: Floats, found_sound: bool,
) -> float:  # fmt: skip
    """Settle the torques, take the balance and note the state in which the step ended; gives the worst contact's excess over its cone, N.

    end_position, end_velocity: where the last step ended, then where this one did. metered: the balance goes into the largest
    forces (characters,) N and torques (characters,) N m; otherwise `residual` is filled and the caller goes on with it. Names as in
    `root_balance`. NaN, and nothing done, where a state is none of a body, unless the guard has found it sound.
    """
    if not found_sound and not well_within_bounds(position, velocity):
        return np.nan
    settle_torque(applied, damping, velocity, torque, peak)
    root_momentum_change(mass, mass_count, mass_start, mass_column, velocity, end_velocity, first_rows, residual)
    excess = root_balance(
        residual, step_s, bias, first_rows, root_place, root_turn, count, point, frame, friction, geom, owner, wrench, pairs
    )
    if metered:
        keep_largest(residual, force_n, torque_nm)
    copy_state(position, velocity, end_position, end_velocity)
    note_state(position, velocity, trail, row)
    return excess
