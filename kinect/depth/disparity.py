"""Raw disparity to metres and back, from the device's own calibration.

The sensor triangulates: with the zero plane at D, a pixel of P there, emitter and camera E apart and the firmware's shift S,
m = (raw / 4 - S - 0.375) P and z = D E / (E - m) (the conversion of libfreenect's src/registration.c). Gathered over raw that is

    1 / z = (B - raw) / A    with A = 4 D E / P and B = 4 E / P + 4 S + 1.5,

so inverse depth is linear in the raw code: a plane in the room is a plane in the raw picture, and noise is even over it.
"""

from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinect.device_calibration import DeviceCalibration

CODES: Final = 2048
NO_DATA: Final = 2047
FARTHEST_CODE: Final = 1050
"""Codes above it (8.8 m) are stray values; no recording we know has surfaces there."""


class InverseDepth(NamedTuple):
    """1 / z = (b - raw) / a: a in code metres, b in codes."""

    a: float
    b: float


def inverse_depth(calibration: DeviceCalibration) -> InverseDepth:
    """The two constants into which the calibration's four fold."""
    pixels = 4.0 * calibration.baseline_m / calibration.zero_plane_pixel_size_m
    return InverseDepth(pixels * calibration.zero_plane_distance_m, pixels + 4.0 * calibration.const_shift + 1.5)


@lru_cache(maxsize=16)
def metres_table(calibration: DeviceCalibration) -> NDArray[np.float32]:
    """Metres for each of the 2048 raw codes, (2048,) float32, read-only; NaN where a code means no data."""
    a, b = inverse_depth(calibration)
    raw = np.arange(CODES)
    valid = (raw <= FARTHEST_CODE) & (raw < b)
    table = np.full(CODES, np.nan, dtype=np.float32)
    table[valid] = a / (b - raw[valid])
    table.flags.writeable = False
    return table


def metres_from_raw(raw: NDArray[np.uint16], calibration: DeviceCalibration) -> NDArray[np.float32]:
    """Metres for raw codes of any shape, NaN where there is no data (a code of 11 bits is assumed)."""
    return metres_table(calibration)[raw]


def raw_from_metres(metres: ArrayLike, calibration: DeviceCalibration) -> NDArray[np.uint16]:
    """The nearest raw codes; NO_DATA where metres is NaN, not positive, or outside what the codes can say."""
    a, b = inverse_depth(calibration)
    z = np.asarray(metres, dtype=np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        raw = np.round(b - a / z)
        valid = (z > 0.0) & (raw >= 0.0) & (raw <= FARTHEST_CODE)
    return np.where(valid, raw, NO_DATA).astype(np.uint16)
