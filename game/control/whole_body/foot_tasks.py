"""What each foot is asked to do: a standing one to rest flat, a swinging one to follow, one in flight to come down under the body."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled
from game.control.whole_body.joint_tasks import turn_acceleration, turn_error

Floats = NDArray[np.float64]

STANCE_WEIGHT, SWING_WEIGHT = 20000.0, 150.0
LANDING_S = 0.06
CATCH_UP_S = 0.3
"""How long a foot that lifts late takes to where the player's already is."""

LARGEST_SWING = 80.0
"""m/s^2 a swinging foot may be asked for."""


@compiled
def stance(twist: Floats, turn: Floats, height_m: float, touches: bool, since_s: float) -> tuple[Floats, Floats]:
    """Weights and acceleration (6,) of a foot that stands: at rest, flat, pressed down where it has lost the floor.

    twist (6,) of the sole, turn (3, 3) foot to world.
    """
    goal = -30.0 * twist
    # sine of the tilt, about the axis that lays the sole flat: up x z
    goal[3] += 150.0 * turn[1, 2]
    goal[4] -= 150.0 * turn[0, 2]
    share = min(1.0, 0.1 + since_s / LANDING_S)
    if not touches:
        goal[2] -= 200.0 * max(height_m, 0.0) + 2.0
        share = 0.02
    return np.full(6, STANCE_WEIGHT * share), goal


@compiled
def swing(
    sole: Floats, orientation: Floats, turn: Floats, twist: Floats, place: Floats, velocity: Floats, acceleration: Floats,
    facing: Floats, spin: Floats,
) -> tuple[Floats, Floats]:  # fmt: skip
    """Weights and acceleration (6,) of a foot on its way: sole (3,) to `place`, orientation (4,) to `facing`."""
    goal = np.empty(6)
    goal[:3] = 600.0 * (place - sole) + 45.0 * (velocity - twist[:3]) + acceleration
    goal[:3] *= min(1.0, LARGEST_SWING / max(one.length(goal[:3]), 1e-9))
    goal[3:] = one.turn(turn, turn_acceleration(turn_error(orientation, facing), one.turn_back(turn, twist[3:]), spin, 250.0, 30.0, 200.0))
    return np.full(6, SWING_WEIGHT), goal


@compiled
def flight(
    sole: Floats, orientation: Floats, turn: Floats, twist: Floats, under: Floats, com_velocity: Floats, facing: Floats
) -> tuple[Floats, Floats]:
    """Weights and acceleration (6,) of a foot in the air: flat, and level with the place `under` (2,) where it should come down."""
    goal = np.zeros(6)
    goal[:2] = 150.0 * (under - sole[:2]) + 25.0 * (com_velocity[:2] - twist[:2])
    goal[:3] *= min(1.0, 40.0 / max(one.length(goal[:3]), 1e-9))
    spin = one.turn_back(turn, twist[3:])
    goal[3:] = one.turn(turn, turn_acceleration(turn_error(orientation, facing), spin, np.zeros(3), 250.0, 30.0, 200.0))
    return np.array([10.0, 10.0, 0.0, 3.0, 3.0, 3.0]), goal
