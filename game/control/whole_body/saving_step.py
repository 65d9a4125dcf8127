"""A step that saves the balance: which foot takes it, which way round the other leg, and where it comes down."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game.control.whole_body.bow import NO_BOW, Bow, Farthest, bow
from game.control.whole_body.capture_point import predicted, pushed_away
from game.control.whole_body.sole import PRESSURE_MARGIN_M, Sole
from game.control.whole_body.support_polygon import nearest_inside, sole_corners
from game.control.whole_body.sway import Sway
from game.control.whole_body.wish import Wish

Floats = NDArray[np.float64]

STEP_S, CROSS_S, UNCROSS_S = 0.234, 0.27, 0.37
"""How long it takes: on the foot's own side, across the other leg, and back from there."""

OVERSTEP, CROSS_OVERSTEP, UNCROSS_OVERSTEP = (1.05, 1.13), (1.42, 1.42), (1.34, 1.07)
"""It goes so many times as far ahead and aside as the capture point is on its way: what the swing itself costs is in it."""

PUSH_LASTS_S = 0.06
"""A push that is felt is reckoned to go on so long."""

LAND_ENDS_M, LAND_SIDES_M = 0.1, 0.048
"""It brings the sole so well under the capture point that it lies this far inside."""

LEAST_SIDE_M, CROSS_AHEAD_M, LEAST_CROSS_M, MOST_CROSS_M = 0.13, 0.183, 0.13, 0.62
"""It lands at least so far to its own side of the other foot, farther where that is turned; or at least so far before or behind it, and at
least and at most so far across."""

ROUND_M, WIDE_M = 0.3, 0.14
"""So far out of the straight way it swings round the other leg, ahead or back and to its own side: it would run into the other foot on the
way across, and come down on it with its heel on the way back."""

REACH_M = 0.765
"""From the other foot, at most."""

LOAD_PRICE_M, SHORT_PRICE = 0.08, 4.9
"""Of lifting the foot that carries all, and of a metre that the step falls short of the capture point: against a metre that the capture
point is away from the foot stood on."""

CROSS_PRICE_M, SLOW_CROSS_PRICE_M, CROSS_AHEAD_PRICE, FRONT_PRICE_M = 0.2, 0.5, 4.0, 0.1
"""Of crossing over, where the other leg is in the way, and of doing so when nothing pushes hard; of a metre ahead that it goes then; of
crossing before the other leg."""

HARD_M_S2 = 1.25
"""A felt push is hard from here on: it unloads the foot that would have to be stood on in a step to the side."""


@dataclass(frozen=True)
class SavingStep:
    """side: of the foot that steps; across: 0 where it lands on its own side of the other one, 1 or -1 where across, before or behind it;
    round_m: how far ahead of the straight way it swings round the other leg; span_s: how long it takes; overstep: ahead and aside."""

    side: int
    across: int
    round_m: float
    span_s: float
    overstep: tuple[float, float]

    def bow(self, yaw: float) -> Bow:
        """Out of the straight way, for a foot that is to point to `yaw`, rad."""
        if self.round_m == 0.0:
            return NO_BOW
        # past the other foot's toes or heel before it goes aside; and, on the way back, until it has done so
        farthest = Farthest.EARLY if self.across else Farthest.LATE
        return bow(yaw, self.round_m, WIDE_M if self.side == 0 else -WIDE_M, farthest)


def saving_step(side: int, across: int, soles: tuple[Sole, Sole], wish: Wish) -> SavingStep:
    """The step of a foot as the soles stand now."""
    round_m = way_round(side, across, soles, wish)
    if across:
        return SavingStep(side, across, round_m, CROSS_S, CROSS_OVERSTEP)
    if round_m:
        return SavingStep(side, 0, round_m, UNCROSS_S, UNCROSS_OVERSTEP)
    return SavingStep(side, 0, 0.0, STEP_S, OVERSTEP)


def way_round(side: int, across: int, soles: tuple[Sole, Sole], wish: Wish) -> float:
    """m ahead that a foot swings out of the straight way: round the leg that it crosses, or is crossed with now."""
    ahead, aside = from_other(side, soles[1 - side], wish, soles[side].centre[:2])
    if aside < 0.5 * LEAST_SIDE_M:
        return math.copysign(ROUND_M, ahead)
    return across * ROUND_M


def cheapest_step(soles: tuple[Sole, Sole], sway: Sway, wish: Wish, sides: Iterable[int] = (0, 1)) -> SavingStep:
    """Which of two standing feet steps, if both may, and whether it crosses over.

    The other foot is stood on meanwhile, and the capture point flees from it the faster the farther away it already is: the step is
    chosen for which that distance and what it will fall short by, at SHORT_PRICE, are least together with its other prices.
    """
    steps = [saving_step(side, across, soles, wish) for side in sides for across in (0, 1, -1)]
    return min(steps, key=lambda step: _price(step, soles, sway, wish))


def _price(step: SavingStep, soles: tuple[Sole, Sole], sway: Sway, wish: Wish) -> float:
    stands = soles[1 - step.side]
    pivot, landing = _at_touch_down(step, stands, sway, wish, step.span_s)
    goal = _nearest_landing(step, stands, landing, wish)
    length, width = stands.half_length - PRESSURE_MARGIN_M, stands.half_width - PRESSURE_MARGIN_M
    short_m = math.dist(nearest_inside(sole_corners(goal, wish.yaw[step.side], length, width), landing), landing)
    price = SHORT_PRICE * short_m + math.dist(sway.xi, pivot) + LOAD_PRICE_M * sway.load[step.side]
    if step.across:
        yaw = wish.yaw[1 - step.side]
        ahead_m = abs((landing[0] - pivot[0]) * math.cos(yaw) + (landing[1] - pivot[1]) * math.sin(yaw))
        price += CROSS_PRICE_M if math.hypot(*sway.push) > HARD_M_S2 else SLOW_CROSS_PRICE_M
        price += CROSS_AHEAD_PRICE * ahead_m + FRONT_PRICE_M * (step.across > 0)
    return price


def landing_goal(step: SavingStep, soles: tuple[Sole, Sole], sway: Sway, wish: Wish, time_s: float) -> Floats:
    """(3,) where the sole should come down in `time_s`: as far from the other one as the player's, moved as little as the capture point
    of then asks.

    It keeps clear of the other foot and within a leg's reach.
    """
    stands = soles[1 - step.side]
    _, landing = _at_touch_down(step, stands, sway, wish, time_s)
    return _nearest_landing(step, stands, landing, wish)


def _nearest_landing(step: SavingStep, other: Sole, landing: Floats, wish: Wish) -> Floats:
    """`landing_goal` beside the sole that stands, for a capture point (2,) that will be at `landing`."""
    side = step.side
    stance = other.centre.copy()
    stance[:2] += wish.place[side] - wish.place[1 - side]
    there = sole_corners(stance, wish.yaw[side], other.half_length - LAND_ENDS_M, other.half_width - LAND_SIDES_M)
    ahead, aside = from_other(side, other, wish, stance[:2] + landing - nearest_inside(there, landing))
    within = min(1.0, REACH_M / max(math.hypot(ahead, aside), 1e-9))
    ahead, aside = _clear_of_other(step, other, wish, within * ahead, within * aside)
    most = math.sqrt(max(REACH_M**2 - aside**2, 0.0))
    ahead, left = min(max(ahead, -most), most), aside if side == 0 else -aside
    c, s = math.cos(wish.yaw[1 - side]), math.sin(wish.yaw[1 - side])
    goal = np.array([c * ahead - s * left, s * ahead + c * left, 0.0])
    goal[:2] += other.centre[:2]
    return goal


def from_other(side: int, other: Sole, wish: Wish, place: Floats) -> tuple[float, float]:
    """m that a place (2,) lies ahead of the other foot, and to the own side of foot `side`, as the player's foot points: the other one
    may have been wrung."""
    c, s = math.cos(wish.yaw[1 - side]), math.sin(wish.yaw[1 - side])
    x, y = place - other.centre[:2]
    left = c * y - s * x
    return c * x + s * y, left if side == 0 else -left


def _clear_of_other(step: SavingStep, other: Sole, wish: Wish, ahead: float, aside: float) -> tuple[float, float]:
    """m ahead of the other foot and to this foot's own side of it: beside it, however it is turned, or crossed before or behind it."""
    across = step.across
    if not across:
        turned = other.yaw - wish.yaw[1 - step.side]
        wide = other.half_length * abs(math.sin(turned)) + other.half_width * abs(math.cos(turned))
        return ahead, max(aside, LEAST_SIDE_M + wide - other.half_width)
    return across * max(across * ahead, CROSS_AHEAD_M), min(max(aside, -MOST_CROSS_M), -LEAST_CROSS_M)


def _at_touch_down(step: SavingStep, stands: Sole, sway: Sway, wish: Wish, time_s: float) -> tuple[Floats, Floats]:
    """(2,) of the sole that stands the place nearest to the capture point, and (2,) where that will be in `time_s`, with overstep."""
    left_s, frequency = max(time_s, 0.0), sway.frequency
    pivot = nearest_inside(stands.corners(PRESSURE_MARGIN_M), sway.xi)
    way = predicted(sway.xi, pivot, frequency, left_s) - pivot + pushed_away(sway.push, frequency, PUSH_LASTS_S, left_s)
    c, s = math.cos(wish.yaw[1 - step.side]), math.sin(wish.yaw[1 - step.side])
    ahead, left = step.overstep[0] * (c * way[0] + s * way[1]), step.overstep[1] * (c * way[1] - s * way[0])
    return pivot, pivot + np.array([c * ahead - s * left, s * ahead + c * left])
