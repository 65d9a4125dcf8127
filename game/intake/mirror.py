"""Mirroring left and right: the character that faces you lifts the hand on your side of the glass."""

import numpy as np
from numpy.typing import NDArray

from kinect.body import Joint

Floats = NDArray[np.float64]

_SWAP = np.array([Joint[j.name.replace("LEFT", "?").replace("RIGHT", "LEFT").replace("?", "RIGHT")] for j in Joint])
_SIGN = np.array([1.0, -1.0, 1.0])


def mirror(joints: Floats) -> Floats:
    """World joints (..., 20, 3) reflected at the plane y = 0 with left and right joints swapped; its own inverse."""
    return joints.take(_SWAP, axis=-2) * _SIGN
