"""The floor over time: pieces of the last seconds together, a steady answer, and a new start where the sensor is moved."""

import math
from dataclasses import replace
from typing import Final

import numpy as np

from kinect.body import Floats, Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.disparity import inverse_depth
from kinect.depth.floor import find_floor
from kinect.depth.patches import Patches, patches_of

LOOK_EVERY_S: Final = 0.5
REMEMBER_S: Final = 3.0
LOOK_AGAIN_S: Final = 5.0
STEADY_OF: Final = 5  # findings of which the median counts
MOVED: Final = float(np.cos(np.radians(2.0)))


class FloorWatch:
    """Fed with every depth frame of a sensor; looks for the floor twice a second of the frames' time, once it is sure every 5 s.

    A piece hidden for a moment counts as last seen, for 3 s. A floor once found stays while the sensor's tilt does.
    """

    def __init__(self, seed: int = 0) -> None:
        self._rng = np.random.default_rng(seed)
        self._forget("no floor was looked for yet")

    @property
    def floor(self) -> Floor | None:
        """The plane in the sensor frame, or None while no floor was seen."""
        if not self._found:
            return None
        a, b, c, d = np.median(np.array(self._found), axis=0).tolist()
        length = math.sqrt(a * a + b * b + c * c)
        return Floor(a / length, b / length, c / length, d / length)

    @property
    def hint(self) -> Floor | None:
        """While there is no floor, a plane to draw by: the level surface last seen of which too little shows, or None."""
        return None if self._found else self._hint

    @property
    def why(self) -> str:
        """In words: how far below the sensor the floor lies, or why there is none."""
        floor = self.floor
        return self._why if floor is None else f"floor {floor.d:.2f} m below the sensor"

    def see(self, frame: DepthFrame) -> Floor | None:
        """Take a frame in; gives the floor as known with it."""
        up = frame.up()
        if self._has_moved(frame, up):
            self._forget("the sensor was moved")
        wait_s = LOOK_EVERY_S if len(self._found) < STEADY_OF else LOOK_AGAIN_S
        if self._looked_s is not None and frame.time_s - self._looked_s < wait_s:
            return self.floor
        self._looked_s, self._first = frame.time_s, self._first or frame
        self._up = up if self._up is None else self._up
        self._remember(patches_of(frame), frame.time_s)
        assert self._pieces is not None
        finding = find_floor(self._pieces, inverse_depth(frame.calibration), up, int(self._rng.integers(2**32)))
        self._why, self._hint = finding.why, finding.hint or self._hint
        if finding.floor is not None:
            self._found = [*self._found[1 - STEADY_OF :], finding.floor]
        return self.floor

    def _forget(self, why: str) -> None:
        self._found: list[Floor] = []
        self._why = why
        self._hint: Floor | None = None
        self._looked_s: float | None = None
        self._first: DepthFrame | None = None
        self._up: Floats | None = None
        self._pieces: Patches | None = None
        self._seen_s: Floats = np.empty(0)

    def _has_moved(self, frame: DepthFrame, up: Floats | None) -> bool:
        if self._first is None:
            return False
        other = (frame.calibration, frame.intrinsics) != (self._first.calibration, self._first.intrinsics)
        leaning = up is not None and self._up is not None and float(up @ self._up) < MOVED
        return other or leaning or (self._looked_s is not None and frame.time_s < self._looked_s)

    def _remember(self, new: Patches, time_s: float) -> None:
        """New pieces replace the old but where the new is not flat and the old not old."""
        if self._pieces is None:
            self._pieces, self._seen_s = new, np.where(new.flat, time_s, -np.inf)
            return
        kept = ~new.flat & (time_s - self._seen_s < REMEMBER_S)
        old = self._pieces
        names = ("sums", "raw_sums", "pixels", "middle", "normal", "distance", "flat")
        fields = {
            name: np.where(kept.reshape(-1, *[1] * (getattr(new, name).ndim - 1)), getattr(old, name), getattr(new, name)) for name in names
        }
        self._pieces = replace(new, **fields)
        self._seen_s = np.where(new.flat, time_s, self._seen_s)
