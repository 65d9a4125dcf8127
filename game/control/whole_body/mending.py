"""Mending of the stance: which foot is put where the player has his, and when; soon after a push, late where only the sensor drifts."""

import math

import numpy as np
from numpy.typing import NDArray

from game.control.whole_body.sole import Sole
from game.control.whole_body.wish import Wish

Floats = NDArray[np.float64]

AMISS_S, ASTRAY_M, ASTRAY_RAD = 0.6, 0.09, 0.2
"""A foot that has stood so long so far from where the player has his, or turned so far from it, is put there."""

SHAKEN_AMISS_S, SHAKEN_ASTRAY_M, SHAKEN_ASTRAY_RAD = 0.02, 0.06, 0.12
SHAKEN_S = 3.0
"""The same for so long after the body was thrown or saved itself by a step: then that moved the foot, not the sensor."""

FAR_APART_M = 0.2
"""Feet that a push has left so much farther apart than the player's are put together before one is lifted after his."""

CALM_M, SLOW_M = 0.05, 0.07
"""A capture point no farther from the COM than this belongs to a body at rest, or to one that is slow enough to stand on one foot."""

MARGIN_M, PATIENT_S, LEAN_M = 0.03, 0.5, 0.04
"""The foot is lifted once the capture point lies so far inside the other sole; after waiting so long, once it is no farther outside: on
feet that stand wide the far one cannot push it over, and the foot comes down beside the other one before it has got away."""

GIVEN_UP_S = 1.5
"""The weight has so long to come over the other foot; then the mending is put off."""


class Mending:
    """`side`: the foot that after a push is to be put beside the other as soon as that carries all, None where there is none."""

    def __init__(self) -> None:
        self.side: int | None = None
        self._waits_s = 0.0
        self._amiss_s = 0.0
        self._shaken_s = SHAKEN_S

    def watch(self, thrown: bool, dt: float) -> None:
        """thrown: a push was felt, or a foot begins a step that saves the balance."""
        self._shaken_s = 0.0 if thrown else self._shaken_s + dt

    @property
    def margin_m(self) -> float:
        """How far inside the other sole the capture point has to lie before the foot is lifted."""
        return -LEAN_M if self.side is not None and self._waits_s > PATIENT_S else MARGIN_M

    def drop(self) -> None:
        """It is done, or there is something else to do."""
        self.side, self._amiss_s = None, 0.0

    def closes_first(self, soles: tuple[Sole, Sole], xi: Floats, wish: Wish, up: int) -> bool:
        """The player has foot `up` in the air, but a push has just left the feet far apart, and the other one has to follow first."""
        apart_m = math.dist(soles[0].centre[:2], soles[1].centre[:2]) - math.dist(*wish.place)
        return self._shaken_s < SHAKEN_S and apart_m > FAR_APART_M and _left_behind(soles, xi) != up

    def choose(self, soles: tuple[Sole, Sole], xi: Floats, wish: Wish, sway_m: float, dt: float) -> int | None:
        """The foot to put right; both stand, as the player's do. After a push see `_shaken_amiss`.

        sway_m: from the COM to the capture point xi (2,).
        """
        shaken = self._shaken_s < SHAKEN_S
        side, share = _shaken_amiss(soles, xi, wish, sway_m) if shaken else _farthest(soles, wish)
        if self.side is not None:
            self._waits_s += dt
            if self._waits_s < GIVEN_UP_S and share > 0.5:
                return self.side
            self.drop()
        self._amiss_s = self._amiss_s + dt if share > 1.0 and (sway_m < CALM_M or shaken) else 0.0
        if self._amiss_s <= (SHAKEN_AMISS_S if shaken else AMISS_S):
            return None
        if shaken:
            self.side, self._waits_s = side, 0.0
        return side


def _farthest(soles: tuple[Sole, Sole], wish: Wish) -> tuple[int, float]:
    """The foot farthest from where it should stand, and by what share of what is let pass."""
    share = []
    for side in range(2):
        away = math.dist(wish.place[side], soles[side].centre[:2])
        share.append(max(away / ASTRAY_M, _turned(soles, wish, side) / ASTRAY_RAD))
    worst = int(share[1] > share[0])
    return worst, share[worst]


def _left_behind(soles: tuple[Sole, Sole], xi: Floats) -> int:
    """The foot farther from the capture point."""
    return int(math.dist(xi, soles[1].centre[:2]) > math.dist(xi, soles[0].centre[:2]))


def _shaken_amiss(soles: tuple[Sole, Sole], xi: Floats, wish: Wish, sway_m: float) -> tuple[int, float]:
    """The foot to put beside the other one, and by what share of what is let pass the two stand otherwise than they should.

    Of feet too far or too little apart it is the one left behind, or, of a body slow enough to choose, the one that is turned too: one step
    puts both right. Else it is the one that is turned.
    """
    apart = soles[0].centre[:2] - soles[1].centre[:2] - wish.place[0] + wish.place[1]
    place = math.hypot(*apart) / SHAKEN_ASTRAY_M
    turned = [_turned(soles, wish, side) / SHAKEN_ASTRAY_RAD for side in range(2)]
    worst = int(turned[1] > turned[0])
    if place > 1.0 and not (turned[worst] > 1.0 and sway_m < SLOW_M):
        return _left_behind(soles, xi), place
    return worst, max(place, turned[worst])


def _turned(soles: tuple[Sole, Sole], wish: Wish, side: int) -> float:
    return abs(math.remainder(wish.yaw[side] - soles[side].yaw, math.tau))
