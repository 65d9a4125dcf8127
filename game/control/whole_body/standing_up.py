"""Standing up once the feet have taken over: the pose and the height that are asked for go from the body's own to the player's."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game import rotation_compiled as one
from game.characters.skeleton import JOINT_COUNT
from game.control.joint_command import BodyState
from game.control.whole_body.motion_window import Motion
from game.control.whole_body.player_stance import PlayerStance

Floats = NDArray[np.float64]

STAND_UP_S = 1.0
"""How long the way up takes, of minimum jerk."""

_BLENDED = JOINT_COUNT + 1
"""Of the turns of a `Motion` the joints and the root; feet stay where they are."""

_COM = 3


class StandingUp:
    """Begins in the body's pose, laid into the player's world as `player` lies over its own."""

    def __init__(self, body: BodyState, player: PlayerStance) -> None:
        self._since_s = 0.0
        self._turn = np.concatenate((body.joint_rotation, [one.multiply(one.about_z(-player.turn_rad), body.orientation[0])]))
        self._height = float(body.com[2]) + player.floor_z

    @property
    def done(self) -> bool:
        return self._since_s >= STAND_UP_S

    def on_the_way(self, motion: Motion, dt: float) -> Motion:
        """What to follow now, on the way to `motion`; takes `dt` more with each call."""
        self._since_s += dt
        s = min(self._since_s / STAND_UP_S, 1.0)
        share, rate = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s), 30.0 * s * s * (1.0 - s) ** 2 / STAND_UP_S
        surge = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / STAND_UP_S**2
        turn, spin, spin_rate = motion.turn.copy(), share * motion.spin, share * motion.spin_rate
        way = rotation.log(rotation.multiply(rotation.conjugate(self._turn), motion.turn[:_BLENDED]))
        turn[:_BLENDED] = rotation.multiply(self._turn, rotation.exp(share * way))
        spin[:_BLENDED] += rate * way
        spin_rate[:_BLENDED] += surge * way
        place, velocity, acceleration = motion.place.copy(), motion.velocity.copy(), motion.acceleration.copy()
        rise = place[_COM, 2] - self._height
        place[_COM, 2] = self._height + share * rise
        velocity[_COM, 2] = share * velocity[_COM, 2] + rate * rise
        acceleration[_COM, 2] = share * acceleration[_COM, 2] + surge * rise
        return Motion(turn, spin, spin_rate, place, velocity, acceleration)
