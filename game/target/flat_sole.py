"""A planted sole lies flat: a sensor sees the line from ankle to toes tilted by half a radian where the player only stands in profile."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET, PARENT
from game.compiled import compiled
from game.target.forward_kinematics import part_orientations

Floats = NDArray[np.float64]

FLAT_TIME_S = 0.12
"""How fast a sole that lands is laid flat and one that lifts is let go."""

_FEET, _SHANKS = np.array(FEET), np.array([PARENT[foot] for foot in FEET])


class FlatSoles:
    """Lays the soles of planted feet flat and lets go of those that lift, both gradually: `share` (2,) of the way is done."""

    def __init__(self) -> None:
        self.share = np.zeros(2)

    def apply(self, root: Floats, rotation: Floats, planted: tuple[bool, bool], dt: float) -> Floats:
        """(14, 4) joint rotations, child in parent, with flat soles; `root` (4,), world; the first frame, dt 0, is laid flat at once."""
        nearer = 1.0 - math.exp(-dt / FLAT_TIME_S) if dt > 0.0 else 1.0
        self.share += nearer * (np.array(planted, dtype=np.float64) - self.share)
        return laid_flat(root, rotation, self.share)


@compiled
def laid_flat(root: Floats, rotation: Floats, share: Floats) -> Floats:
    """(14, 4) joint rotations whose ankles have turned each foot by its share (2,) of the shortest way to flat; headings stay."""
    out, orientation = rotation.copy(), part_orientations(root, rotation)
    for side in range(2):
        foot = orientation[_FEET[side]]
        x, y, z = one.turn_to(foot, one.about_z(one.yaw(foot)))
        turned = one.multiply(foot, one.exp(share[side] * np.array([x, y, z])))
        out[_FEET[side] - 1] = one.normalise(one.multiply(one.conjugate(orientation[_SHANKS[side]]), turned))
    return out
