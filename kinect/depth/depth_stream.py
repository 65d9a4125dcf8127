"""Where depth frames come from as time passes: a recording frame by frame, the same through the whole driver, or a sensor."""

from collections.abc import Iterator
from typing import Final, Protocol

from kinect.depth.depth_frame import COUNTS_PER_G, DepthFrame
from kinect.depth.intrinsics import Intrinsics, factory_intrinsics
from kinect.depth.recording_format import DepthRecording, DepthRecordingError
from kinect.device_calibration import DeviceCalibration
from kinect.usb.motor import MotorState
from kinect.usb.raw_depth_frame import RawDepthFrame
from kinect.usb.sensor import KinectSensor
from kinect.usb.wire_replay import WireReplay

LEVEL_COUNTS: Final = (0, 819, 0)


class DepthStream(Protocol):
    """A stream of depth frames; like a BodySource it never raises into the loop but says what is wrong in `status`."""

    @property
    def status(self) -> str:
        """What the stream gives, in plain words."""
        ...

    @property
    def length_s(self) -> float | None:
        """Length of the recording, seconds; None for a sensor."""
        ...

    def poll(self, until_s: float) -> list[DepthFrame]:
        """Every frame not yet handed out with time_s <= until_s, oldest first; of a sensor whatever has arrived."""
        ...

    def close(self) -> None:
        """Release what the stream holds. Calling it twice is harmless."""
        ...


class RecordedDepth:
    """A recording on the clock it is polled with."""

    def __init__(self, recording: DepthRecording) -> None:
        self._recording = recording
        self._frames: Iterator[DepthFrame] = iter(recording)
        self._waiting: DepthFrame | None = None
        self._now_s = 0.0
        self._fault = ""
        self._ended = False

    @property
    def status(self) -> str:
        if self._fault:
            return self._fault
        length = self.length_s
        place = f"ended after {length:.1f} s" if self._ended else f"{min(self._now_s, length):.1f} of {length:.1f} s"
        return f"Recorded depth, {place}."

    @property
    def length_s(self) -> float:
        return self._recording.length_s

    def poll(self, until_s: float) -> list[DepthFrame]:
        """Every frame not yet handed out with time_s <= until_s."""
        self._now_s = max(self._now_s, until_s)
        ready: list[DepthFrame] = []
        while not self._ended:
            if self._waiting is None:
                self._waiting = self._next()
            if self._waiting is None or self._waiting.time_s > until_s:
                break
            ready.append(self._waiting)
            self._waiting = None
        return ready

    def close(self) -> None:
        """Hand out no more frames."""
        self._ended, self._frames, self._waiting = True, iter(()), None

    def _next(self) -> DepthFrame | None:
        try:
            frame = next(self._frames, None)
        except DepthRecordingError as fault:
            self._fault, frame = str(fault), None
        self._ended = frame is None
        return frame


class WiredDepth:
    """A recording sent once more through packets, pyusb and the driver, as if a sensor stood there. Holds all of it in memory."""

    def __init__(self, recording: DepthRecording) -> None:
        """Raises DepthRecordingError where the recording cannot be read."""
        frames = list(recording)
        first = frames[0]
        self._name, self._first = recording.name, first
        ticks = [frame.ticks for frame in frames]
        self._replay = WireReplay([frame.raw for frame in frames], ticks, False, first.calibration, first.accel or LEVEL_COUNTS)
        self.length_s: float = self._replay.length_s

    @property
    def status(self) -> str:
        return f"{self._name} as a sensor: {self._replay.sensor.status}"

    def poll(self, until_s: float) -> list[DepthFrame]:
        """Every frame that the simulated sensor has sent by then, under the recording's own calibration: the wire rounds its shift."""
        level = None if self._first.accel is None else self._replay.sensor.level
        calibration, intrinsics = self._first.calibration, self._first.intrinsics
        return [_frame(raw, level, calibration, intrinsics) for raw in self._replay.poll(until_s)]

    def close(self) -> None:
        """Let go of the simulated device."""
        self._replay.close()


class SensorDepth:
    """A Kinect that is attached, or will be: `KinectSensor` in a thread of its own."""

    length_s: float | None = None

    def __init__(self, sensor: KinectSensor | None = None) -> None:
        self._sensor = (sensor or KinectSensor()).start()

    @property
    def status(self) -> str:
        return self._sensor.status

    def poll(self, until_s: float) -> list[DepthFrame]:
        """The frames that have arrived, whatever until_s."""
        sensor = self._sensor
        calibration = sensor.calibration
        return [_frame(raw, sensor.level, calibration, factory_intrinsics(calibration)) for raw in sensor.poll()]

    def close(self) -> None:
        """Stop the sensor and end its thread."""
        self._sensor.close()


def _frame(raw: RawDepthFrame, level: MotorState | None, calibration: DeviceCalibration, intrinsics: Intrinsics) -> DepthFrame:
    accel = None
    if level is not None:
        x, y, z = (round(COUNTS_PER_G * g) for g in level.acceleration)
        accel = (x, y, z)
    return DepthFrame(raw.disparity, raw.time_s, raw.ticks, accel, calibration, intrinsics)
