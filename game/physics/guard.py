"""What may go into a step and what may come out of it: finite, bounded, or else the character at fault goes limp."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

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
    # a sum is finite only if all its terms are, and no comparison holds for NaN
    if not math.isfinite(command.rotation.sum() + command.velocity.sum() + command.kp.sum() + command.kd.sum()):
        return False
    if command.kp.min() < 0.0 or command.kd.min() < 0.0 or not np.abs(command.feedforward).max() < TORQUE_LIMIT_NM:
        return False
    length = (command.rotation * command.rotation).sum(axis=1)
    return bool(length.min() > 1.0 - 1e-6 and length.max() < 1.0 + 1e-6)


def unsound_characters(bodies: Sequence[BodyDynamics], position: Floats, velocity: Floats) -> list[int]:
    """Characters whose part of qpos or qvel is not finite, faster than any body or out of the world."""
    # the comparisons are false for NaN
    if velocity.dot(velocity) < SPEED_LIMIT**2 and position.dot(position) < PLACE_LIMIT_M**2:
        return []

    def sound(body: BodyDynamics) -> bool:
        return bool(np.abs(velocity[body.dofs]).max() < SPEED_LIMIT and np.abs(position[body.coordinates]).max() < PLACE_LIMIT_M)

    return [index for index, body in enumerate(bodies) if not sound(body)]
