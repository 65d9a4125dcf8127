"""A synthetic person before a synthetic sensor: the eight motions of thesis Table 1 as body frames.

The sensor stands level, 0.9 m above the floor, 2.5 m from the person (thesis 4.1):

    world   X towards the sensor, Y to the person's left, Z up, origin on the floor below the standing person
    sensor  x = -Y,  y = Z - 0.9,  z = 2.5 - X
"""

import math
from collections.abc import Sequence
from functools import cached_property

import numpy as np

from game.inputs.performance.repertoire import SCRIPTS, motion
from kinect.body import JOINT_COUNT, BodyFrame, Floats, Floor

FRAMES_PER_S = 30.0
SENSOR_HEIGHT_M = 0.9
SENSOR_DISTANCE_M = 2.5
FLOOR = Floor(0.0, 1.0, 0.0, SENSOR_HEIGHT_M)
NAMES: tuple[str, ...] = tuple(SCRIPTS)
"""Every motion a performer knows; the first eight are the clips of thesis Table 1."""


def to_sensor(world: Floats) -> Floats:
    """(..., 3) world points as the performer's sensor sees them, metres."""
    return np.stack([-world[..., 1], world[..., 2] - SENSOR_HEIGHT_M, SENSOR_DISTANCE_M - world[..., 0]], axis=-1)


def performed_joints(name: str, t: Floats | Sequence[float] | float) -> Floats:
    """(T, 20, 3) true joints of the motion at times t, seconds, held before 0 and after its end; metres, world frame.

    ValueError on an unknown name.
    """
    return motion(name).joints(np.asarray(t, float))


class Performer:
    """A `BodySource` that performs one motion at 30 frames a second, exactly as it is: no noise, every joint tracked."""

    def __init__(self, name: str, player: int = 0) -> None:
        """name: one of NAMES, else ValueError. player: the number its frames carry."""
        self._motion = motion(name)
        self._player = player
        self._next = 0
        self.name = name

    @property
    def status(self) -> str:
        if self._next > self._last:
            return f"The performer has finished {self.name}."
        return f"The performer is {_DOING.get(self.name, self.name)}, {self._next / FRAMES_PER_S:.1f} of {self.length_s:.1f} s."

    @property
    def length_s(self) -> float:
        return self._motion.length_s

    @cached_property
    def _last(self) -> int:
        return math.floor(self.length_s * FRAMES_PER_S + 1e-9)

    @cached_property
    def _positions(self) -> Floats:
        """(T, 20, 3) of every frame, sensor frame: sampled at once, many times cheaper than frame by frame."""
        return to_sensor(self._motion.joints(np.arange(self._last + 1) / FRAMES_PER_S))

    def poll(self, until_s: float) -> list[BodyFrame]:
        last = min(math.floor(until_s * FRAMES_PER_S + 1e-9), self._last)
        due = range(self._next, last + 1)
        self._next = max(self._next, last + 1)
        return [BodyFrame(k / FRAMES_PER_S, self._positions[k].copy(), np.ones(JOINT_COUNT), self._player, FLOOR) for k in due]

    def close(self) -> None:
        self._next = self._last + 1


_DOING = {"jump": "jumping"}
