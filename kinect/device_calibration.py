"""What one Kinect v1 knows of its own optics: the four numbers that turn its raw disparity into metres."""

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True)
class DeviceCalibration:
    """The factory's calibration of one device, as it reports it.

    zero_plane_distance_m: distance of the reference plane on which the dot pattern was recorded, metres (D).
    zero_plane_pixel_size_m: what one pixel of the 1280-wide infrared picture covers on that plane, metres (P).
    baseline_m: distance between the emitter of the pattern and the infrared camera, metres (E).
    const_shift: the raw disparity's offset, in units of four raw steps (S).
    is_typical: True where these are the usual numbers, since the device could not be asked.

    With m = (raw / 4 - S - 0.375) P, a raw disparity lies at z = D E / (E - m) metres, where m < E.
    """

    zero_plane_distance_m: float
    zero_plane_pixel_size_m: float
    baseline_m: float
    const_shift: float
    is_typical: bool = False

    @property
    def focal_px(self) -> float:
        """Focal length of the 640x480 depth picture, pixels: D / P at 1280 pixels width, so half of it here."""
        return self.zero_plane_distance_m / self.zero_plane_pixel_size_m / 2.0


TYPICAL: Final = DeviceCalibration(1.20, 0.001042, 0.075, 200.0, is_typical=True)
"""The usual factory numbers: z = 345.49 / (1089.41 - raw) metres, focal length 575.8 px."""
