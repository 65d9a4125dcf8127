"""What becomes of a body that has lost its balance: it falls, lies, gets up by key poses, stands up; or stays down after too many tries."""

from enum import Enum

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import JOINT_COUNT, PARTS
from game.control.joint_command import BodyState, JointCommand
from game.control.whole_body.falling import fall
from game.control.whole_body.getting_up import GettingUp, is_ready, nearer_route_of, route_of

Floats = NDArray[np.float64]

MOST_TRIES = 4
"""The first and three more; who is still down then stays down."""

LEAST_FALL_S, MOST_FALL_S = 0.5, 2.5
"""A fall lasts so long at least; after the other time it is over, whatever still moves."""

REST_M_S, REST_RAD_S = 0.2, 2.0
"""A body lies once its COM and the fastest of its joints move no faster."""

UP_SHARE, LOW_M = 0.85, 0.3
"""Who stands up is up at this share of the player's COM height, and has fallen again with the COM below the other."""

STAND_UP_S = 2.5
"""Who is not up so long after the feet have taken over begins anew."""

_TRUNK = PARTS.index("trunk")
_NOTHING = np.zeros(3 * JOINT_COUNT)


class Stage(Enum):
    UP = "keeps its balance"
    FALLING = "falls"
    GETTING_UP = "gets up"
    STANDING_UP = "stands up"
    DOWN = "stays down"


class OnTheFloor:
    """stage; tries: how often it has begun to get up since it last stood; falls: how often it lost its balance."""

    def __init__(self) -> None:
        self.stage, self.tries, self.falls = Stage.UP, 0, 0
        self._since_s = 0.0
        self._try: GettingUp | None = None

    @property
    def lies(self) -> bool:
        """It has fallen: key poses or nothing at all move it, not the balance."""
        return self.stage in (Stage.FALLING, Stage.GETTING_UP, Stage.DOWN)

    @property
    def stays_down(self) -> bool:
        return self.stage is Stage.DOWN

    def fall(self) -> None:
        """The balance is lost, once more perhaps."""
        self._enter(Stage.FALLING)
        self.falls += 1

    def _enter(self, stage: Stage) -> None:
        self.stage, self._since_s = stage, 0.0

    def rise(self, com_height: float, players_height: float, dt: float) -> None:
        """The feet have taken over: is it up again?"""
        self._since_s += dt
        if com_height > UP_SHARE * players_height:
            self._enter(Stage.UP)
            self.tries = 0
        elif self._since_s > STAND_UP_S or com_height < LOW_M:
            self.fall()

    def stands_ready(self, body: BodyState, gets_up: bool, dt: float) -> bool:
        """One tick further; True once the feet can take over. gets_up: False for a body that is to stay where it lies."""
        self._since_s += dt
        if self.stage is Stage.FALLING and gets_up and self._rests(body):
            if is_ready(body):
                self._enter(Stage.STANDING_UP)
                return True
            self._begin(body)
        if self.stage is not Stage.GETTING_UP or self._try is None:
            return False
        if self._try.comes_to_stand and is_ready(body):
            self._enter(Stage.STANDING_UP)
            return True
        if self._try.has_ended:
            self._go_on(body)
        elif self._try.tips_over(body):
            self._begin(body)
        return False

    def _go_on(self, body: BodyState) -> None:
        """Who has rolled over takes the next route, who has not tries once more; who does not stand rests first."""
        now, before = nearer_route_of(body), self._try.route if self._try is not None else ""
        if before == "prone":
            self.fall()
        elif now == before:
            self._begin(body)
        else:
            self._try = GettingUp(body, now)

    def _rests(self, body: BodyState) -> bool:
        if self._since_s < LEAST_FALL_S:
            return False
        calm = float(np.abs(body.velocity[6:]).max()) < REST_RAD_S and float(np.linalg.norm(body.com_velocity)) < REST_M_S
        return calm or self._since_s > MOST_FALL_S

    def _begin(self, body: BodyState) -> None:
        if self.tries == MOST_TRIES:
            self._enter(Stage.DOWN)
            return
        self.tries += 1
        self._try = GettingUp(body, route_of(body))
        self._enter(Stage.GETTING_UP)

    def command(self, body: BodyState, strength: Floats, scale: float, dt: float) -> JointCommand:
        """Of a body that lies. strength (2, 42) N m of a man's joints, to either side; it gets up with so many times as much."""
        rotation, kp, kd = np.empty((JOINT_COUNT, 4)), np.empty(3 * JOINT_COUNT), np.empty(3 * JOINT_COUNT)
        if self.stage is Stage.GETTING_UP and self._try is not None:
            low, high = scale * strength
            self._try.drive(body, low, high, dt, rotation, kp, kd)
        else:
            inertia = np.ascontiguousarray(np.diagonal(body.equations[0])[6:])
            fall(self._since_s, body.turn[_TRUNK], body.joint_rotation, inertia, rotation, kp, kd)
        return JointCommand(rotation, _NOTHING, kp, kd, _NOTHING)
