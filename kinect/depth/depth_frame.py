"""One depth picture with all that is needed to read it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinect.body import Floats
from kinect.depth.disparity import metres_from_raw
from kinect.depth.intrinsics import Intrinsics
from kinect.device_calibration import DeviceCalibration


@dataclass(frozen=True)
class DepthFrame:
    """A picture of raw disparity.

    raw: (480, 640) uint16 codes 0..2047, 2047 no data; the sensor's left is the picture's left. Treat it as read-only.
    time_s: capture time on the source's clock. ticks: the device's 60 MHz clock, wrapping at 2**32.
    accel: the accelerometer's x, y, z in counts (819 to 1 g), or None where the device has none to read.
    calibration, intrinsics: of the sensor that took it.
    """

    raw: NDArray[np.uint16]
    time_s: float
    ticks: int
    accel: tuple[int, int, int] | None
    calibration: DeviceCalibration
    intrinsics: Intrinsics

    def metres(self) -> NDArray[np.float32]:
        """(480, 640) distance along the sensor's z, metres, NaN where there is no data."""
        return metres_from_raw(self.raw, self.calibration)

    def up(self) -> Floats | None:
        """(3,) unit vector against gravity in the sensor frame, or None where the accelerometer says nothing believable."""
        return None if self.accel is None else up_from_accelerometer(self.accel)


def up_from_accelerometer(accel: tuple[int, int, int]) -> Floats | None:
    """(3,) unit up in the sensor frame; None unless about 1 g (0.8 to 1.2) is felt, as in a sensor at rest.

    The counts' axes are the sensor frame's: z grows as the sensor looks up, x as its left side rises. The sign of x was found
    on a real recording, whose two walls meet in a vertical edge 1 degree from this reading and 3 degrees from its mirror image.
    """
    counts = np.array(accel, dtype=np.float64)
    size = float(np.sqrt(counts @ counts))
    return counts / size if 0.8 < size / COUNTS_PER_G < 1.2 else None


COUNTS_PER_G = 819.0
