"""The doctor's look at a Kinect: find it, open it, listen for some seconds, then judge what it showed."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from game.commands.kinect_host import HostFacts
from game.commands.kinect_sight import CutOff, cut_off, floor_from_m, valid_share
from kinect.body import Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.depth_stream import SensorDepth
from kinect.depth.floor_watch import FloorWatch
from kinect.usb.clock import Clock, WallClock
from kinect.usb.counters import Counters
from kinect.usb.discovery import Found, FoundKinect, find_kinects
from kinect.usb.errors import Fault, KinectError
from kinect.usb.motor import MotorState
from kinect.usb.sensor import KinectSensor
from kinect.usb.sensor_options import SensorOptions

LOOK_EVERY_S: Final = 0.5
KEPT_LOOKS: Final = 40
REST_S: Final = 0.02
GIVE_UP_S: Final = 1.2
HOPELESS: Final = frozenset(
    {
        Fault.NO_LIBUSB, Fault.NO_DEVICE, Fault.NO_POWER, Fault.PERMISSION, Fault.BUSY, Fault.KINECT_V2, Fault.AZURE,
        Fault.WRONG_DRIVER, Fault.REFUSED,
    }
)  # fmt: skip
"""What no waiting mends."""


@dataclass(frozen=True)
class Sight:
    """What the pictures showed: share of valid depth (median), the floor or why there is none, where it begins (m), who is cut off."""

    share: float
    floor: Floor | None
    floor_why: str
    floor_from_m: float
    cut_off: CutOff | None


@dataclass(frozen=True)
class Examination:
    """All that was found out. fault, sentence: the sensor's last word; stall_s: the longest time this program itself stood still.

    frames: pictures of use that arrived; first_s: when the first came; listened_s: time from then on; queue_s: what the
    transfers in flight bridge; libusb: which one, or None; sight: None without a picture;
    turned: what came of asking for a tilt, in words.
    """

    host: HostFacts
    seconds: float
    libusb: str | None
    found: Found
    used: FoundKinect | None
    fault: Fault | None
    sentence: str
    counters: Counters
    frames: int = 0
    first_s: float | None = None
    listened_s: float = 0.0
    stall_s: float = 0.0
    queue_s: float = 0.0
    level: MotorState | None = None
    typical_calibration: bool = False
    sight: Sight | None = None
    turned: str = ""


class SteppedSensor(KinectSensor):
    """A sensor on a simulated clock: it runs when it is polled, and not in a thread."""

    def start(self) -> "SteppedSensor":
        return self

    def poll(self) -> list:
        self.step()
        return super().poll()


def examine(
    load: Callable[[], Any], clock: Clock, seconds: float, facts: Callable[[FoundKinect | None], HostFacts], tilt_deg: float | None = None
) -> Examination:
    """Listen to the first Kinect for so long, less where no waiting helps, and let go of it. `load` gives pyusb's backend.

    tilt_deg: turn the head there first, degrees above the horizon, -27 to 27.
    """
    libusb, found = look_at_bus(load)
    used = found.kinects[0] if found.kinects else None
    live = isinstance(clock, WallClock)
    sensor = KinectSensor(load, clock) if live else SteppedSensor(load, clock)
    stream = SensorDepth(sensor)
    began = clock.now()
    looks: list[DepthFrame] = []
    turned: str | None = "" if tilt_deg is None else None
    frames, first_s, hopeless_since, stall, level = 0, None, None, 0.0, None
    while (now := clock.now()) - began < seconds:
        for frame in stream.poll(0.0):
            first_s = now if first_s is None else first_s
            frames += 1
            if not looks or frame.time_s - looks[-1].time_s >= LOOK_EVERY_S:
                looks = [*looks[1 - KEPT_LOOKS :], frame]
        level = sensor.level or level
        if turned is None and tilt_deg is not None and frames:
            turned = _turn(sensor, tilt_deg)
        hopeless_since = (hopeless_since or now) if sensor.fault in HOPELESS else None
        if hopeless_since is not None and now - hopeless_since > GIVE_UP_S:
            break
        if live:
            before = clock.now()
            clock.sleep(REST_S)
            stall = max(stall, clock.now() - before - REST_S)
    fault, sentence, counters = sensor.fault, sensor.status, sensor.counters()
    ended, host = clock.now(), facts(used)
    stream.close()
    return Examination(
        host, seconds, libusb, found, used, fault, sentence, counters, frames, None if first_s is None else first_s - began,
        0.0 if first_s is None else ended - first_s, stall, queue_s(sensor.options), level, sensor.calibration.is_typical, see(looks),
        turned or "",
    )  # fmt: skip


def _turn(sensor: KinectSensor, degrees: float) -> str:
    try:
        sensor.set_tilt(degrees)
    except KinectError as fault:
        return str(fault)
    return f"Its motor was asked for {degrees:g} degrees and takes a few seconds."


def look_at_bus(load: Callable[[], Any]) -> tuple[str | None, Found]:
    """Which libusb there is, in words, or None; and what is plugged in."""
    try:
        backend = load()
    except KinectError:
        return None, Found()
    name = str(getattr(getattr(backend, "lib", None), "_name", None) or "a simulated one")
    where = "the package libusb-package" if "libusb_package" in name else "this system" if "simulated" not in name else "a simulation"
    try:
        return f"{name} ({where})" if where != "a simulation" else name, find_kinects(backend)
    except Exception:  # the sensor's own words will say what is wrong with the bus
        return name, Found()


def queue_s(options: SensorOptions) -> float:
    """How long the program may stand still before packets are lost, seconds."""
    return options.ring.transfers * options.ring.packets / 8000.0


def see(looks: list[DepthFrame]) -> Sight | None:
    """Judge pictures half a second apart."""
    if not looks:
        return None
    watch = FloorWatch()
    for frame in looks:
        watch.see(frame)
    floor, last = watch.floor, looks[-1]
    share = float(np.median([valid_share(frame) for frame in looks]))
    if floor is None:
        return Sight(share, None, watch.why, float("inf"), None)
    return Sight(share, floor, watch.why, floor_from_m(last, floor), cut_off(last, floor))
