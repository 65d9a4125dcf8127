"""Simulated USB devices: what they are called, what they answer on their control pipe."""

from dataclasses import dataclass, field
from typing import Any, Final

from kinect.usb.models import BCD_1414, CAMERA_WINDOWS, CAMERA_XBOX, HUB, MICROSOFT, MOTOR, Model
from kinect.usb.motor import ALIVE, SET_LED, SET_TILT, STATE

ERROR_IO, ERROR_ACCESS, ERROR_NO_DEVICE, ERROR_NOT_FOUND, ERROR_BUSY, ERROR_TIMEOUT, ERROR_PIPE, ERROR_NO_MEM = (
    -1,
    -3,
    -4,
    -5,
    -6,
    -7,
    -9,
    -11,
)

ISO, BULK = 1, 2
Endpoint = tuple[int, int, int]
"""Address, kind, wMaxPacketSize as in its descriptor."""
CAMERA_ENDPOINTS: Final[tuple[Endpoint, ...]] = ((0x81, ISO, 0x0BC0), (0x82, ISO, 0x0BC0))
AUDIO_ENDPOINTS: Final[tuple[Endpoint, ...]] = ((0x81, BULK, 512), (0x01, BULK, 512))


@dataclass(eq=False)
class SimulatedDevice:
    """One device on the bus. settings: the endpoints of each alternate setting of interface 0."""

    product: int
    release: int = 0x0100
    ports: tuple[int, ...] = (1,)
    vendor: int = MICROSOFT
    device_class: int = 0
    settings: tuple[tuple[Endpoint, ...], ...] = ((),)
    bus: int = 1
    address: int = 0
    setting: int = 0
    kernel_driver: bool = False
    forbidden: bool = False
    busy: bool = False
    gone: bool = True
    claimed_by: int | None = None
    faults: dict[str, Any] = field(default_factory=dict)

    def control(self, out: bool, request: int, value: int, data: bytes, length: int, now: float) -> bytes | int:
        """Octets for a request that reads, b"" for one that writes, or libusb's error."""
        return ERROR_PIPE

    def bulk(self, endpoint: int, data: bytes, length: int) -> bytes | int:
        """The same for a bulk pipe."""
        return ERROR_NOT_FOUND

    def reset(self, now: float) -> None:
        """It was plugged in just now."""
        self.setting, self.claimed_by = 0, None


@dataclass(eq=False)
class SimulatedMotor(SimulatedDevice):
    """Model 1414's motor. counts: the accelerometer's x, y, z, 819 to 1 g."""

    product: int = MOTOR
    counts: tuple[int, int, int] = (0, 812, 20)
    half_degrees: int = 0
    led: int = 0

    def control(self, out: bool, request: int, value: int, data: bytes, length: int, now: float) -> bytes | int:
        """The four requests that the motor knows."""
        if out and request == SET_LED:
            self.led = value
            return b""
        if out and request == SET_TILT:
            self.half_degrees = value - 0x10000 if value & 0x8000 else value
            return b""
        if not out and request == ALIVE:
            return b"\x22"
        if not out and request == STATE:
            axes = b"".join(count.to_bytes(2, "big", signed=True) for count in self.counts)
            return b"\0\0" + axes + self.half_degrees.to_bytes(1, "big", signed=True) + b"\0"
        return ERROR_PIPE


@dataclass(eq=False)
class SimulatedAudio(SimulatedDevice):
    """The audio device in its bootloader state: it takes the LED command and little else."""

    product: int = 0x02AD
    settings: tuple[tuple[Endpoint, ...], ...] = (AUDIO_ENDPOINTS,)
    led: int = 0
    answer: bytes = b""

    def bulk(self, endpoint: int, data: bytes, length: int) -> bytes | int:
        """One command of u32 words, then one reply of twelve octets."""
        if endpoint & 0x80:
            answer, self.answer = self.answer, b""
            return answer or ERROR_TIMEOUT
        if data[:4] != b"\x09\x20\x02\x06":
            return ERROR_PIPE
        self.led = data[16] if len(data) >= 20 and data[12] == 0x10 else self.led
        self.answer = b"\x00\xe0\x6f\x0a" + data[4:8] + b"\0\0\0\0"
        return b""


def hub_of(model: Model, ports: tuple[int, ...]) -> SimulatedDevice:
    """The hub inside the case; on model 1414 it bears no number of Microsoft's."""
    if model is Model.XBOX_1414:
        return SimulatedDevice(0x005A, vendor=0x0409, ports=ports, device_class=9)
    return SimulatedDevice(HUB, ports=ports, device_class=9)


def camera_release(model: Model) -> tuple[int, int]:
    """Product id and release number of a model's camera."""
    if model is Model.WINDOWS_1517:
        return CAMERA_WINDOWS, 0x0205
    return CAMERA_XBOX, BCD_1414 if model is Model.XBOX_1414 else 0x0205
