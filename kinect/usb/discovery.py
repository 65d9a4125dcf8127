"""Finding Kinects and what belongs to each: camera, motor and audio hang on one hub inside the case, so their port paths agree."""

from dataclasses import dataclass, field
from typing import Any

import usb.core

from kinect.usb.errors import Fault, KinectError
from kinect.usb.models import AUDIO, AZURE, CAMERAS, HUB, KINECT_V2, MICROSOFT, MOTOR, Model, model_of


@dataclass(frozen=True)
class FoundKinect:
    """One Kinect v1: its model and pyusb's devices, None where a part was not found."""

    model: Model
    camera: Any
    motor: Any = None
    audio: Any = None

    @property
    def place(self) -> str:
        """Where it is plugged in, as in "bus 1, port 2.1"."""
        return place(self.camera)

    @property
    def key(self) -> tuple[Any, ...]:
        """Tells one plugging-in from the next."""
        return (self.camera.bus, self.camera.address, self.camera.port_numbers)


@dataclass(frozen=True)
class Found:
    """All that one look at the bus showed. `powerless`: places of Kinects whose camera is missing."""

    kinects: tuple[FoundKinect, ...] = ()
    powerless: tuple[str, ...] = ()
    newer: tuple[Fault, ...] = field(default=())

    def first(self) -> FoundKinect:
        """The Kinect on the lowest bus and port. Raises KinectError that says what was seen instead."""
        if self.kinects:
            return self.kinects[0]
        if self.powerless:
            raise KinectError(
                Fault.NO_POWER, f"I see the Kinect's motor ({self.powerless[0]}) but not its camera: is the 12 V supply plugged in?"
            )
        if Fault.KINECT_V2 in self.newer:
            raise KinectError(
                Fault.KINECT_V2, "I see a Kinect v2 (Xbox One), which is not supported: this game needs a Kinect v1 (Xbox 360)."
            )
        if Fault.AZURE in self.newer:
            raise KinectError(Fault.AZURE, "I see an Azure Kinect, which is not supported: this game needs a Kinect v1 (Xbox 360).")
        raise KinectError(
            Fault.NO_DEVICE, "I see no Kinect: plug its USB adapter into the computer and the adapter's supply into the wall."
        )


def find_kinects(backend: Any) -> Found:
    """Look at the bus once. Opens nothing, so it needs no rights."""
    devices: list[Any] = list(usb.core.find(find_all=True, backend=backend, idVendor=MICROSOFT) or ())  # type: ignore[arg-type]
    devices.sort(key=lambda d: (d.bus or 0, d.port_numbers or (), d.address or 0))
    kinects = []
    for device in devices:
        model = model_of(device.idProduct, device.bcdDevice)
        if model:
            siblings = [d for d in devices if _hub(d) == _hub(device)]
            motor = next((d for d in siblings if d.idProduct == MOTOR), None)
            audio = next((d for d in siblings if d.idProduct in AUDIO), None)
            kinects.append(FoundKinect(model, device, motor, audio))
    return Found(tuple(kinects), _powerless(devices), tuple(newer for d in devices if (newer := _newer(d))))


def place(device: Any) -> str:
    """Where a device is plugged in, in words."""
    ports = ".".join(str(port) for port in device.port_numbers or ())
    return f"bus {device.bus}, port {ports}" if ports else f"bus {device.bus}"


def _powerless(devices: list[Any]) -> tuple[str, ...]:
    """Motors without a camera beside them, and hubs without a camera below them."""
    cameras = {_hub(d) for d in devices if d.idProduct in CAMERAS}
    motors = [d for d in devices if d.idProduct == MOTOR and _hub(d) not in cameras]
    seen = {_hub(d) for d in motors}
    hubs = [d for d in devices if d.idProduct == HUB and not {(d.bus, d.port_numbers or ()), _hub(d)} & (cameras | seen)]
    return tuple(place(d) for d in motors + hubs)


def _hub(device: Any) -> tuple[Any, ...]:
    """The hub that a device hangs on. Where the system tells no ports, the bus must do."""
    return (device.bus, (device.port_numbers or ())[:-1])


def _newer(device: Any) -> Fault | None:
    if device.idProduct in KINECT_V2:
        return Fault.KINECT_V2
    return Fault.AZURE if device.idProduct in AZURE else None
