"""Any sequence of raw depth pictures sent once more through packets, pyusb and the whole driver, as if a sensor stood there."""

import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinect.device_calibration import TYPICAL, DeviceCalibration
from kinect.usb.capture_time import DEPTH_PERIOD_TICKS, WRAP
from kinect.usb.raw_depth_frame import RawDepthFrame
from kinect.usb.sensor import KinectSensor
from kinect.usb.sensor_options import SensorOptions
from kinect.usb.simulated_clock import VirtualClock
from kinect.usb.simulated_host import SimulatedHost
from kinect.usb.simulated_kinect import SimulatedKinect
from kinect.usb.simulated_libusb import simulated_backend
from kinect.usb.simulated_stream import replayed


def places_of(ticks: Sequence[int]) -> list[int]:
    """Each recorded frame's place in time, in frame periods from the first; a frame that the recording lost leaves its place empty.

    Raises ValueError where two frames fall on one place, or one lies before the other.
    """
    places, unwrapped = [0], 0
    for before, after in itertools.pairwise(ticks):
        unwrapped += (int(after) - int(before)) % WRAP
        places.append(round(unwrapped / DEPTH_PERIOD_TICKS))
    if any(b <= a for a, b in itertools.pairwise(places)):
        raise ValueError("a recording's frames lie at least one frame period (2,002,155 ticks) apart and in order; these do not")
    return places


class WireReplay:
    """A simulated Kinect that sends `frames` ((480, 640) raw disparities), on a clock that passes as fast as asked.

    `sensor` is a real KinectSensor. `ticks`: the recorded ones, so that gaps stay gaps. Without `loop` it falls silent at its end.
    """

    def __init__(
        self,
        frames: Sequence[NDArray[np.uint16]],
        ticks: Sequence[int] | None = None,
        loop: bool = False,
        calibration: DeviceCalibration = TYPICAL,
        counts: tuple[int, int, int] = (0, 812, 20),
    ) -> None:
        places = places_of(ticks) if ticks is not None else list(range(len(frames)))
        self.length_s = (places[-1] + 1) * DEPTH_PERIOD_TICKS / 60e6 if places else 0.0
        self.clock = VirtualClock()
        self.host = SimulatedHost(self.clock)
        self.kinect = SimulatedKinect(replayed(frames, places, loop), calibration=calibration)
        self.kinect.motor.counts = counts
        self.host.plug(self.kinect)
        backend = simulated_backend(self.host)
        options = SensorOptions(silence_s=1e9 if not loop else 2.0, presence_after_s=1e9 if not loop else 0.25)
        self.sensor = KinectSensor(lambda: backend, self.clock, options)
        self._loop = loop
        self._began_s: float | None = None
        self._waiting: list[RawDepthFrame] = []

    def poll(self, until_s: float) -> list[RawDepthFrame]:
        """Every frame not yet handed out with time_s <= until_s; the first has time_s 0."""
        last = until_s if self._loop else min(until_s, self.length_s)
        while self._began_s is None or self.clock.now() < self._began_s + last + 0.1:
            self.sensor.step()
            arrived = self.sensor.poll()
            if arrived and self._began_s is None:
                self._began_s = self.clock.now()
            self._waiting += arrived
            if self._began_s is None and self.clock.now() > 5.0:
                break  # `sensor.status` says why
        ready = [frame for frame in self._waiting if frame.time_s <= until_s]
        self._waiting = self._waiting[len(ready) :]
        return ready

    def close(self) -> None:
        """Let go of the simulated device. Calling it twice is harmless."""
        self.sensor.close()
