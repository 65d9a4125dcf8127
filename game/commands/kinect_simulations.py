"""A Kinect that is only simulated: what can be wrong with it, and how to open it in place of a real one."""

from typing import Final

from game.commands import BadInput
from game.commands.kinect_host import HostFacts
from kinect.usb.clock import Clock
from kinect.usb.simulated_faults import FAULTS, Simulation, simulate

MEANINGS: Final = {
    "none": "a Kinect 1414 that works, in a living room; `room` is the same",
    "no-libusb": "there is no libusb on this machine",
    "permission": "nobody gave you the right to open it",
    "busy": "another program has it open",
    "webcam-driver": "the kernel took it for a webcam (heals by itself)",
    "refused": "the USB host takes no transfers",
    "short-queue": "the USB host takes few transfers (heals by itself)",
    "lossy": "every twentieth packet is lost",
    "silent": "it is there but sends nothing",
    "mute": "it answers no command",
    "not-ready": "it asks for patience a few times (heals by itself)",
    "stale": "it still holds answers to a program that died (heals by itself)",
    "stall": "it refuses commands now and then (heals by itself)",
    "unplugged": "its plug is pulled after two seconds",
    "replugged": "pulled after two seconds, put back after four",
    "no-device": "nothing is plugged in",
    "no-power": "a 1414 whose 12 V supply is missing",
    "no-power-1473": "a 1473 whose 12 V supply is missing",
    "kinect-v2": "a Kinect v2 is plugged in instead",
    "azure": "an Azure Kinect is plugged in instead",
    "model-1473": "a 1473 that works",
    "kinect-for-windows": "a Kinect for Windows v1 that works",
    "sun": "the sun shines into the picture",
    "too-near": "something stands right in front of it",
    "feet-out": "the player stands too near to be seen whole",
    "tilted": "it looks up and sees no floor",
}
"""Every fault that can be simulated, in words."""


def names() -> str:
    """A line per simulation."""
    return "\n".join(f"{name:<20}{MEANINGS[name]}" for name in FAULTS)


def simulation(name: str, clock: Clock) -> Simulation:
    """The simulated bus of this name, `room` for one without a fault; raises BadInput."""
    fault = "none" if name == "room" else name
    if fault not in FAULTS:
        raise BadInput(f"--simulate {name!r} is no simulation; valid: list, room, {', '.join(FAULTS)}.")
    return simulate(fault, clock)


def simulated_facts(name: str) -> HostFacts:
    """What a computer with this fault would tell."""
    return HostFacts(webcam_driver=name == "webcam-driver", holders=("freenect-glview",) if name == "busy" else ())
