"""A step that saves the balance: which foot takes it, and where it comes down."""

import math

import numpy as np
from numpy.typing import NDArray

from game.control.whole_body.capture_point import predicted
from game.control.whole_body.sole import PRESSURE_MARGIN_M, Sole
from game.control.whole_body.support_polygon import nearest_inside, sole_corners
from game.control.whole_body.wish import Wish

Floats = NDArray[np.float64]

STEP_S = 0.2
"""How long it takes."""

OVERSTEP = 1.2
"""It goes so many times as far as the capture point is on its way: what still pushes, and what the swing itself costs, is in it."""

LAND_ENDS_M, LAND_SIDES_M = 0.1, 0.05
"""It brings the sole so well under the capture point that it lies this far inside."""

LEAST_SIDE_M, CROSS_AHEAD_M, CROSS_SIDE_M = 0.13, 0.32, 0.3
"""It lands at least so far to its own side of the other foot, or at least so far before or behind it and at most so far across."""

REACH_M = 0.7
"""From the other foot, at most."""

CROSS_PRICE_M, SHORT_PRICE = 0.2, 2.0
"""Of crossing over, where the other leg is in the way, and of a metre that the step falls short of the capture point: against a metre
that the capture point is away from the foot stood on."""


def saving_foot(soles: tuple[Sole, Sole], xi: Floats, frequency: float, wish: Wish) -> int:
    """Which of two standing feet steps.

    The other is stood on meanwhile, and the capture point flees from it the faster the farther away it already is: the foot is chosen
    for which that distance and what its step will fall short by, at SHORT_PRICE, are least together, with CROSS_PRICE_M where it has to
    cross over. Sideways it is therefore the foot on the side of the fall, the other one where that cannot be fast enough; else the one
    that trails.
    """
    price = []
    for side in range(2):
        sole = soles[1 - side]
        pivot, landing = _at_touch_down(sole, xi, frequency, STEP_S)
        goal = _nearest_landing(side, sole, landing, wish)
        there = sole_corners(goal, wish.yaw[side], sole.half_length - PRESSURE_MARGIN_M, sole.half_width - PRESSURE_MARGIN_M)
        crosses = _from_other(side, sole, goal[:2])[1] < LEAST_SIDE_M - 1e-6
        short = math.dist(nearest_inside(there, landing), landing)
        price.append(CROSS_PRICE_M * crosses + SHORT_PRICE * short + math.dist(xi, pivot))
    return int(price[1] < price[0])


def _from_other(side: int, other: Sole, place: Floats) -> tuple[float, float]:
    """m that a place (2,) lies ahead of the other foot, and to the own side of foot `side`."""
    c, s = math.cos(other.yaw), math.sin(other.yaw)
    x, y = place - other.centre[:2]
    left = c * y - s * x
    return c * x + s * y, left if side == 0 else -left


def landing_goal(side: int, soles: tuple[Sole, Sole], xi: Floats, frequency: float, wish: Wish, time_s: float) -> Floats:
    """(3,) where the sole should come down in `time_s`: where the player has it, moved as little as the capture point of then asks.

    It keeps clear of the other foot and within a leg's reach.
    """
    other = soles[1 - side]
    _, landing = _at_touch_down(other, xi, frequency, time_s)
    return _nearest_landing(side, other, landing, wish)


def _nearest_landing(side: int, other: Sole, landing: Floats, wish: Wish) -> Floats:
    """`landing_goal` beside the sole that stands, for a capture point (2,) that will be at `landing`."""
    there = sole_corners(wish.place[side], wish.yaw[side], other.half_length - LAND_ENDS_M, other.half_width - LAND_SIDES_M)
    place = wish.place[side] + landing - nearest_inside(there, landing)
    ahead, aside = _from_other(side, other, place)
    within = min(1.0, REACH_M / max(math.hypot(ahead, aside), 1e-9))
    ahead, aside = _clear_of_other(within * ahead, within * aside)
    most = math.sqrt(max(REACH_M**2 - aside**2, 0.0))
    ahead, left = min(max(ahead, -most), most), aside if side == 0 else -aside
    c, s = math.cos(other.yaw), math.sin(other.yaw)
    goal = np.array([c * ahead - s * left, s * ahead + c * left, 0.0])
    goal[:2] += other.centre[:2]
    return goal


def _clear_of_other(ahead: float, aside: float) -> tuple[float, float]:
    """m ahead of the other foot and to this foot's own side of it: beside it, or crossed before or behind it, whichever is nearer."""
    crossed_ahead = math.copysign(max(abs(ahead), CROSS_AHEAD_M), ahead)
    crossed_aside = max(aside, -CROSS_SIDE_M)
    if LEAST_SIDE_M - aside <= abs(crossed_ahead - ahead) + crossed_aside - aside:
        return ahead, max(aside, LEAST_SIDE_M)
    return crossed_ahead, crossed_aside


def _at_touch_down(stands: Sole, xi: Floats, frequency: float, time_s: float) -> tuple[Floats, Floats]:
    """(2,) of the sole that stands the place nearest to the capture point, and (2,) where that will be in `time_s`, with OVERSTEP."""
    pivot = nearest_inside(stands.corners(PRESSURE_MARGIN_M), xi)
    return pivot, pivot + OVERSTEP * (predicted(xi, pivot, frequency, max(time_s, 0.0)) - pivot)
