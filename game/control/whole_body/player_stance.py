"""The player's feet as the character is to copy them: up or down, and where in the character's world they stand."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.control.whole_body.motion_window import Motion
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

FLOOR_TIME_S, PLACE_TIME_S = 1.0, 1.0
"""How fast the heights and places of two planted feet become the floor and the place that the character stands on."""


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
        self._shift = np.zeros(2)

    def settle(self, target: KinematicTarget, ankles: Floats, root_yaw: float) -> None:
        """Lay the player's ankles over the character's (2, 3) and its heading over `root_yaw`."""
        theirs = _ankles(target)
        self.floor_z = float(theirs[:, 2].min()) - self._rest
        self.turn_rad = root_yaw - one.yaw(target.root_orientation)
        self._shift = ankles.mean(axis=0)[:2] - self._turned(theirs.mean(axis=0)[:2])
        self.up = [False, False]

    def watch(self, target: KinematicTarget) -> None:
        """A new frame: which feet are up."""
        self.up = [not planted for planted in target.contacts.planted]
        self.flight = target.contacts.flight

    def drift(self, target: KinematicTarget, ankles: Floats, dt: float) -> None:
        """Both stand on both feet: floor and place follow slowly."""
        theirs = _ankles(target)
        self.floor_z += min(dt / FLOOR_TIME_S, 1.0) * (float(theirs[:, 2].mean()) - self._rest - self.floor_z)
        gap = ankles.mean(axis=0)[:2] - self.place(theirs.mean(axis=0))[:2]
        self._shift += min(dt / PLACE_TIME_S, 1.0) * gap

    def place(self, point: Floats) -> Floats:
        """A point (3,) of the player's world in the character's."""
        out = np.empty(3)
        out[:2] = self._shift + self._turned(point[:2])
        out[2] = point[2] - self.floor_z
        return out

    def direction(self, vector: Floats) -> Floats:
        """A vector (3,) of the player's world in the character's."""
        out = vector.copy()
        out[:2] = self._turned(vector[:2])
        return out

    def orientation(self, turn: Floats) -> Floats:
        """An orientation (4,) of the player's world in the character's."""
        return one.multiply(one.about_z(self.turn_rad), turn)

    def ankle(self, motion: Motion, side: int) -> Floats:
        return self.place(motion.place[1 + side])

    def _turned(self, xy: Floats) -> Floats:
        c, s = math.cos(self.turn_rad), math.sin(self.turn_rad)
        return np.array([c * xy[0] - s * xy[1], s * xy[0] + c * xy[1]])


def _ankles(target: KinematicTarget) -> Floats:
    return target.pose.joint[[11, 14]]
