"""The capture point: where a body would have to stand to come to rest (Pratt et al. 2006), and the steering of it."""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.control.whole_body.player_stance import Overlay, laid_over, turned_over
from game.control.whole_body.support_polygon import distance_inside, hull_of_soles, nearest_inside, share_inside

Floats = NDArray[np.float64]

LARGEST_LEAD_M = 0.2
"""The pressure is sought at most so far beyond a capture point that lies outside: the place of the soles nearest to one far away is a
corner of them, where they can neither lift nor turn the body."""


def natural_frequency(gravity: float, height_m: float) -> float:
    """1/s of the linear inverted pendulum of a COM at `height_m` above the soles."""
    return math.sqrt(gravity / max(height_m, 0.2))


@compiled
def capture_point(com: Floats, velocity: Floats, frequency: float) -> Floats:
    """(2,) xi = c + v / omega."""
    return com[:2] + velocity[:2] / frequency


@compiled
def predicted(xi: Floats, pivot: Floats, frequency: float, time_s: float) -> Floats:
    """(2,) the capture point in `time_s`, the centre of pressure staying at `pivot` (2,)."""
    return pivot + (xi - pivot) * math.exp(frequency * time_s)


def pushed_away(push: Floats, frequency: float, lasts_s: float, time_s: float) -> Floats:
    """(2,) m that an acceleration `push` (2,) m/s^2 of the COM, which lasts so long, adds to the way of the capture point in `time_s`."""
    lasts_s = min(lasts_s, time_s)
    return (math.exp(frequency * lasts_s) - 1.0) * math.exp(frequency * (time_s - lasts_s)) / frequency**2 * push


@compiled
def escape(hull: Floats, xi: Floats, frequency: float, time_s: float) -> tuple[float, float]:
    """m that xi lies outside the hull, now and in `time_s`; negative inside."""
    return -distance_inside(hull, xi), -distance_inside(hull, predicted(xi, nearest_inside(hull, xi), frequency, time_s))


@compiled
def escape_of_soles(
    left: Floats, left_yaw: float, right: Floats, right_yaw: float, use_left: bool, use_right: bool, half_length: float, half_width: float,
    xi: Floats, frequency: float, time_s: float,
) -> tuple[float, float]:  # fmt: skip
    """`escape` from the `hull_of_soles`."""
    return escape(hull_of_soles(left, left_yaw, right, right_yaw, use_left, use_right, half_length, half_width), xi, frequency, time_s)


@compiled
def pressure_target(xi: Floats, wanted: Floats, frequency: float, gain: float, hull: Floats) -> Floats:
    """(2,) the pivot that brings xi to `wanted` at rate `gain` (1/s), from xi' = omega (xi - p); where it lies outside the hull, the
    farthest in the hull that brings xi straight there."""
    lead = gain / frequency * (xi - wanted)
    if distance_inside(hull, xi) > 0.0:
        return xi + share_inside(hull, xi, lead) * lead
    return nearest_inside(hull, xi + min(1.0, LARGEST_LEAD_M / max(math.hypot(lead[0], lead[1]), 1e-9)) * lead)


@compiled
def players_capture_point(com: Floats, velocity: Floats, overlay: Overlay, frequency: float) -> tuple[float, float]:
    """x, y (m) in the character's world of the capture point that a COM (3,) and its velocity (3,) in the player's have there."""
    place, way = laid_over(com, overlay), turned_over(velocity, overlay)
    return place[0] + way[0] / frequency, place[1] + way[1] / frequency


@compiled
def steer(
    goal_x: float, goal_y: float, goal_hull: Floats, xi: Floats, frequency: float, gain: float, hull: Floats
) -> tuple[float, float, float, float]:
    """x, y of the place in `goal_hull` nearest to a goal, where xi is to go, and of the `pressure_target` that brings it there."""
    goal = np.empty(2)
    goal[0], goal[1] = goal_x, goal_y
    wanted = nearest_inside(goal_hull, goal)
    pressure = pressure_target(xi, wanted, frequency, gain, hull)
    return wanted[0], wanted[1], pressure[0], pressure[1]
