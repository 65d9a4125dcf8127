"""Say in plain words what of a Kinect works, what does not, and what to do about it. Ends with 0 only when a picture arrived."""

import argparse

from game.commands import DONE, BadInput
from game.commands.kinect_examination import Examination, examine
from game.commands.kinect_findings import Finding, Mark, findings
from game.commands.kinect_host import HostFacts, host_facts
from game.commands.kinect_simulations import names, simulated_facts, simulation
from kinect.usb.clock import WallClock
from kinect.usb.discovery import FoundKinect
from kinect.usb.libusb import load_backend
from kinect.usb.motor import SAFE_TILT_DEG
from kinect.usb.simulated_clock import VirtualClock

NO_PICTURE = 1
LONGEST_S = 600.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seconds", type=float, default=5.0, metavar="S", help="how long to listen (default 5)")
    parser.add_argument("--tilt", type=float, metavar="DEG", help="first turn the head so far above the horizon, by the motor of a 1414")
    parser.add_argument("--simulate", metavar="FAULT", help="show what would be said of a Kinect with this fault; list names them all")


def run(arguments: argparse.Namespace) -> int:
    if not 1.0 <= arguments.seconds <= LONGEST_S:
        raise BadInput(f"--seconds must lie between 1 and {LONGEST_S:g}, not {arguments.seconds:g}.")
    if arguments.tilt is not None and not -SAFE_TILT_DEG <= arguments.tilt <= SAFE_TILT_DEG:
        raise BadInput(f"--tilt must lie between -{SAFE_TILT_DEG:g} and {SAFE_TILT_DEG:g} degrees, not {arguments.tilt:g}.")
    if arguments.simulate == "list":
        print(names())
        return DONE
    if arguments.simulate is None:
        print(f"Looking at the Kinect for up to {arguments.seconds:g} s.", flush=True)
        seen = examine(load_backend, WallClock(), arguments.seconds, _facts_of, arguments.tilt)
    else:
        clock = VirtualClock()
        load = simulation(arguments.simulate, clock).load
        print(f"Nothing of this is real: a simulated Kinect, {arguments.simulate}.")
        seen = examine(load, clock, arguments.seconds, lambda _: simulated_facts(arguments.simulate), arguments.tilt)
    found = findings(seen)
    print(as_text(found))
    print(verdict(seen, found))
    return DONE if seen.frames else NO_PICTURE


def as_text(found: list[Finding]) -> str:
    """A line per finding, and what to do below it."""
    lines = []
    for finding in found:
        lines.append(f"{finding.mark.value:<6}{finding.subject:<10}{finding.sentence}")
        lines += [f"{'':<16}{remedy}" for remedy in finding.remedies]
    return "\n".join(lines)


def verdict(seen: Examination, found: list[Finding]) -> str:
    """The last line."""
    if not seen.frames:
        return "No depth picture arrived."
    wrong = [finding.subject for finding in found if finding.mark is Mark.WRONG]
    return f"The Kinect sends depth. To be mended: {', '.join(wrong)}." if wrong else "The Kinect sends depth, and all is well."


def _facts_of(used: FoundKinect | None) -> HostFacts:
    return host_facts() if used is None else host_facts(used.camera.bus, used.camera.address)
