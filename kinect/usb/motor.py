"""The motor device of model 1414: tilt, LED and the accelerometer that knows which way is down."""

import math
import struct
from enum import IntEnum
from typing import Any, Final, NamedTuple

from kinect.usb.claim import claim_interface, let_go
from kinect.usb.errors import Fault, KinectError
from kinect.usb.models import Model

OUT: Final = 0x40
IN: Final = 0xC0
ALIVE, SET_LED, SET_TILT, STATE = 0x10, 0x06, 0x31, 0x32
COUNTS_PER_G: Final = 819.0
SAFE_TILT_DEG: Final = 27.0
MOVING: Final = -128
TIMEOUT_MS: Final = 250
_STATE: Final = struct.Struct(">xxhhhbB")


class Led(IntEnum):
    """What the LED can show."""

    OFF = 0
    GREEN = 1
    RED = 2
    YELLOW = 3
    BLINK_GREEN = 4
    BLINK_RED_YELLOW = 6


class MotorState(NamedTuple):
    """acceleration: (x, y, z) in g, the sensor's own axes (x left, y up, z away); at rest it points up. motor_deg: None while it moves."""

    acceleration: tuple[float, float, float]
    motor_deg: float | None
    at_limit: bool

    @property
    def pitch_rad(self) -> float:
        """How far the sensor looks up."""
        return math.atan2(self.acceleration[2], self.acceleration[1])

    @property
    def roll_rad(self) -> float:
        """How far the sensor leans to its side."""
        return math.atan2(self.acceleration[0], self.acceleration[1])

    @property
    def up(self) -> tuple[float, float, float] | None:
        """The unit vector that points up, in the sensor's frame; None while it is shaken or in free fall."""
        length = math.sqrt(sum(a * a for a in self.acceleration))
        if not 0.8 < length < 1.2:
            return None
        x, y, z = self.acceleration
        return (x / length, y / length, z / length)


class Motor:
    """The motor of one Kinect 1414. Its methods raise usb.core.USBError where the device is gone."""

    def __init__(self, device: Any) -> None:
        self._device = device
        claim_interface(device)

    def state(self) -> MotorState:
        """What accelerometer and motor report."""
        return parse_state(bytes(self._device.ctrl_transfer(IN, STATE, 0, 0, 10, TIMEOUT_MS)))

    def set_led(self, led: Led) -> None:
        """Show this colour."""
        self._device.ctrl_transfer(OUT, SET_LED, int(led), 0, None, TIMEOUT_MS)

    def set_tilt(self, degrees: float) -> None:
        """Turn the head to so many degrees above the horizon, within +-27. Slow and loud: once at the start at most, never in a loop."""
        self._device.ctrl_transfer(OUT, SET_TILT, tilt_word(degrees), 0, None, TIMEOUT_MS)

    def close(self) -> None:
        """Let go of the device."""
        let_go(self._device)


def tilt_word(degrees: float) -> int:
    """An angle above the horizon as the motor takes it: half degrees in 16 bits. Raises ValueError beyond +-27 degrees."""
    if not -SAFE_TILT_DEG <= degrees <= SAFE_TILT_DEG:
        raise ValueError(f"the Kinect's motor tilts by -{SAFE_TILT_DEG:g} to {SAFE_TILT_DEG:g} degrees, not {degrees:g}")
    return round(2 * degrees) & 0xFFFF


def parse_state(octets: bytes) -> MotorState:
    """From the ten octets of the state reply. Raises KinectError where there are fewer."""
    if len(octets) < _STATE.size:
        raise KinectError(Fault.PROTOCOL, f"The Kinect's motor answers with {len(octets)} octets instead of 10: plug the Kinect in again.")
    x, y, z, half_degrees, state = _STATE.unpack_from(octets)
    motor_deg = None if half_degrees == MOVING else half_degrees / 2.0
    return MotorState((x / COUNTS_PER_G, y / COUNTS_PER_G, z / COUNTS_PER_G), motor_deg, state == 1)


def no_motor(model: Model) -> KinectError:
    """Why this Kinect cannot tilt, in plain words."""
    if model.has_motor_device:
        return KinectError(Fault.UNSUPPORTED, "The Kinect's motor was not found beside its camera: unplug the Kinect and plug it in again.")
    return KinectError(Fault.UNSUPPORTED, model.limits)
