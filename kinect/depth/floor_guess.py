"""Where to draw the floor of a room whose floor is not in view: under the lowest thing seen."""

from typing import Final

import numpy as np

from kinect.body import Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.point_cloud import point_cloud

LOWEST_SHARE: Final = 0.005
USUAL_HEIGHT_M: Final = 0.9  # of a sensor beneath or above a television
_LEVEL = np.array([0.0, 1.0, 0.0])


def guessed_floor(frame: DepthFrame, stride: int = 8) -> Floor | None:
    """The level plane 0.9 m below the sensor, or lower if need be to lie under all but half a per cent of a frame's points.

    Level as the accelerometer says, or as the sensor is where it has none.
    For drawing only: it is no measurement of a floor. None where nothing was seen.
    """
    points = point_cloud(frame.metres(), frame.intrinsics, stride)
    if len(points) < 20:
        return None
    felt = frame.up()
    up = _LEVEL if felt is None else felt
    lowest = float(np.quantile(points @ up, LOWEST_SHARE))
    return Floor(float(up[0]), float(up[1]), float(up[2]), max(USUAL_HEIGHT_M, -lowest))


class LowestGuess:
    """The lowest of the guesses for the frames it was shown."""

    def __init__(self) -> None:
        self.floor: Floor | None = None

    def see(self, frame: DepthFrame) -> None:
        """Take a frame in; the guess only ever goes down."""
        guess = guessed_floor(frame)
        if guess is not None and (self.floor is None or guess.d > self.floor.d):
            self.floor = guess
