"""Has a pushed character recovered? Only its feet touched the floor, the trunk stayed up, few steps, and back in the player's stance."""

import math
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET, PARTS
from game.report.tracking_error import PosedBody, in_heading
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

LARGEST_TILT_RAD = math.radians(60.0)
MOST_STEPS = 3
LIMIT_S = 4.0
"""So long after the push began it is judged; the stance must be the player's again by then, after the push and the last step."""

STANCE_M, STANCE_RAD = 0.10, math.radians(10.0)
HELD_S = 0.25
"""The player's stance counts once it has lasted so long."""

LATE_S = 0.15
"""It is held against whatever the player showed so long before: a character follows with a latency."""

STEP_M = 0.05
"""A foot that comes down this much farther from where it stood than the player's own foot went has taken a step."""

STOOD_S = 0.05
"""It has come down once it has touched the floor for so long: a sole that grazes the floor on its way has not."""

_FEET = np.array(FEET)
_TRUNK = PARTS.index("trunk")


class SeenBody(PosedBody, Protocol):
    """What the rule looks at, world frame; physics implements it as `BodyDynamics`."""

    @property
    def foot_contact(self) -> tuple[bool, bool]:
        """Left, right foot on the floor."""
        ...


@dataclass(frozen=True)
class Stance:
    """ankle (2, 3) m from the root and yaw (2,) rad of the feet, in the heading; up (3,) of the trunk, in the heading; heading rad."""

    ankle: Floats
    yaw: Floats
    up: Floats
    heading: float


def stance_of(joint: Floats, orientation: Floats) -> Stance:
    """Of joints (15, 3) and orientations (15, 4)."""
    heading = one.yaw(orientation[0])
    yaws = np.array([one.wrapped(one.yaw(orientation[foot]) - heading) for foot in FEET])
    up = one.turn_back(one.matrix(one.about_z(heading)), np.ascontiguousarray(one.matrix(orientation[_TRUNK])[:, 2]))
    return Stance(in_heading(joint[_FEET], joint[0], orientation[0]), yaws, up, heading)


def apart(a: Stance, b: Stance, turned_rad: float) -> tuple[float, float]:
    """How far a is from b: m of the farther foot, rad of the worst of the feet's, the trunk's and the whole body's direction.

    turned_rad: by how much a's world is turned against b's.
    """
    away = float(np.linalg.norm(a.ankle - b.ankle, axis=1).max())
    angles = [abs(one.wrapped(float(yaw))) for yaw in a.yaw - b.yaw]
    angles += [math.acos(min(1.0, max(-1.0, float(a.up @ b.up)))), abs(one.wrapped(a.heading - b.heading - turned_rad))]
    return away, max(angles)


class Recovery:
    """Judges one push, which lasts `push_s`: `see` every frame from its beginning on. `outcome` is "" until it is known.

    Then it is "recovered" or what went wrong. steps: how many were taken; back_s: since when the stance is the player's again, None
    before; tilt_rad: the largest of the trunk; away_m, away_rad: from the player's stance in the last frame.
    """

    def __init__(self, body: SeenBody, target: KinematicTarget, push_s: float) -> None:
        self._push_s = push_s
        now = stance_of(body.joint, body.orientation)
        self._turned = now.heading - one.yaw(target.root_orientation)
        self._shown: deque[tuple[float, Stance]] = deque()
        self._stood = body.joint[_FEET].copy()
        self._player_stood = target.pose.joint[_FEET].copy()
        self._off = [not on for on in body.foot_contact]
        self._touches_since: list[float | None] = [None, None]
        self._near_since: float | None = None
        self.steps = 0
        self.tilt_rad = 0.0
        self.back_s: float | None = None
        self.away_m = self.away_rad = 0.0
        self.outcome = ""

    def see(self, since_s: float, body: SeenBody, target: KinematicTarget, on_floor: Iterable[int]) -> None:
        """One frame, `since_s` after the push began; on_floor: indices into `PARTS` of what touch the floor."""
        if self.outcome:
            return
        before = self.steps
        self._count_steps(since_s, body, target)
        if since_s <= self._push_s or self.steps > before:
            self._near_since = self.back_s = None
        own = stance_of(body.joint, body.orientation)
        self._look_for_stance(since_s, own, any(body.foot_contact), target)
        up = float(own.up[2])
        # asked this way round, a tilt that is not a number has fallen too
        self.tilt_rad = max(self.tilt_rad, math.acos(min(1.0, max(-1.0, up)))) if up == up else math.pi
        others = sorted(PARTS[part] for part in on_floor if part not in FEET)
        if others:
            self.outcome = f"{others[0].replace('_', ' ')} on the floor"
        elif self.tilt_rad > LARGEST_TILT_RAD:
            self.outcome = "trunk down"
        elif self.steps > MOST_STEPS:
            self.outcome = "too many steps"
        elif since_s >= LIMIT_S:
            self.outcome = "recovered" if self.back_s is not None else "not back in stance"

    def _count_steps(self, since_s: float, body: SeenBody, target: KinematicTarget) -> None:
        for side, touches in enumerate(body.foot_contact):
            before = self._touches_since[side]
            began_s = since_s if before is None else before
            self._touches_since[side] = began_s if touches else None
            if touches and self._off[side] and since_s - began_s < STOOD_S - 1e-9:
                continue
            place, players = body.joint[FEET[side]], target.pose.joint[FEET[side]]
            if touches and self._off[side]:
                own = math.dist(place[:2], self._stood[side, :2])
                self.steps += own > STEP_M + math.dist(players[:2], self._player_stood[side, :2])
                self._stood[side], self._player_stood[side] = place, players
            self._off[side] = not touches

    def _look_for_stance(self, since_s: float, own: Stance, stands: bool, target: KinematicTarget) -> None:
        self._shown.append((since_s, stance_of(target.pose.joint, target.pose.orientation)))
        while self._shown[0][0] < since_s - LATE_S - 1e-9:
            self._shown.popleft()
        self.away_m, self.away_rad = min((apart(own, shown, self._turned) for _, shown in self._shown), key=_share)
        if not stands or _share((self.away_m, self.away_rad)) > 1.0:
            self._near_since = None
            return
        if self._near_since is None:
            self._near_since = since_s
        if self.back_s is None and since_s - self._near_since > HELD_S - 1e-9:
            self.back_s = self._near_since


def _share(away: tuple[float, float]) -> float:
    """Of what is allowed, the larger of metres and radians."""
    return max(away[0] / STANCE_M, away[1] / STANCE_RAD)
