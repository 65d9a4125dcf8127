"""A sensor on a simulated bus and a virtual clock, for the tests of this room."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from kinect.usb.raw_depth_frame import RawDepthFrame
from kinect.usb.sensor import KinectSensor
from kinect.usb.sensor_options import SensorOptions
from kinect.usb.simulated_clock import VirtualClock
from kinect.usb.simulated_faults import Simulation, simulate
from kinect.usb.simulated_stream import FrameSource, replayed

SHARED = Path(__file__).resolve().parents[2] / ".." / "shared" / "data" / "depth"


def noise_pictures(count: int = 4, seed: int = 0) -> list[np.ndarray]:
    """Raw pictures in which every bit matters."""
    random = np.random.default_rng(seed)
    return [random.integers(0, 2048, (480, 640), np.uint16) for _ in range(count)]


PICTURES = noise_pictures()


@dataclass
class Bench:
    """A simulation and the sensor that looks at it."""

    simulation: Simulation
    sensor: KinectSensor
    clock: VirtualClock
    frames: list[RawDepthFrame] = field(default_factory=list)

    def run(self, seconds: float, until: Callable[[], bool] = lambda: False) -> bool:
        """Let so much virtual time pass, or less if `until` comes true. Whether it did."""
        end = self.clock.now() + seconds
        while self.clock.now() < end:
            self.sensor.step(0.02)
            self.frames += self.sensor.poll()
            if until():
                return True
        return False


def bench(
    fault: str = "none",
    options: SensorOptions | None = None,
    hold_s: float = 0.0,
    callback_s: float = 0.0,
    source: FrameSource | None = None,
) -> Bench:
    """A Kinect that sends four pictures of noise over and over, with this fault."""
    clock = VirtualClock(0.5, hold_s)
    simulation = simulate(fault, clock, source or replayed(PICTURES))
    simulation.host.callback_s = callback_s
    return Bench(simulation, KinectSensor(simulation.load, clock, options), clock)
