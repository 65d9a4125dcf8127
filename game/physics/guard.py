"""What may go into a step and what may come out of it: finite, bounded, or else the character at fault goes limp."""

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
    if not (np.isfinite(command.rotation).all() and np.isfinite(command.velocity).all() and np.isfinite(command.feedforward).all()):
        return False
    if not (np.isfinite(command.kp).all() and np.isfinite(command.kd).all() and (command.kp >= 0.0).all() and (command.kd >= 0.0).all()):
        return False
    length = np.sum(command.rotation * command.rotation, axis=1)
    return bool((np.abs(length - 1.0) < 1e-6).all() and (np.abs(command.feedforward) < TORQUE_LIMIT_NM).all())


def unsound_characters(bodies: Sequence[BodyDynamics], position: Floats, velocity: Floats) -> list[int]:
    """Characters whose part of qpos or qvel is not finite, faster than any body or out of the world."""
    # the comparisons are false for NaN
    if velocity @ velocity < SPEED_LIMIT**2 and position @ position < PLACE_LIMIT_M**2:
        return []

    def sound(body: BodyDynamics) -> bool:
        return bool(np.abs(velocity[body.dofs]).max() < SPEED_LIMIT and np.abs(position[body.coordinates]).max() < PLACE_LIMIT_M)

    return [index for index, body in enumerate(bodies) if not sound(body)]
