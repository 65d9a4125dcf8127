"""The player's feet as the character is to copy them: up or down, and where in the character's world they stand."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET
from game.compiled import compiled
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

FLOOR_TIME_S, PLACE_TIME_S = 1.0, 1.0
"""How fast the heights and places of two planted feet become the floor and the place that the character stands on."""

PIVOT_TIME_S = 0.1
"""How fast the place of the foot that stays does while the other one is put where the player has it."""

Overlay = tuple[float, float, float, float, float]
"""How one world lies over another: x, y (m), cosine and sine of the turn, height of the floor (m)."""


class PlayerStance:
    """Follows which of the player's feet are up, and lays the player's world over the character's.

    The character stands where it stands: while both have both feet down, the player's place slides under the character's feet.
    overlay: of the player's world, as compiled code takes it.
    """

    def __init__(self, ankle_height_m: float) -> None:
        self._rest = ankle_height_m
        self.up = [False, False]
        self.flight = False
        self.turn_rad = 0.0
        self.overlay: Overlay = (0.0, 0.0, 1.0, 0.0, 0.0)

    @property
    def floor_z(self) -> float:
        """Height of the player's floor in the player's world, m."""
        return self.overlay[4]

    def settle(self, target: KinematicTarget, ankles: Floats, root_yaw: float) -> None:
        """Lay the player's ankles over the character's (2, 3) and its heading over `root_yaw`."""
        theirs = _ankles(target)
        self.turn_rad = root_yaw - one.yaw(target.root_orientation)
        turn = math.cos(self.turn_rad), math.sin(self.turn_rad)
        self.overlay = (0.0, 0.0, *turn, float(theirs[:, 2].min()) - self._rest)
        x, y, _ = (ankles.mean(axis=0) - self.direction(theirs.mean(axis=0))).tolist()
        self.overlay = (x, y, *self.overlay[2:])
        self.up = [False, False]

    def watch(self, target: KinematicTarget) -> None:
        """A new frame: which feet are up."""
        self.up = [not planted for planted in target.contacts.planted]
        self.flight = target.contacts.flight

    def drift(self, target: KinematicTarget, ankles: Floats, pivot: int | None, moved: bool, dt: float) -> None:
        """Both stand on both feet: floor and place follow slowly; fast where the body `moved` by steps of its own, and the place of the one
        foot `pivot` that is to stay."""
        left = 0.5 if pivot is None else 1.0 - pivot
        place_s = PLACE_TIME_S if pivot is None and not moved else PIVOT_TIME_S
        floor, place = min(dt / FLOOR_TIME_S, 1.0), min(dt / place_s, 1.0)
        self.overlay = _drifted(self.overlay, target.pose.joint, ankles, left, self._rest, floor, place)

    def place(self, point: Floats) -> Floats:
        """A point (3,) of the player's world in the character's."""
        return laid_over(point, self.overlay)

    def direction(self, vector: Floats) -> Floats:
        """A vector (3,) of the player's world in the character's."""
        return turned_over(vector, self.overlay)

    def orientation(self, turn: Floats) -> Floats:
        """An orientation (4,) of the player's world in the character's."""
        return one.multiply(one.about_z(self.turn_rad), turn)


@compiled
def laid_over(point: Floats, overlay: Overlay) -> Floats:
    """A point (3,) of the world above in the world below."""
    x, y, c, s, floor_z = overlay
    out = np.empty(3)
    out[0] = x + c * point[0] - s * point[1]
    out[1] = y + s * point[0] + c * point[1]
    out[2] = point[2] - floor_z
    return out


@compiled
def turned_over(vector: Floats, overlay: Overlay) -> Floats:
    """A vector (3,) of the world above in the world below."""
    return laid_over(vector, (0.0, 0.0, overlay[2], overlay[3], 0.0))


@compiled
def _drifted(
    overlay: Overlay, joint: Floats, ankles: Floats, left: float, rest_m: float, floor_share: float, place_share: float
) -> Overlay:  # fmt: skip
    """The overlay once joint (15, 3) of the player has come nearer to the character's floor and ankles (2, 3), by a share each.

    left: what the left ankle counts; the right one counts the rest.
    """
    x, y, c, s, floor_z = overlay
    theirs = 0.5 * (joint[FEET[0]] + joint[FEET[1]])
    stands = left * joint[FEET[0]] + (1.0 - left) * joint[FEET[1]]
    gap = left * ankles[0] + (1.0 - left) * ankles[1] - laid_over(stands, overlay)
    return x + place_share * gap[0], y + place_share * gap[1], c, s, floor_z + floor_share * (theirs[2] - rest_m - floor_z)


def _ankles(target: KinematicTarget) -> Floats:
    return target.pose.joint[list(FEET)]
