"""One Kinect that is ours for now: claimed, calibrated, its streams started and stopped."""

import contextlib
from types import SimpleNamespace
from typing import Any, Final, NamedTuple

import usb.core

from kinect.usb.assembler import AssembledFrame, Assembler
from kinect.usb.claim import claim_camera, let_go
from kinect.usb.clock import Clock
from kinect.usb.command import CameraCommands
from kinect.usb.discovery import FoundKinect
from kinect.usb.errors import KinectError, explained
from kinect.usb.iso_read_threads import IsoReadThreads
from kinect.usb.keep_alive import keep_alive
from kinect.usb.motor import Motor
from kinect.usb.packet import DEPTH_11, StreamFormat
from kinect.usb.pyusb_names import NamesMissing
from kinect.usb.read_calibration import read_calibration
from kinect.usb.ring import IsoRing, RingSize
from kinect.usb.stream_registers import DEPTH_ENDPOINT, START_DEPTH, STOP_DEPTH, STOP_VIDEO, VIDEO_ENDPOINT, Video, write_all

TROUBLE: Final = (usb.core.USBError, NotImplementedError, KinectError)


class Arrival(NamedTuple):
    """A frame as it came off the wire, and when, on the host's clock."""

    frame: AssembledFrame
    host_s: float


class OpenedKinect:
    """Holds the camera's handle and, on model 1414, the motor's. Raises KinectError with a remedy where it cannot be had."""

    def __init__(self, found: FoundKinect, clock: Clock, tally: SimpleNamespace, size: RingSize, video: Video) -> None:
        self.found = found
        self.what = f"the Kinect's camera ({found.place})"
        self.depth: list[Arrival] = []
        self.video: list[Arrival] = []
        self.motor: Motor | None = None
        self._clock, self._tally, self._size, self._video_kind = clock, tally, size, video
        self._readers: list[tuple[IsoRing | IsoReadThreads, Assembler]] = []
        claim_camera(found.camera, self.what)
        try:
            self.commands = CameraCommands(found.camera, clock, tally)
            if found.audio is not None and not found.model.has_motor_device:
                keep_alive(found.audio)
            write_all(self.commands, STOP_DEPTH + STOP_VIDEO)  # a program that died may have left them running
            self.calibration = read_calibration(self.commands)
            self._readers = [self._reader(DEPTH_ENDPOINT, DEPTH_11, self.depth)]
            if video is not Video.OFF:
                self._readers.append(self._reader(VIDEO_ENDPOINT, video.layout, self.video))
        except TROUBLE as error:
            let_go(found.camera)
            raise explained(error, self.what) from None
        with contextlib.suppress(*TROUBLE):  # without a motor the rest works all the same
            self.motor = Motor(found.motor) if found.motor is not None else None

    @property
    def sends_depth(self) -> str:
        """What to say while all is well."""
        return f"{self.found.model.value} on {self.found.place} sends depth."

    @property
    def unplugged(self) -> bool:
        """Whether a transfer came back saying that the device is gone."""
        return any(reader.unplugged for reader, _ in self._readers)

    @property
    def listening(self) -> bool:
        """Whether transfers are queued at all."""
        return all(reader.in_flight > 0 for reader, _ in self._readers)

    def start_streams(self) -> None:
        """Queue the transfers, then tell the camera to send."""
        try:
            for reader, assembler in self._readers:
                assembler.reset()
                reader.start()
            write_all(self.commands, START_DEPTH + self._video_kind.start)
        except TROUBLE as error:
            self._stop_readers()
            raise explained(error, self.what) from None
        self._tally.stream_starts += 1

    def stop_streams(self) -> None:
        """Tell the camera to stop, then cancel the transfers and wait for them. Never raises."""
        with contextlib.suppress(*TROUBLE):
            if not self.unplugged:
                write_all(self.commands, STOP_DEPTH + (STOP_VIDEO if self._video_kind is not Video.OFF else ()))
        self._stop_readers()

    def pump(self, timeout_s: float) -> None:
        """Wait at most so long for transfers; whole frames land in `depth` and `video`."""
        for reader, _ in self._readers:
            reader.pump(timeout_s)
            if isinstance(reader, IsoRing):
                return  # libusb's events serve all rings at once

    def close(self) -> None:
        """Stop everything and let go of every handle. Never raises."""
        self.stop_streams()
        self._readers = []  # they refer back to us, and pyusb forgets to give a device back that only the garbage collector frees
        if self.motor is not None:
            self.motor.close()
        let_go(self.found.camera)

    def _stop_readers(self) -> None:
        for reader, _ in self._readers:
            reader.stop()

    def _reader(self, endpoint: int, layout: StreamFormat, arrivals: list[Arrival]) -> tuple[IsoRing | IsoReadThreads, Assembler]:
        assembler = Assembler(layout, self._tally)

        def consume(slots: Any, lengths: Any, statuses: Any) -> None:
            closed = assembler.take(slots, lengths, statuses)
            arrivals.extend(Arrival(frame, self._clock.now()) for frame in closed)

        try:
            return IsoRing(self.found.camera, endpoint, consume, self._tally, self._size), assembler
        except NamesMissing:
            return IsoReadThreads(self.found.camera, endpoint, consume, self._tally), assembler
