"""Plugs pulled a hundred times, and a thousand random misfortunes: nothing is left open, and it always streams again."""

import gc
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from kinect.usb.errors import Fault
from kinect.usb.sensor import KinectSensor
from kinect.usb.sensor_options import SensorOptions, SensorState
from kinect.usb.simulated_faults import simulate
from kinect.usb.simulated_libusb import in_use, misuse
from kinect.usb.simulated_stream import replayed
from tests.usb.simulated_sensor import PICTURES, Bench, bench

NOTHING = {"handles": 0, "transfers": 0, "references": 0}
QUICK = SensorOptions(look_every_s=0.1, silence_s=0.2, presence_after_s=0.08)


def file_handles() -> int:
    """Open files of this process, 0 where the system does not tell."""
    folder = Path("/proc/self/fd")
    return len(list(folder.iterdir())) if folder.exists() else 0


def test_a_hundred_plugs_pulled_and_put_back_leave_nothing_behind() -> None:
    gc.collect()
    gc.disable()  # whatever only the collector would free counts as a leak
    b = bench()
    host, kinect = b.simulation.host, b.simulation.kinect
    told, resumed = [], []
    held = None
    for cycle in range(100):
        shown = len(b.frames)
        start = b.clock.now()
        assert b.run(3.0, until=lambda shown=shown: len(b.frames) > shown + 2)
        resumed.append(b.clock.now() - start)
        held = held or in_use(host)
        assert in_use(host) == held
        host.unplug(kinect, silent=cycle % 3 == 2)
        start = b.clock.now()
        assert b.run(1.0, until=lambda: b.sensor.fault is Fault.UNPLUGGED)
        told.append(b.clock.now() - start)
        assert in_use(host)["transfers"] == in_use(host)["handles"] == 0
        host.plug(kinect)
        b.frames.clear()
    b.sensor.close()
    gc.enable()
    assert max(told) <= 0.5 and max(resumed) <= 3.0
    assert in_use(host) == NOTHING and misuse() == []
    assert b.sensor.counters().unplugs == 100 and b.sensor.counters().transfers_undrained == 0


def test_a_thread_started_and_stopped_leaves_no_thread_and_no_file_open() -> None:
    threads, files = threading.active_count(), file_handles()
    for _ in range(5):
        simulation = simulate("none", source=replayed(PICTURES))
        sensor = KinectSensor(simulation.load, options=QUICK).start()
        assert comes_true(lambda sensor=sensor: sensor.state is SensorState.STREAMING, 5.0)
        simulation.host.unplug(simulation.kinect)
        assert comes_true(lambda sensor=sensor: sensor.fault is Fault.UNPLUGGED, 0.5), "half a second of real time has passed"
        simulation.host.plug(simulation.kinect)
        assert comes_true(lambda sensor=sensor: sensor.state is SensorState.STREAMING, 3.0), "three seconds of real time have passed"
        sensor.close()
        assert in_use(simulation.host) == NOTHING
    assert threading.active_count() == threads and file_handles() == files
    assert misuse() == []


def comes_true(condition, within_s: float) -> bool:
    """Wait for it in real time."""
    end = time.monotonic() + within_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.005)
    return condition()


def misfortune(b: Bench, random: np.random.Generator) -> None:
    """One thing that goes wrong, or right again."""
    host, kinect = b.simulation.host, b.simulation.kinect
    plugged = any(device is kinect.camera for device in host.devices)
    kind = random.choice(["plug", "fault", "sends", "loss", "rights", "queue", "hold", "streams"])
    if kind == "plug":
        if plugged:
            host.unplug(kinect, silent=bool(random.integers(2)))
        else:
            host.plug(kinect)
    elif kind == "fault":
        kinect.camera.faults[str(random.choice(["stall", "not ready", "mute", "stale"]))] = int(random.integers(1, 12))
    elif kind == "sends":
        kinect.camera.sends = bool(random.integers(2))
    elif kind == "loss":
        host.loss = float(random.choice([0.0, 0.01, 0.3, 1.0]))
    elif kind == "rights":
        setattr(kinect.camera, str(random.choice(["busy", "forbidden", "kernel_driver"])), bool(random.integers(2)))
    elif kind == "queue":
        host.largest_queue = int(random.choice([0, 100, 300, 1 << 30]))
    elif kind == "streams":
        kinect.camera.streams.clear()
    else:
        b.clock.sleep(float(random.uniform(0.0, 0.4)))


def survives(seed: int) -> None:
    """A sequence of misfortunes at random moments, then all is put right: it must stream again, and leave nothing behind."""
    random = np.random.default_rng(seed)
    b = bench(options=QUICK)
    b.run(float(random.uniform(0.0, 0.1)))
    for _ in range(int(random.integers(3, 8))):
        misfortune(b, random)
        b.run(float(random.choice([0.0, 0.003, 0.02, 0.12])))
    host, kinect = b.simulation.host, b.simulation.kinect
    host.loss, host.largest_queue = 0.0, 1 << 30
    kinect.camera.busy = kinect.camera.forbidden = False
    kinect.camera.sends = True
    kinect.camera.faults.clear()
    if not any(device is kinect.camera for device in host.devices):
        host.plug(kinect)
    b.frames.clear()
    assert b.run(6.0, until=lambda: len(b.frames) > 1), f"sequence {seed}: {b.sensor.status}"
    for frame in b.frames[-1:]:
        assert frame.has_holes or any((frame.disparity == picture).all() for picture in PICTURES)
    b.sensor.close()
    assert in_use(host) == NOTHING, f"sequence {seed}"
    assert misuse() == [], f"sequence {seed}"
    assert b.sensor.counters().callback_errors == 0 and b.sensor.counters().transfers_undrained == 0


@pytest.mark.parametrize("first", range(0, 60, 20))
def test_sixty_random_sequences_of_misfortune_are_survived(first: int) -> None:
    for seed in range(first, first + 20):
        survives(seed)


@pytest.mark.slow
@pytest.mark.parametrize("first", range(1000, 2000, 250))
def test_a_thousand_random_sequences_of_misfortune_are_survived(first: int) -> None:
    for seed in range(first, first + 250):
        survives(seed)
