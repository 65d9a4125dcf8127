"""Somebody who stands quietly before a sensor that cannot tell bodies yet, seen as that sensor would see him: over the floor it found."""

from dataclasses import replace

from game.floor_level import level_over_floor, seen_over_floor
from game.inputs.performer import FRAMES_PER_S
from game.inputs.puppet import Puppet
from kinect.body import BodyFrame, Floor


class StandIn:
    """Gives the frames of a quiet player at 30 a second, each with the floor that the sensor has found by then."""

    def __init__(self) -> None:
        self._standing = Puppet().poll(0.0)[0]
        assert self._standing.floor is not None
        self._level = level_over_floor(self._standing.positions, self._standing.floor)
        self._given = 0

    def poll(self, until_s: float, floor: Floor | None) -> list[BodyFrame]:
        """The frames up to `until_s`; floor: the sensor's, None while none was seen: then the player brings a level one of his own."""
        frames: list[BodyFrame] = []
        while self._given / FRAMES_PER_S <= until_s + 1e-9:
            time_s = self._given / FRAMES_PER_S
            if floor is None:
                frames.append(replace(self._standing, time_s=time_s, positions=self._standing.positions.copy()))
            else:
                frames.append(replace(self._standing, time_s=time_s, positions=seen_over_floor(self._level, floor), floor=floor))
            self._given += 1
        return frames
