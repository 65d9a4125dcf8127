"""What may go into a step and what may come out of it: finite, bounded, or else the character at fault goes limp."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.control.joint_command import JointCommand
from game.physics.dynamics import BodyDynamics

Floats = NDArray[np.float64]

SPEED_LIMIT = 1e3
"""Root m/s or joint rad/s beyond which a state is no motion of a body but a failed step."""

PLACE_LIMIT_M = 1e4
"""Farther from the origin no body has walked; quaternions are far below it."""

TORQUE_LIMIT_NM = 1e5


def command_is_sound(command: JointCommand) -> bool:
    """Every number finite, quaternions of unit length, gains not negative."""
    return _sound(command.rotation, command.velocity, command.kp, command.kd, command.feedforward)


@compiled
def _sound(rotation: Floats, velocity: Floats, kp: Floats, kd: Floats, feedforward: Floats) -> bool:
    # written so that every comparison with NaN refuses
    for row in range(len(rotation)):
        q = rotation[row]
        if not abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1.0) < 1e-6:
            return False
    for row in range(len(kp)):
        if not (0.0 <= kp[row] < np.inf and 0.0 <= kd[row] < np.inf):
            return False
        if not (abs(velocity[row]) < np.inf and abs(feedforward[row]) < TORQUE_LIMIT_NM):
            return False
    return True


def unsound_characters(bodies: Sequence[BodyDynamics], position: Floats, velocity: Floats) -> list[int]:
    """Characters whose part of qpos or qvel is not finite, faster than any body or out of the world."""
    if well_within_bounds(position, velocity):
        return []

    def sound(body: BodyDynamics) -> bool:
        return bool(np.abs(velocity[body.dofs]).max() < SPEED_LIMIT and np.abs(position[body.coordinates]).max() < PLACE_LIMIT_M)

    return [index for index, body in enumerate(bodies) if not sound(body)]


@compiled
def well_within_bounds(position: Floats, velocity: Floats) -> bool:
    """True where even the length of the whole qpos and of the whole qvel stay below the limits of a single number."""
    fast = far = 0.0
    for speed in velocity:
        fast += speed * speed
    for place in position:
        far += place * place
    # the comparisons are false for NaN
    return fast < SPEED_LIMIT**2 and far < PLACE_LIMIT_M**2
