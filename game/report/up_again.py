"""Is a body that was shoved over back on both feet? Only its feet touch the floor, the trunk is up, the COM as high as the player's."""

import math
from collections.abc import Iterable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import FEET, PARTS
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

LARGEST_TILT_RAD = math.radians(60.0)
COM_SHARE = 0.8
"""Of the height of the player's COM on the same body, as for the upright time (thesis 4.4)."""

HELD_S = 0.25
"""It stands once it has done so for so long."""

_TRUNK = PARTS.index("trunk")


class SeenBody(Protocol):
    """What the rule looks at, world frame; physics implements it as `BodyDynamics`."""

    com: Floats
    turn: Floats

    @property
    def foot_contact(self) -> tuple[bool, bool]:
        """Left, right foot on the floor."""
        ...


def is_down(body: SeenBody, target: KinematicTarget, on_floor: Iterable[int]) -> bool:
    """on_floor: indices into `PARTS` of what touches the floor. What is not a number lies."""
    tilted = not body.turn[_TRUNK, 2, 2] > math.cos(LARGEST_TILT_RAD)
    return tilted or not body.com[2] > COM_SHARE * target.com[2] or any(part not in FEET for part in on_floor)


class UpAgain:
    """`see` every frame from the shove on. fell: it has been down; up_s: since when it stands on both feet again, None before."""

    def __init__(self) -> None:
        self.fell = False
        self.up_s: float | None = None
        self._stands_since: float | None = None

    def see(self, since_s: float, body: SeenBody, target: KinematicTarget, on_floor: Iterable[int]) -> None:
        """One frame, `since_s` after the shove began."""
        if is_down(body, target, on_floor):
            self.fell, self.up_s, self._stands_since = True, None, None
            return
        if self._stands_since is None and all(body.foot_contact):
            self._stands_since = since_s
        if self.up_s is None and self._stands_since is not None and since_s - self._stands_since > HELD_S - 1e-9:
            self.up_s = self._stands_since
