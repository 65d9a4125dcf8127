"""The camera's registers that start and stop its streams."""

from enum import Enum
from typing import Final

from kinect.usb.command import CameraCommands
from kinect.usb.packet import INFRARED_10, RGB_BAYER, StreamFormat

VIDEO_ENDPOINT: Final = 0x81
DEPTH_ENDPOINT: Final = 0x82

VIDEO_STREAM: Final = 0x05
DEPTH_STREAM: Final = 0x06
RGB_FORMAT, RGB_RESOLUTION, RGB_RATE, RGB_FLIP = 0x0C, 0x0D, 0x0E, 0x47
DEPTH_FORMAT, DEPTH_RESOLUTION, DEPTH_RATE, DEPTH_FLIP = 0x12, 0x13, 0x14, 0x17
INFRARED_FORMAT, INFRARED_RESOLUTION, INFRARED_RATE, INFRARED_FLIP = 0x19, 0x1A, 0x1B, 0x48
PROJECTOR_CYCLE: Final = 0x105

OFF, RGB_ON, DEPTH_ON, INFRARED_ON = 0, 1, 2, 3
ELEVEN_BITS: Final = 3
VGA: Final = 1
RATE: Final = 30

START_DEPTH: Final = (
    (PROJECTOR_CYCLE, 0),
    (DEPTH_STREAM, OFF),
    (DEPTH_FORMAT, ELEVEN_BITS),
    (DEPTH_RESOLUTION, VGA),
    (DEPTH_RATE, RATE),
    (DEPTH_STREAM, DEPTH_ON),
    (DEPTH_FLIP, 0),
)
START_RGB: Final = ((RGB_FORMAT, 0), (RGB_RESOLUTION, VGA), (RGB_RATE, RATE), (VIDEO_STREAM, RGB_ON), (RGB_FLIP, 0))
START_INFRARED: Final = (
    (INFRARED_FORMAT, 0),
    (INFRARED_RESOLUTION, VGA),
    (INFRARED_RATE, RATE),
    (PROJECTOR_CYCLE, 0),
    (VIDEO_STREAM, INFRARED_ON),
    (INFRARED_FLIP, 0),
)
STOP_DEPTH: Final = ((DEPTH_STREAM, OFF),)
STOP_VIDEO: Final = ((VIDEO_STREAM, OFF),)


class Video(Enum):
    """What the second stream shows, if it runs at all: never both at once."""

    OFF = "off"
    RGB = "rgb"
    INFRARED = "infrared"

    @property
    def layout(self) -> StreamFormat:
        """How its frames are cut into packets."""
        return RGB_BAYER if self is Video.RGB else INFRARED_10

    @property
    def start(self) -> tuple[tuple[int, int], ...]:
        """The registers that start it, in order."""
        return {Video.OFF: (), Video.RGB: START_RGB, Video.INFRARED: START_INFRARED}[self]


def write_all(commands: CameraCommands, sequence: tuple[tuple[int, int], ...]) -> None:
    """Write (register, value) pairs in order, each waiting for its reply."""
    for register, value in sequence:
        commands.write_register(register, value)
