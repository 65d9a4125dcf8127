"""How a sensor is to listen, and what it may be doing."""

from dataclasses import dataclass
from enum import Enum

from kinect.usb.ring import DEFAULT_SIZE, RingSize
from kinect.usb.stream_registers import Video


class SensorState(Enum):
    """What the sensor is doing."""

    SEARCHING = "searching"
    STARTING = "starting"
    STREAMING = "streaming"
    CLOSED = "closed"


@dataclass(frozen=True)
class SensorOptions:
    """How to listen: the ring's size, the second stream, how many of 242 packets make a frame of use, and the watchdog's patience."""

    ring: RingSize = DEFAULT_SIZE
    video: Video = Video.OFF
    least_packets: int = 237
    look_every_s: float = 0.5
    silence_s: float = 2.0
    restarts_before_reopen: int = 3
    presence_after_s: float = 0.25  # silence before we ask whether the device is still on the bus
    level_every_s: float = 1.0
    loss_every_s: float = 2.0
    loss_to_tell: float = 0.01
    kept_frames: int = 8
