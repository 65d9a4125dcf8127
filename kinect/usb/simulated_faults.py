"""Everything that goes wrong in living rooms, by name, on a simulated Kinect: for the doctor's messages and for tests."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from kinect.usb.clock import Clock, WallClock
from kinect.usb.libusb import no_libusb
from kinect.usb.models import Model
from kinect.usb.simulated_host import SimulatedHost
from kinect.usb.simulated_kinect import OtherDevice, SimulatedKinect
from kinect.usb.simulated_libusb import simulated_backend
from kinect.usb.simulated_room import Room
from kinect.usb.simulated_stream import FrameSource


@dataclass(frozen=True)
class Simulation:
    """`load` takes the place of `load_backend`; host and kinect are there to be meddled with."""

    load: Callable[[], Any]
    host: SimulatedHost
    kinect: SimulatedKinect


def _no_libusb() -> Any:
    raise no_libusb()


def _camera(**faults: int) -> Callable[[Simulation], None]:
    return lambda s: s.kinect.camera.faults.update({name.replace("_", " "): count for name, count in faults.items()})


def _set(part: str, name: str, value: Any) -> Callable[[Simulation], None]:
    return lambda s: setattr(getattr(s.kinect, part) if part else s.host, name, value)


def _unplugged(s: Simulation) -> None:
    s.host.at(s.host.clock.now() + 2.0, lambda: s.host.unplug(s.kinect))


def _replugged(s: Simulation) -> None:
    _unplugged(s)
    s.host.at(s.host.clock.now() + 4.0, lambda: s.host.plug(s.kinect))


def _nothing(_: Simulation) -> None:
    pass


WIRE_FAULTS: Final[dict[str, Callable[[Simulation], None]]] = {
    "none": _nothing,
    "permission": _set("camera", "forbidden", True),
    "busy": _set("camera", "busy", True),
    "webcam-driver": _set("camera", "kernel_driver", True),
    "refused": _set("", "largest_queue", 0),
    "short-queue": _set("", "largest_queue", 400),
    "lossy": _set("", "loss", 0.05),
    "silent": _set("camera", "sends", False),
    "mute": _camera(mute=1_000_000),
    "not-ready": _camera(not_ready=5),
    "stale": _camera(stale=3),
    "stall": _camera(stall=2),
    "unplugged": _unplugged,
    "replugged": _replugged,
}
"""On the wire of a Kinect 1414 that is plugged in; "none", "webcam-driver", "short-queue", "not-ready", "stale" and "stall" must heal."""

ROOMS: Final[dict[str, Room]] = {
    "sun": Room(valid=0.08),
    "too-near": Room(person_m=0.48, wall_m=0.49),
    "feet-out": Room(person_m=1.3),
    "tilted": Room(pitch_rad=math.radians(20.0)),
}
"""The Kinect works, and what it sees is no good."""

BUSES: Final[dict[str, Callable[[FrameSource], list[SimulatedKinect]]]] = {
    "no-device": lambda source: [],
    "no-power": lambda source: [SimulatedKinect(source, powered=False)],
    "no-power-1473": lambda source: [SimulatedKinect(source, Model.XBOX_1473, powered=False)],
    "kinect-v2": lambda source: [OtherDevice(0x02C4)],
    "azure": lambda source: [OtherDevice(0x097C)],
    "model-1473": lambda source: [SimulatedKinect(source, Model.XBOX_1473)],
    "kinect-for-windows": lambda source: [SimulatedKinect(source, Model.WINDOWS_1517)],
}
"""What else may be plugged in."""

FAULTS: Final = ("no-libusb", *WIRE_FAULTS, *BUSES, *ROOMS)


def simulate(fault: str, clock: Clock | None = None, source: FrameSource | None = None) -> Simulation:
    """A bus on which this fault has happened; the picture is `source`, or a living room. Raises ValueError for a name not in FAULTS."""
    if fault not in FAULTS:
        raise ValueError(f"no fault is called {fault!r}; there are {', '.join(FAULTS)}")
    room = ROOMS.get(fault, Room())
    source = source or room.source()
    host = SimulatedHost(clock or WallClock())
    plugged = BUSES.get(fault, lambda s: [SimulatedKinect(s)])(source)
    for kinect in plugged:
        kinect.motor.counts = room.counts
        host.plug(kinect)
    backend = simulated_backend(host)
    simulation = Simulation(
        _no_libusb if fault == "no-libusb" else lambda: backend, host, plugged[0] if plugged else SimulatedKinect(source)
    )
    WIRE_FAULTS.get(fault, _nothing)(simulation)
    return simulation
