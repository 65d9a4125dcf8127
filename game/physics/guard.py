"""What may go into a step and what may come out of it: finite, bounded, or else the character at fault goes limp."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game.control.joint_command import JointCommand
from game.physics.dynamics import BodyDynamics

Floats = NDArray[np.float64]

SPEED_LIMIT = 1e3
"""Root m/s or joint rad/s beyond which a state is no motion of a body but a failed step."""

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
    """Characters whose part of qpos or qvel is not finite or faster than any body."""
    if velocity @ velocity < SPEED_LIMIT**2 and np.isfinite(position.sum()):
        return []
    found = []
    for index, body in enumerate(bodies):
        v = velocity[body.dofs]
        if not (np.isfinite(position[body.coordinates]).all() and np.isfinite(v).all() and np.abs(v).max() < SPEED_LIMIT):
            found.append(index)
    return found
