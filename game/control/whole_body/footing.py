"""Planning of contacts: when a foot may lift, when it has landed, and the steps that save the balance or mend the stance."""

import math

import numpy as np
from numpy.typing import NDArray

from game.control.whole_body.bow import bow
from game.control.whole_body.capture_point import escape_of_soles, pushed_away
from game.control.whole_body.contact_states import FootState, Phase
from game.control.whole_body.mending import MARGIN_M, SLOW_M, Mending
from game.control.whole_body.saving_step import SavingStep, cheapest_step, from_other, landing_goal, saving_step, way_round
from game.control.whole_body.sole import Sole, polygon
from game.control.whole_body.support_polygon import distance_inside
from game.control.whole_body.sway import Sway
from game.control.whole_body.wish import Wish

Floats = NDArray[np.float64]

LOST_M = 0.03
"""A standing foot that has come this far off the floor is brought back like one that swings."""

NEAR_FLOOR_M = 0.08
"""A foot on its way down counts for the balance from here on."""

RETURN_S, TURNS_SHARE = 0.3, 0.6
"""A foot that is put right takes so long; for this share of it, it can still turn to save the balance."""

PASS_M = 0.03
"""It passes the other foot at this distance."""

LEFT_BEHIND_S, HANGS_M = 1.0, 0.015
"""A foot that loses the floor so soon after a step that saved the balance was left behind by it, and is put beside the other one; and so
is one that then hangs this far above the floor, which a leg spread wide does not reach."""

LIFT_AGAIN_M = 0.012
"""A foot that had to come down at once is lifted again once the capture point lies this far inside the other sole."""

LAND_NEAR_M = 0.1
"""A foot on a step of its own that grazes the floor farther from where it is to come down has not landed."""

STUCK_S = 0.1
"""A foot that still stands so long after its step began, while the other one hangs, leaves the step to that one."""

LOOK_AHEAD_S, PUSH_AHEAD_S = 0.1, 0.154
OUT_NOW_M, OUT_SOON_M, OUT_LONG_S = 0.015, 0.05, 0.12
"""A step saves the balance once the capture point is that far outside, will be by then, or has been outside so long. A push that is felt
is reckoned to go on for PUSH_AHEAD_S."""


class Footing:
    """The phases of both feet, brought up to date by `update`; `hull` and `goal_hull` tell where the weight may and should go."""

    def __init__(self) -> None:
        self.feet = [FootState(), FootState()]
        self.flying = False
        self.landed_s = 10.0
        """Since the last flight."""
        self.saved_s = 10.0
        self.rounds = False
        """Since the last step that was to save the balance, and whether that went round the other leg."""
        self.outside_s = 0.0
        self.missed = [False, False]
        """Feet that the player has up and that had to come down again."""
        self.mending = Mending()
        self.intended: int | None = None
        """The foot that is about to carry all, None for both."""

    def update(self, soles: tuple[Sole, Sole], sway: Sway, wish: Wish, taking_off: bool, dt: float) -> None:
        """taking_off: a leap begins."""
        for side, foot in enumerate(self.feet):
            foot.time_s += dt
            self.missed[side] = self.missed[side] and wish.up[side]
        self._land(soles, sway, wish)
        self.saved_s = 0.0 if any(foot.saving for foot in self.feet) else self.saved_s + dt
        self.mending.watch(sway.thrown, dt)
        self.intended = None
        standing = [side for side in range(2) if self.feet[side].stands]
        if self._fly(soles, wish, taking_off, dt):
            return
        if len(standing) == 2:
            self._lift(soles, sway, wish, dt)
        elif len(standing) == 1 and not self._comes_down(1 - standing[0], soles, wish):
            self.intended = standing[0]
        self._recover(soles, sway, wish, dt)

    def hull(self, soles: tuple[Sole, Sole], margin_m: float, ends_m: float = 0.0) -> Floats:
        """The polygon of the feet that stand, of both where none does."""
        return _polygon_of(soles, self.feet[0].stands, self.feet[1].stands, margin_m, ends_m)

    def reach_hull(self, soles: tuple[Sole, Sole]) -> Floats:
        """The polygon of the feet that stand and of one that is about to save the balance, where it is now."""
        left, right = (foot.stands or foot.saving is not None for foot in self.feet)
        return _polygon_of(soles, left, right, 0.0, 0.0)

    def goal_hull(self, soles: tuple[Sole, Sole], margin_m: float, ends_m: float = 0.0) -> Floats:
        """Where the capture point should be: over the foot that is to carry all, where there is one; else between those that stand and
        those that come down after the player's."""
        if self.intended is None:
            left, right = (foot.phase is not Phase.STEP for foot in self.feet)
            return _polygon_of(soles, left, right, margin_m, ends_m)
        return soles[self.intended].corners(margin_m, ends_m)

    def _land(self, soles: tuple[Sole, Sole], sway: Sway, wish: Wish) -> None:
        for side, foot in enumerate(self.feet):
            touches = soles[side].touches
            lost = foot.stands and not touches and soles[side].centre[2] > LOST_M
            if (lost and side == self.mending.side) or self._is_left_behind(side, soles, sway, wish):
                self._put_right(side, soles, wish, True)
            elif lost:
                foot.enter(Phase.SWING)
            landed = foot.phase is Phase.SWING and foot.time_s > 0.08 and not wish.up[side]
            if foot.phase is Phase.STEP and foot.time_s > 0.6 * foot.duration_s:
                near = math.dist(soles[side].centre[:2], foot.goal[:2]) < LAND_NEAR_M
                landed = near or foot.time_s > foot.duration_s
            if landed and touches:
                foot.enter(Phase.STANCE)

    def _is_left_behind(self, side: int, soles: tuple[Sole, Sole], sway: Sway, wish: Wish) -> bool:
        """It is off the floor, the other foot carries all, and nothing is in the way."""
        foot, sole = self.feet[side], soles[side]
        if foot.phase is Phase.STEP or sole.touches or sole.centre[2] <= (LOST_M if foot.stands else HANGS_M):
            return False
        if wish.up[side] or self.saved_s > LEFT_BEHIND_S or way_round(side, 0, soles, wish):
            return False
        return bool(distance_inside(soles[1 - side].corners(0.0), sway.xi) > MARGIN_M)

    def _fly(self, soles: tuple[Sole, Sole], wish: Wish, taking_off: bool, dt: float) -> bool:
        self.landed_s += dt
        airborne = not (soles[0].touches or soles[1].touches)
        if (taking_off or (wish.flight and airborne)) and not self.flying:
            self.flying = True
            for foot in self.feet:
                foot.enter(Phase.SWING)
        if self.flying:
            for side, foot in enumerate(self.feet):
                if foot.time_s > 0.06 and soles[side].touches:
                    foot.enter(Phase.STANCE)
            if any(foot.stands for foot in self.feet):
                self.flying = False
                self.landed_s = 0.0
                for side, foot in enumerate(self.feet):
                    if not foot.stands:
                        foot.enter(Phase.STANCE if soles[side].centre[2] < 0.06 else Phase.SWING)
        return self.flying

    def _lift(self, soles: tuple[Sole, Sole], sway: Sway, wish: Wish, dt: float) -> None:
        side = self._to_lift(soles, sway, wish, dt)
        if side is None:
            return
        fast = not wish.up[side] and sway.away_m > SLOW_M
        # after a push the weight comes over the foot that stays with its own speed: steered elsewhere it would be stopped half-way
        if not fast or self.mending.side is not None:
            self.intended = 1 - side
        if fast:
            return
        other = 1 - side
        # over the other sole it can be steered both ways; whoever waits until it rests there lifts no foot of a player who marches
        margin = (LIFT_AGAIN_M if self.missed[side] else 0.0) if wish.up[side] else self.mending.margin_m
        if not soles[other].touches or distance_inside(soles[other].corners(0.0), sway.xi) < margin:
            return
        if wish.up[side]:
            self.feet[side].enter(Phase.SWING)
        elif way_round(side, 0, soles, wish):
            self._step(saving_step(side, 0, soles, wish), soles, sway, wish)
        else:
            self._put_right(side, soles, wish, self.mending.side is not None)

    def _put_right(self, side: int, soles: tuple[Sole, Sole], wish: Wish, beside: bool) -> None:
        """Step to where the player has the foot; `beside` the foot that stays, as far from it as the player's are apart, after a push."""
        sole, yaw = soles[side], wish.yaw[side]
        goal = sole.centre.copy()
        goal[:2] = wish.place[side]
        if beside:
            goal[:2] += soles[1 - side].centre[:2] - wish.place[1 - side]
        # a foot that turns would catch on the other one with its heel, and one that is too close with its side
        turns_m = sole.half_length * abs(math.sin(sole.yaw - yaw))
        _, aside_m = from_other(side, soles[1 - side], wish, sole.centre[:2])
        out_m = max(turns_m, 2.0 * sole.half_width + PASS_M - aside_m)
        self.feet[side].step_to(sole.centre, goal, sole.yaw, yaw, RETURN_S, bow(yaw, 0.0, out_m if side == 0 else -out_m))
        self.mending.drop()

    def _to_lift(self, soles: tuple[Sole, Sole], sway: Sway, wish: Wish, dt: float) -> int | None:
        """The foot that the player has up, or the one whose stance is to be mended: that one first where a push has left both far apart."""
        up = int(wish.up[1])
        if wish.up[up] and (wish.up[0] == wish.up[1] or not self.mending.closes_first(soles, sway.xi, wish, up)):
            self.mending.drop()
            return None if wish.up[0] == wish.up[1] else up
        return self.mending.choose(soles, sway.xi, wish, sway.away_m, dt)

    def _recover(self, soles: tuple[Sole, Sole], sway: Sway, wish: Wish, dt: float) -> None:
        standing = [side for side in range(2) if self.feet[side].stands]
        if not standing:
            return
        if len(standing) == 1 and self._is_stuck(1 - standing[0], soles):
            self.feet[1 - standing[0]].enter(Phase.STANCE)
            self._step(cheapest_step(soles, sway, wish, standing), soles, sway, wish)
            return
        outside, ahead = self._escape(soles, sway, wish)
        self.outside_s = self.outside_s + dt if outside > 0.0 else 0.0
        if not (outside > OUT_NOW_M or ahead > OUT_SOON_M or self.outside_s > OUT_LONG_S):
            self._retarget(soles, sway, wish)
            return
        if len(standing) == 1:
            side = 1 - standing[0]
            if self._can_turn(self.feet[side]):
                self.missed[side] = wish.up[side]
                self._step(cheapest_step(soles, sway, wish, (side,)), soles, sway, wish)
            else:
                self._retarget(soles, sway, wish)
            return
        self._step(cheapest_step(soles, sway, wish), soles, sway, wish)

    def _can_turn(self, foot: FootState) -> bool:
        """A foot in the air can save the balance: it follows the player's, or has not long been on its way to mend the stance."""
        return foot.phase is Phase.SWING or (foot.mends and foot.time_s < TURNS_SHARE * foot.duration_s)

    def _is_stuck(self, side: int, soles: tuple[Sole, Sole]) -> bool:
        """It is to save the balance and carries all instead: the push has lifted the other one."""
        foot = self.feet[side]
        stands = soles[side].touches and soles[side].centre[2] < soles[1 - side].centre[2]
        return foot.saving is not None and STUCK_S < foot.time_s < 0.6 * foot.duration_s and stands

    def _escape(self, soles: tuple[Sole, Sole], sway: Sway, wish: Wish) -> tuple[float, float]:
        """m that the capture point lies outside now, and will in LOOK_AHEAD_S, with what a push does until then."""
        left, right = (foot.stands or self._comes_down(side, soles, wish) for side, foot in enumerate(self.feet))
        a, b = soles

        def escape(xi: Floats) -> tuple[float, float]:
            return escape_of_soles(
                a.centre, a.yaw, b.centre, b.yaw, left, right, a.half_length, a.half_width, xi, sway.frequency, LOOK_AHEAD_S
            )

        outside, ahead = escape(sway.xi)
        if sway.push.any():
            ahead = max(ahead, escape(sway.xi + pushed_away(sway.push, sway.frequency, PUSH_AHEAD_S, PUSH_AHEAD_S))[1])
        return outside, ahead

    def _comes_down(self, side: int, soles: tuple[Sole, Sole], wish: Wish) -> bool:
        return self.feet[side].phase is Phase.SWING and not wish.up[side] and bool(soles[side].centre[2] < NEAR_FLOOR_M)

    def _retarget(self, soles: tuple[Sole, Sole], sway: Sway, wish: Wish) -> None:
        """A step under way that saves the balance goes where the capture point will be by then."""
        for foot in self.feet:
            if foot.saving is not None and foot.time_s < 0.6 * foot.duration_s:
                foot.goal = landing_goal(foot.saving, soles, sway, wish, foot.duration_s - foot.time_s)

    def _step(self, step: SavingStep, soles: tuple[Sole, Sole], sway: Sway, wish: Wish) -> None:
        side, foot = step.side, self.feet[step.side]
        goal = landing_goal(step, soles, sway, wish, step.span_s)
        yaw = wish.yaw[side]
        foot.step_to(soles[side].centre, goal, soles[side].yaw, yaw, step.span_s, step.bow(yaw))
        foot.saving, self.rounds = step, step.round_m != 0.0
        self.outside_s = 0.0
        self.mending.drop()
        self.mending.watch(True, 0.0)
        self.intended = 1 - side


def _polygon_of(soles: tuple[Sole, Sole], left: bool, right: bool, margin_m: float, ends_m: float) -> Floats:
    """Of the feet that are asked for, of both where neither is."""
    return polygon(soles, left or not right, right or not left, margin_m, ends_m)
