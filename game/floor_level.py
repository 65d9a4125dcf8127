"""What a sensor sees, put level over its floor (thesis 3.3.1), and back: as a tilted sensor would see what is level."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from kinect.body import Floor

Floats = NDArray[np.float64]

_UP = np.array([0.0, 1.0, 0.0])


def level_over_floor(positions: Floats, floor: Floor) -> Floats:
    """Joints (..., 3) of a tilted sensor, turned by the smallest rotation that makes the floor's normal vertical and raised onto it.

    The plane need not be scaled to a unit normal. Still the sensor's axes (x left, y up, z away), the origin on the floor under the sensor.
    """
    turn, height = _levelling(floor)
    return rotation.rotate(turn, positions) + height * _UP


def seen_over_floor(level: Floats, floor: Floor) -> Floats:
    """Joints (..., 3), sensor axes but level and from the floor up, as a sensor sees them that has this floor: the inverse of levelling."""
    turn, height = _levelling(floor)
    return rotation.rotate(rotation.conjugate(turn), level - height * _UP)


def _levelling(floor: Floor) -> tuple[Floats, float]:
    """The smallest rotation (4,) that makes the floor's normal vertical, and the sensor's height over it (m)."""
    normal = np.array([floor.a, floor.b, floor.c])
    length = float(np.sqrt(normal @ normal))
    return rotation.between(normal / length, _UP), floor.d / length
