"""What reading a Kinect costs: the whole driver in real time against a simulated host, decoded to metres.

    python -m kinect.usb.reader_cost

The figure includes the simulation of host and device, so that the reader itself costs less.
"""

import time
from dataclasses import dataclass

import numpy as np

from kinect.device_calibration import TYPICAL
from kinect.usb.counters import Counters
from kinect.usb.sensor import KinectSensor
from kinect.usb.simulated_faults import simulate
from kinect.usb.simulated_room import Room
from kinect.usb.simulated_stream import replayed

POLL_S = 1.0 / 60.0


@dataclass(frozen=True)
class ReaderCost:
    """cpu_share: process CPU time over real time, 1 is one core. frames: seen by the caller in `seconds`."""

    seconds: float
    frames: int
    cpu_share: float
    counters: Counters


def reader_cost(seconds: float = 10.0) -> ReaderCost:
    """Run the sensor in its thread for so many seconds, asking for frames 60 times a second and turning each into metres."""
    source = replayed([Room().disparity(k) for k in range(0, 60, 10)])
    for k in range(6):
        source(k)  # packed before the clock runs
    raw = np.arange(2048)
    m = (raw / 4.0 - TYPICAL.const_shift - 0.375) * TYPICAL.zero_plane_pixel_size_m
    metres = (TYPICAL.zero_plane_distance_m * TYPICAL.baseline_m / (TYPICAL.baseline_m - m)).astype(np.float32)
    simulation = simulate("none", source=source)
    sensor = KinectSensor(simulation.load).start()
    try:
        while not sensor.poll():
            time.sleep(POLL_S)
        frames, wall, cpu = 0, time.perf_counter(), time.process_time()
        while time.perf_counter() - wall < seconds:
            for frame in sensor.poll():
                metres.take(frame.disparity)
                frames += 1
            time.sleep(POLL_S)
        spent, passed = time.process_time() - cpu, time.perf_counter() - wall
        return ReaderCost(passed, frames, spent / passed, sensor.counters())
    finally:
        sensor.close()


if __name__ == "__main__":
    cost = reader_cost()
    print(f"{cost.frames / cost.seconds:.2f} frames/s, {cost.cpu_share:.1%} of one core, {cost.counters}")
