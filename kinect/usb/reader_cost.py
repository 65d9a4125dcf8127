"""What reading a Kinect costs: the whole driver in real time against a simulated host, decoded to metres.

    python -m kinect.usb.reader_cost

What the simulated host spends on making packets is measured and taken off; its bookkeeping inside the reader's own calls is not.
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
    """cpu_share: the reader's CPU time over real time, 1 is one core. with_simulation: the same for the whole process."""

    seconds: float
    frames: int
    cpu_share: float
    with_simulation: float
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
        depth = np.empty((480, 640), np.float32)
        frames, wall, cpu, simulated = 0, time.perf_counter(), time.process_time(), simulation.host.own_cpu_s
        while time.perf_counter() - wall < seconds:
            for frame in sensor.poll():
                metres.take(frame.disparity, out=depth, mode="clip")
                frames += 1
            time.sleep(POLL_S)
        spent, passed = time.process_time() - cpu, time.perf_counter() - wall
        own = simulation.host.own_cpu_s - simulated
        return ReaderCost(passed, frames, (spent - own) / passed, spent / passed, sensor.counters())
    finally:
        sensor.close()


if __name__ == "__main__":
    cost = reader_cost()
    print(cost.counters)
    print(f"{cost.frames / cost.seconds:.2f} frames/s, {cost.cpu_share:.1%} of one core ({cost.with_simulation:.1%} with the simulation)")
