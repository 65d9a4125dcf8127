"""From the sensor's frame to the room's: the tilted sensor put level over its floor (thesis 3.3.1)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game.floor_level import level_over_floor
from game.intake.foot_contacts import STANDING, FootContacts
from kinect.body import BodyFrame, Floor, Joint

Floats = NDArray[np.float64]

ANKLE_ABOVE_SOLE_M = 0.08
SENSOR_DISTANCE_M = 2.5
"""Where the sensor hangs in the room: it stands this far in front of the world origin (thesis 4.1)."""


@dataclass(frozen=True)
class WorldFrame:
    """One frame after intake, world frame: capture time_s, joints (20, 3) m, raw (20, 3) m the same before smoothing and gate.

    contacts: what the feet do; age_s: how long the frame waited in the gate's buffer.
    """

    time_s: float
    joints: Floats
    raw: Floats
    contacts: FootContacts = STANDING
    age_s: float = 0.0


def to_world(level: Floats) -> Floats:
    """Levelled sensor axes to world axes; the one place where the two meet.

        sensor: x to its left, y up, z away        world: x forward (towards the sensor), y left, z up

                 person o  --> world x (faces the sensor)
                        |
                  world y (the person's left = sensor's -x)

    world = (2.5 m - z, -x, y): a person 2.5 m before the sensor stands at the origin and faces +x.
    """
    return np.stack((SENSOR_DISTANCE_M - level[..., 2], -level[..., 0], level[..., 1]), axis=-1)


def sensor_to_world(floor: Floor) -> tuple[Floats, Floats]:
    """turn (3, 3) and shift (3,) m of a sensor over this floor: both steps are affine, so `seen @ turn + shift` is in the world frame."""
    corners = to_world(level_over_floor(np.vstack((np.zeros(3), np.eye(3))), floor))
    return corners[1:] - corners[0], corners[0]


def floor_from_ankles(positions: Floats) -> Floor:
    """A level floor under the lower of the two ankles of one frame (20, 3), where the sensor reports none."""
    lowest = float(np.nanmin(positions[[Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT], 1]))
    return Floor(0.0, 1.0, 0.0, ANKLE_ABOVE_SOLE_M - lowest)


class Levelling:
    """Applies the frame's floor, or keeps the last one, or while there was none puts it under the lowest ankles seen so far."""

    def __init__(self) -> None:
        self._floor: Floor | None = None
        self._guessed = True
        self._offered: Floor | None = None
        self._turn, self._shift = np.eye(3), np.zeros(3)

    def apply(self, frame: BodyFrame) -> Floats:
        """Joints (20, 3) of the frame in the world frame, metres."""
        floor = frame.floor
        if floor is not None and floor == self._offered:
            pass
        elif floor is not None and all(np.isfinite(floor)) and np.hypot(np.hypot(*floor[:2]), floor[2]) > 0.1:
            self._offered, self._guessed = floor, False
            self._stand_on(floor)
        elif self._guessed:
            guess = floor_from_ankles(frame.positions)
            if self._floor is None or guess.d > self._floor.d:
                self._stand_on(guess)
        return frame.positions @ self._turn + self._shift

    def _stand_on(self, floor: Floor) -> None:
        self._floor = floor
        self._turn, self._shift = sensor_to_world(floor)
