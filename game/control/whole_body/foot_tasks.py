"""What each foot is asked to do: a standing one to rest flat, a swinging one to follow, one in flight to come down under the body."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import JOINT_COUNT
from game.compiled import compiled
from game.control.whole_body.joint_tasks import turn_acceleration, turn_error
from game.control.whole_body.motion_window import MotionFields
from game.control.whole_body.player_stance import Overlay, turned_over

Floats = NDArray[np.float64]

STANCE_WEIGHT, SWING_WEIGHT = 20000.0, 150.0
EDGE_RAD = 0.045
"""A sole that is tilted so far, because its ankle can do no more, is asked half as much to lie flat, and less the more it is tilted."""

RISE_M_S = 0.2
"""A sole that rises so fast, because its leg is at its end, is asked half as much to stay down, and less the faster it rises."""

LANDING_S = 0.06
CATCH_UP_S = 0.3
"""How long a foot that lifts late takes to where the player's already is."""

LEAST_LIFT_M, PRESS_M = 0.02, 0.01
"""A foot that the player has up is this far off the floor at least; one that he has down is aimed this far below it."""

NEAR_M, LANDING_WEIGHT = 0.03, 2000.0
"""A foot that the player has down and that is no farther off the floor is brought down with so much weight: else it hovers."""

LARGEST_SWING, LARGEST_REACH = 60.0, 40.0
"""m/s^2 a swinging foot may be asked for, and one in flight."""


@compiled
def stance(twist: Floats, turn: Floats, height_m: float, touches: bool, since_s: float, weight: Floats, goal: Floats) -> None:
    """Fill weight and goal (6,) of a foot that stands: at rest, flat, pressed down where it has lost the floor.

    twist (6,) of the sole, turn (3, 3) foot to world.
    """
    goal[:] = -30.0 * twist
    # sine of the tilt, about the axis that lays the sole flat: up x z
    goal[3] += 150.0 * turn[1, 2]
    goal[4] -= 150.0 * turn[0, 2]
    share = min(1.0, 0.1 + since_s / LANDING_S)
    if not touches:
        goal[2] -= 200.0 * max(height_m, 0.0) + 2.0
        share = 0.02
    weight[:] = STANCE_WEIGHT * share
    rising = max(twist[2], 0.0) / RISE_M_S
    weight[2] /= 1.0 + rising * rising
    tilt = (turn[0, 2] ** 2 + turn[1, 2] ** 2) / EDGE_RAD**2
    weight[3:5] /= 1.0 + tilt * tilt


@compiled
def swing(
    sole: Floats, orientation: Floats, turn: Floats, twist: Floats, place: Floats, velocity: Floats, acceleration: Floats,
    facing: Floats, spin: Floats, weight: Floats, goal: Floats,
) -> None:  # fmt: skip
    """Fill weight and goal (6,) of a foot on its way: sole (3,) to `place`, orientation (4,) to `facing`."""
    goal[:3] = 600.0 * (place - sole) + 45.0 * (velocity - twist[:3]) + acceleration
    goal[:3] *= min(1.0, LARGEST_SWING / max(one.length(goal[:3]), 1e-9))
    goal[3:] = one.turn(turn, turn_acceleration(turn_error(orientation, facing), one.turn_back(turn, twist[3:]), spin, 250.0, 30.0, 200.0))
    weight[:] = SWING_WEIGHT


@compiled
def follow(
    side: int, sole: Floats, orientation: Floats, turn: Floats, twist: Floats, up: bool, wished: Floats, yaw: float, rest_m: float,
    motion: MotionFields, overlay: Overlay, turn_rad: float, behind: Floats, since_s: float, fresh: bool, weight: Floats, goal: Floats,
) -> None:  # fmt: skip
    """Fill weight and goal (6,) of a foot that swings after the player's: to the place `wished` (2,), as high as his, and turned as his
    while he has it `up`, else to `yaw` and the floor.

    rest_m: height of an ankle over its sole; overlay, turn_rad: of the player's world; behind (3,): how far the foot was from there when
    the swing began `since_s` ago; written where it is `fresh`.
    """
    player_turn, player_spin, _, player_place, player_velocity, player_acceleration = motion
    place = np.empty(3)
    place[:2] = wished
    place[2] = player_place[1 + side, 2] - overlay[4] - rest_m
    if up:
        facing = one.multiply(one.about_z(turn_rad), player_turn[JOINT_COUNT + 1 + side])
        place[2] = max(place[2], LEAST_LIFT_M)
    else:
        facing = one.about_z(yaw)
        place[2] = min(place[2], 0.0) - PRESS_M
    velocity, acceleration = turned_over(player_velocity[1 + side], overlay), turned_over(player_acceleration[1 + side], overlay)
    if fresh:
        behind[:] = sole - place
    left = max(1.0 - since_s / CATCH_UP_S, 0.0)
    place += left * left * behind
    velocity -= 2.0 * left / CATCH_UP_S * behind
    swing(sole, orientation, turn, twist, place, velocity, acceleration, facing, player_spin[JOINT_COUNT + 1 + side], weight, goal)
    if not up and sole[2] < NEAR_M:
        weight[2] = LANDING_WEIGHT


@compiled
def flight(
    sole: Floats, orientation: Floats, turn: Floats, twist: Floats, under: Floats, com_velocity: Floats, facing: Floats, legs_end_m: float,
    weight: Floats, goal: Floats,
) -> None:  # fmt: skip
    """Fill weight and goal (6,) of a foot in the air: flat, and level with the place `under` (2,) where it should come down.

    legs_end_m: how high the sole is on legs ready to land. Who comes down has them so, however deep the player already crouches.
    """
    goal[:] = 0.0
    goal[:2] = 150.0 * (under - sole[:2]) + 25.0 * (com_velocity[:2] - twist[:2])
    goal[:3] *= min(1.0, LARGEST_REACH / max(one.length(goal[:3]), 1e-9))
    spin = one.turn_back(turn, twist[3:])
    goal[3:] = one.turn(turn, turn_acceleration(turn_error(orientation, facing), spin, np.zeros(3), 250.0, 30.0, 200.0))
    weight[:2], weight[2], weight[3:] = 10.0, 0.0, 3.0
    if com_velocity[2] < 0.0:
        weight[2] = 10.0
        goal[2] = min(max(150.0 * (legs_end_m - sole[2]) + 25.0 * (com_velocity[2] - twist[2]), -LARGEST_REACH), LARGEST_REACH)
