"""Somebody who stands quietly before a sensor that cannot tell bodies yet, seen as that sensor would see him: over the floor it found."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.inputs.performer import FRAMES_PER_S
from game.inputs.puppet import Puppet
from kinect.body import BodyFrame, Floor

Floats = NDArray[np.float64]

_UP = np.array([0.0, 1.0, 0.0])


class StandIn:
    """Gives the frames of a quiet player at 30 a second, each with the floor that the sensor has found by then."""

    def __init__(self) -> None:
        self._standing = Puppet().poll(0.0)[0]
        assert self._standing.floor is not None
        self._level = _level(self._standing.positions, self._standing.floor)
        self._given = 0

    def poll(self, until_s: float, floor: Floor | None) -> list[BodyFrame]:
        """The frames up to `until_s`; floor: the sensor's, None while none was seen: then the player brings a level one of his own."""
        frames: list[BodyFrame] = []
        while self._given / FRAMES_PER_S <= until_s + 1e-9:
            time_s = self._given / FRAMES_PER_S
            if floor is None:
                frames.append(replace(self._standing, time_s=time_s, positions=self._standing.positions.copy()))
            else:
                frames.append(replace(self._standing, time_s=time_s, positions=seen_over(self._level, floor), floor=floor))
            self._given += 1
        return frames


def seen_over(level: Floats, floor: Floor) -> Floats:
    """Joints (..., 3), sensor axes but level and from the floor up, as a sensor sees them that has this floor: the inverse of levelling."""
    turn, height = _levelling(floor)
    return rotation.rotate(rotation.conjugate(turn), level - height * _UP)


def _level(positions: Floats, floor: Floor) -> Floats:
    turn, height = _levelling(floor)
    return rotation.rotate(turn, positions) + height * _UP


def _levelling(floor: Floor) -> tuple[Floats, float]:
    """The smallest rotation (4,) that makes the floor's normal vertical, and the sensor's height over it (m)."""
    normal = np.array([floor.a, floor.b, floor.c])
    length = float(np.sqrt(normal @ normal))
    return rotation.between(normal / length, _UP), floor.d / length
