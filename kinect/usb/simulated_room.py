"""A living room as a Kinect would see it: floor, wall, ceiling and a person of boxes who lifts an arm, as raw disparity."""

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.device_calibration import TYPICAL, DeviceCalibration
from kinect.usb.packing import pack11
from kinect.usb.simulated_stream import FrameSource

NO_DATA: Final = 2047
NEAREST_M, FARTHEST_M = 0.5, 8.8
BLIND_COLUMNS: Final = 8
# (left, right, low, high) in metres beside and above the person's place
PERSON: Final = (
    (-0.10, 0.10, 1.50, 1.75),
    (-0.20, 0.20, 0.85, 1.45),
    (-0.17, -0.03, 0.0, 0.85),
    (0.03, 0.17, 0.0, 0.85),
    (-0.32, -0.22, 0.80, 1.42),
)
CYCLE_FRAMES: Final = 60
HELD_FRAMES: Final = 4
"""Each picture is sent so many times, since it takes as long to paint as to send."""


@dataclass(frozen=True)
class Room:
    """height_m, pitch_rad: of the sensor above the floor, and how far it looks up. valid: share of the pixels that see anything at all."""

    height_m: float = 0.9
    pitch_rad: float = 0.0
    wall_m: float = 3.8
    ceiling_m: float = 2.5
    person_m: float = 2.6
    valid: float = 0.97
    seed: int = 0

    @property
    def counts(self) -> tuple[int, int, int]:
        """What the accelerometer reads."""
        return (0, round(812 * math.cos(self.pitch_rad)), round(812 * math.sin(self.pitch_rad)))

    def depth(self, k: int) -> NDArray[np.float64]:
        """(480, 640) metres along the sensor's axis in frame k; infinite where nothing is."""
        f = TYPICAL.focal_px
        x = -(np.arange(640) - 320.0)[None, :] / f
        y = -(np.arange(480) - 240.0)[:, None] / f
        rise = y * math.cos(self.pitch_rad) + math.sin(self.pitch_rad)  # of height, per metre along the axis
        reach = math.cos(self.pitch_rad) - y * math.sin(self.pitch_rad)  # of level distance, per metre along the axis
        with np.errstate(divide="ignore"):
            surfaces = np.stack([-self.height_m / rise, (self.ceiling_m - self.height_m) / rise, self.wall_m / reach])
        z = np.min(np.where(surfaces > 0, surfaces, np.inf), axis=0) + 0 * x
        person = self.person_m / reach
        beside, above = x * person, self.height_m + rise * person
        lifted = 0.60 * (0.5 - 0.5 * math.cos(2 * math.pi * k / CYCLE_FRAMES))
        for left, right, low, high in (*PERSON, (0.22, 0.32, 0.80 + lifted, 1.42 + lifted)):
            hit = (beside >= left) & (beside <= right) & (above >= low) & (above <= high)
            z = np.where(hit, np.minimum(z, person), z)
        return z

    def disparity(self, k: int, calibration: DeviceCalibration = TYPICAL) -> NDArray[np.uint16]:
        """(480, 640) raw disparity of frame k, 2047 where the sensor sees nothing. The inverse of z = D E / (E - m)."""
        z = self.depth(k)
        c = calibration
        m = c.baseline_m - c.zero_plane_distance_m * c.baseline_m / z
        raw = 4.0 * (m / c.zero_plane_pixel_size_m + c.const_shift + 0.375)
        unseen = (z < NEAREST_M) | (z > FARTHEST_M) | (np.random.default_rng((self.seed, k)).random(z.shape) > self.valid)
        unseen[:, -BLIND_COLUMNS:] = True
        return np.where(unseen, NO_DATA, np.round(raw)).astype(np.uint16)

    def source(self, calibration: DeviceCalibration = TYPICAL) -> FrameSource:
        """The room as a simulated camera sends it, two seconds over and over."""
        made: dict[int, NDArray[np.uint8]] = {}

        def frame(k: int) -> NDArray[np.uint8]:
            k = k % CYCLE_FRAMES // HELD_FRAMES * HELD_FRAMES
            if k not in made:
                made[k] = pack11(self.disparity(k, calibration))
            return made[k]

        return frame
