"""Where a depth pixel looks: focal length and centre of the depth picture."""

from dataclasses import dataclass
from typing import Final

from kinect.device_calibration import DeviceCalibration

WIDTH: Final = 640
HEIGHT: Final = 480


@dataclass(frozen=True)
class Intrinsics:
    """Pinhole of a 640 x 480 depth picture, pixels: focal length and the pixel (centre_u, centre_v) straight ahead.

    Pixels run right and down, the sensor's x left and y up: x = -(u - centre_u) z / focal, y = -(v - centre_v) z / focal.
    """

    focal_px: float
    centre_u: float = WIDTH / 2
    centre_v: float = HEIGHT / 2


MICROSOFT_SDK: Final = Intrinsics(571.26)
"""What the SDK's own skeletons are drawn with; right for recordings of Kinect Studio."""


def factory_intrinsics(calibration: DeviceCalibration) -> Intrinsics:
    """The pinhole that the device's calibration implies."""
    return Intrinsics(calibration.focal_px)
