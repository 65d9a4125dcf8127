"""Millimetres back to raw disparity: which device's codes a recording's millimetres once were."""

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.depth.disparity import NO_DATA, inverse_depth, metres_from_raw, raw_from_metres
from kinect.device_calibration import TYPICAL, DeviceCalibration

MILLIMETRES: Final = 2**16
COHERENT: Final = 0.95
SPREAD: Final = np.linspace(0.94, 1.06, 1201)
"""Devices differ by a few per cent in the product of baseline, focal length and plane distance."""


@dataclass(frozen=True)
class DisparityGrid:
    """calibration: under which the codes give the millimetres back; codes (65536,) uint16: the code of each millimetre value.

    worst_mm: how far the farthest-off of the values asked for lies from its code's own distance.
    """

    calibration: DeviceCalibration
    codes: NDArray[np.uint16]
    worst_mm: float


def disparity_grid(millimetres: NDArray[np.uint16]) -> DisparityGrid:
    """The grid on which values (N,) in millimetres lie (0 is no data), at best the typical device's but for the grid's phase.

    With 1 / z = (b - raw) / a and integer raw, a / z of all values shares one fraction, b's: the mean of exp(2 pi i a / z) has length 1
    at the device's own a, and its angle is b's fraction.
    """
    values = np.unique(millimetres[millimetres > 0]).astype(np.float64) / 1000.0
    a, b = inverse_depth(TYPICAL)
    if len(values) == 0:
        return _grid(TYPICAL, values)
    phase = _mean_turn(np.array([a]), values)[0]
    if abs(phase) < COHERENT and len(values) >= 8:
        tried = a * SPREAD
        turns = _mean_turn(tried, values)
        best = int(np.argmax(np.abs(turns)))
        a, phase = float(tried[best]), turns[best]
    offset = (np.angle(phase) / (2.0 * np.pi) - b + 0.5) % 1.0 - 0.5
    shifted = replace(TYPICAL, zero_plane_distance_m=TYPICAL.zero_plane_distance_m * a / inverse_depth(TYPICAL).a)
    return _grid(replace(shifted, const_shift=TYPICAL.const_shift + float(offset) / 4.0, is_typical=False), values)


def _mean_turn(tried: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.complex128]:
    return np.exp(2j * np.pi * tried[:, None] / values).mean(axis=1)


def _grid(calibration: DeviceCalibration, values: NDArray[np.float64]) -> DisparityGrid:
    codes = raw_from_metres(np.arange(MILLIMETRES) / 1000.0, calibration)
    raw = raw_from_metres(values, calibration)
    there = raw != NO_DATA
    off = np.abs(metres_from_raw(raw[there], calibration).astype(np.float64) - values[there]) * 1000.0
    return DisparityGrid(calibration, codes, float(off.max(initial=0.0)))
