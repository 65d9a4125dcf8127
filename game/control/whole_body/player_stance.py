"""The player's feet as the character is to copy them: up or down, and where in the character's world they stand."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET
from game.compiled import compiled
from game.control.whole_body.motion_window import Motion
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

FLOOR_TIME_S, PLACE_TIME_S = 1.0, 1.0
"""How fast the heights and places of two planted feet become the floor and the place that the character stands on."""


_NOWHERE = np.zeros(2)


class PlayerStance:
    """Follows which of the player's feet are up, and lays the player's world over the character's.

    The character stands where it stands: while both have both feet down, the player's place slides under the character's feet.
    """

    def __init__(self, ankle_height_m: float) -> None:
        self._rest = ankle_height_m
        self.up = [False, False]
        self.flight = False
        self.floor_z = 0.0
        self.turn_rad = 0.0
        self._cos, self._sin = 1.0, 0.0
        self._shift = np.zeros(2)

    def settle(self, target: KinematicTarget, ankles: Floats, root_yaw: float) -> None:
        """Lay the player's ankles over the character's (2, 3) and its heading over `root_yaw`."""
        theirs = _ankles(target)
        self.floor_z = float(theirs[:, 2].min()) - self._rest
        self.turn_rad = root_yaw - one.yaw(target.root_orientation)
        self._cos, self._sin = math.cos(self.turn_rad), math.sin(self.turn_rad)
        self._shift = (ankles.mean(axis=0) - self.direction(theirs.mean(axis=0)))[:2]
        self.up = [False, False]

    def watch(self, target: KinematicTarget) -> None:
        """A new frame: which feet are up."""
        self.up = [not planted for planted in target.contacts.planted]
        self.flight = target.contacts.flight

    def drift(self, target: KinematicTarget, ankles: Floats, dt: float) -> None:
        """Both stand on both feet: floor and place follow slowly."""
        theirs = 0.5 * (target.pose.joint[FEET[0]] + target.pose.joint[FEET[1]])
        self.floor_z += min(dt / FLOOR_TIME_S, 1.0) * (float(theirs[2]) - self._rest - self.floor_z)
        gap = 0.5 * (ankles[0] + ankles[1]) - self.place(theirs)
        self._shift = self._shift + min(dt / PLACE_TIME_S, 1.0) * gap[:2]

    def place(self, point: Floats) -> Floats:
        """A point (3,) of the player's world in the character's."""
        return _laid_over(point, self._shift, self._cos, self._sin, self.floor_z)

    def direction(self, vector: Floats) -> Floats:
        """A vector (3,) of the player's world in the character's."""
        return _laid_over(vector, _NOWHERE, self._cos, self._sin, 0.0)

    def orientation(self, turn: Floats) -> Floats:
        """An orientation (4,) of the player's world in the character's."""
        return one.multiply(one.about_z(self.turn_rad), turn)

    def ankle(self, motion: Motion, side: int) -> Floats:
        return self.place(motion.place[1 + side])


@compiled
def _laid_over(point: Floats, shift: Floats, c: float, s: float, floor_z: float) -> Floats:
    out = np.empty(3)
    out[0] = shift[0] + c * point[0] - s * point[1]
    out[1] = shift[1] + s * point[0] + c * point[1]
    out[2] = point[2] - floor_z
    return out


def _ankles(target: KinematicTarget) -> Floats:
    return target.pose.joint[list(FEET)]
