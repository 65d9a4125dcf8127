"""Asking the camera for its own calibration."""

import math
import struct
from typing import Final

from kinect.device_calibration import TYPICAL, DeviceCalibration
from kinect.usb.command import CameraCommands
from kinect.usb.errors import KinectError

FIXED_PARAMETERS: Final = 0x04
ALGORITHM_PARAMETERS: Final = 0x16
CONST_SHIFT: Final = 0x00
_FLOATS: Final = struct.Struct("<ffff")
_FLOATS_AT: Final = 92  # behind the reply's error word
_CM: Final = 0.01


def read_calibration(commands: CameraCommands) -> DeviceCalibration:
    """What the device reports, or TYPICAL where it refuses or reports nonsense. Ask while no stream runs. A USBError passes through."""
    try:
        fixed = commands.ask(FIXED_PARAMETERS, struct.pack("<5H", 0, 0, 0, 0, 0))
        shift = commands.ask(ALGORITHM_PARAMETERS, struct.pack("<5H", CONST_SHIFT, 0, 1, 30, 0))
    except KinectError:
        return TYPICAL
    return parse_calibration(fixed, shift) or TYPICAL


def parse_calibration(fixed: bytes, shift: bytes) -> DeviceCalibration | None:
    """From both payloads behind their error words; None where they are too short or describe no Kinect.

    Four floats in centimetres: emitter to infrared camera, infrared to colour camera, reference plane, its pixel size.
    """
    if len(fixed) < _FLOATS_AT + _FLOATS.size or len(shift) < 2:
        return None
    baseline, _, distance, pixel = _FLOATS.unpack_from(fixed, _FLOATS_AT)
    const_shift = int.from_bytes(shift[:2], "little")
    if not all(math.isfinite(value) for value in (baseline, distance, pixel)):
        return None
    if not (
        5.0 < baseline < 10.0 and 50.0 < distance < 300.0 and 1000.0 < distance / max(pixel, 1e-9) < 1350.0 and 100 < const_shift < 300
    ):
        return None
    return DeviceCalibration(distance * _CM, pixel * _CM, baseline * _CM, float(const_shift))
