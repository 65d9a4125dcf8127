"""Write what the Kinect sees into a folder, to be played back with --input kinect-replay:FOLDER. Ctrl-C ends it and keeps everything."""

import argparse
import contextlib
import signal
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Final

from game.commands import DONE, BadInput
from game.commands.kinect_simulations import simulation
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.depth_stream import SensorDepth
from kinect.depth.recorder import DepthRecorder
from kinect.depth.recording_format import TICK_WRAP, TICKS_HZ, DepthRecordingError
from kinect.usb.clock import WallClock
from kinect.usb.libusb import load_backend
from kinect.usb.sensor import KinectSensor

NO_PICTURE: Final = 1
LONGEST_S: Final = 86400.0
REST_S: Final = 0.02
TOLD_EVERY_S: Final = 1.0
TICKS_ASTRAY_S: Final = 0.5
PATIENCE_S: Final = 5.0
"""A Kinect that is there shows its first picture within this, however busy the computer is."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("out", type=Path, metavar="OUT", help="a new or an empty folder")
    parser.add_argument("--seconds", type=float, metavar="S", help="stop so long after the first picture (default: at Ctrl-C)")
    parser.add_argument(
        "--simulate", metavar="NAME", help="record a simulated Kinect, such as room; `kinect doctor --simulate list` names all"
    )


def run(arguments: argparse.Namespace) -> int:
    seconds = LONGEST_S if arguments.seconds is None else arguments.seconds
    if not 0.0 < seconds <= LONGEST_S:
        raise BadInput(f"--seconds must lie between 0 and {LONGEST_S:g}, not {seconds:g}.")
    load = load_backend if arguments.simulate is None else simulation(arguments.simulate, WallClock()).load
    try:
        recorder = DepthRecorder(arguments.out)
    except DepthRecordingError as fault:
        raise BadInput(str(fault)) from fault
    sensor = KinectSensor(load)
    try:
        with ending_at_a_signal() as ended:
            record(sensor, recorder, seconds, ended)
    except DepthRecordingError as fault:
        raise BadInput(str(fault)) from fault
    return tell(recorder, sensor)


def record(sensor: KinectSensor, recorder: DepthRecorder, seconds: float, ended: Callable[[], bool]) -> None:
    """Write every picture that comes until the time is over or somebody ends it; a pulled plug is a pause. Closes both.

    The time begins with the first picture; without one it ends after `seconds` too, but not before PATIENCE_S.
    """
    stream, clock_of = SensorDepth(sensor), SteadyTicks()
    began, told_s, told, frames, first_s = time.monotonic(), 0.0, "", 0, 0.0
    try:
        while (passed := time.monotonic() - began) < (seconds if frames else max(seconds, PATIENCE_S)) and not ended():
            for frame in stream.poll(0.0):
                if not frames:
                    began, first_s = time.monotonic(), frame.time_s
                if frame.time_s - first_s < seconds:
                    recorder.write(clock_of.steadied(frame))
                    frames += 1
            if stream.status != told or (sys.stderr.isatty() and passed - told_s >= TOLD_EVERY_S):
                end = "\r" if stream.status == told else "\n"
                print(f"topple: {passed:6.1f} s, {frames} pictures. {stream.status}", end=end, file=sys.stderr, flush=True)
                told, told_s = stream.status, passed
            time.sleep(REST_S)
    finally:
        stream.close()
        recorder.close()


class SteadyTicks:
    """A Kinect plugged in again counts its ticks anew, which a recording's one clock cannot follow: this carries them on."""

    def __init__(self) -> None:
        self._shift = 0
        self._lead: int | None = None  # of the ticks before the frame's time

    def steadied(self, frame: DepthFrame) -> DepthFrame:
        """The frame with ticks that advance as its time does."""
        lead = (frame.ticks - round(frame.time_s * TICKS_HZ)) % TICK_WRAP
        if self._lead is None:
            self._lead = lead
        astray = (lead + self._shift - self._lead + TICK_WRAP // 2) % TICK_WRAP - TICK_WRAP // 2
        if abs(astray) > TICKS_ASTRAY_S * TICKS_HZ:
            self._shift -= astray
        else:
            self._lead = (lead + self._shift) % TICK_WRAP  # two clocks drift apart slowly
        return replace(frame, ticks=(frame.ticks + self._shift) % TICK_WRAP)


@contextlib.contextmanager
def ending_at_a_signal() -> Iterator[Callable[[], bool]]:
    """While inside, Ctrl-C and a polite kill do not break off but make the function given say True; a second Ctrl-C breaks off."""
    came: list[int] = []

    def note(number: int, _frame: object) -> None:
        came.append(number)
        if len(came) > 1:
            raise KeyboardInterrupt

    before = {number: signal.signal(number, note) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield lambda: bool(came)
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def tell(recorder: DepthRecorder, sensor: KinectSensor) -> int:
    """Say what was written; the exit status."""
    counters = sensor.counters()
    if not recorder.frames_written:
        print(f"topple: no picture came, so {recorder.folder} stays empty. See: kinect doctor", file=sys.stderr)
        return NO_PICTURE
    holes = f", {counters.frames_partial} with holes" if counters.frames_partial else ""
    missed = f", {counters.frames_overrun} missed by a busy computer" if counters.frames_overrun else ""
    pauses = f", {counters.unplugs} time{'s' if counters.unplugs > 1 else ''} unplugged" if counters.unplugs else ""
    print(f"topple: wrote {recorder.frames_written} pictures to {recorder.folder}{holes}{missed}{pauses}.")
    print(f"topple: see it with --input kinect-replay:{recorder.folder}")
    return DONE
