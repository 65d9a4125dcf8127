"""A Kinect attached to the bus, here a simulated one, as a stream of depth frames with its own calibration and tilt."""

import math
import time
from collections.abc import Callable

import pytest

from game.inputs.kinect_replay import DepthInput
from kinect.depth.depth_stream import SensorDepth
from kinect.usb.sensor import KinectSensor
from kinect.usb.simulated_faults import simulate
from kinect.usb.simulated_room import Room
from tests.usb.simulated_sensor import bench


def comes_true(condition: Callable[[], object], within_s: float = 5.0) -> bool:
    """Wait for it in real time."""
    end = time.monotonic() + within_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.01)
    return False


def test_the_floor_of_a_room_is_found_from_what_came_over_the_wire() -> None:
    room = Room(height_m=1.0, pitch_rad=-0.12)
    b = bench(source=room.source())
    b.simulation.kinect.motor.counts = room.counts
    stepped = b.sensor

    class Stepped(SensorDepth):
        """The same without a thread: the clock is a simulated one."""

        def __init__(self) -> None:
            self._sensor = stepped

        def poll(self, until_s: float) -> list:
            for _ in range(8):
                stepped.step(0.02)
            return super().poll(until_s)

    source = DepthInput(Stepped())
    for k in range(40):
        source.poll(k / 30.0)
        source.depth()
    assert source.length_s is None and "sends depth" in source.status
    source.close()
    floor = source.floor
    assert floor is not None
    up = (0.0, math.cos(-0.12), math.sin(-0.12))
    lean = math.degrees(math.acos(min(1.0, sum(a * b for a, b in zip(floor[:3], up)))))
    assert lean < 0.5 and floor.d == pytest.approx(1.0, abs=0.01)


def test_in_a_thread_of_its_own_it_streams_is_unplugged_and_comes_back() -> None:
    room = Room()
    simulation = simulate("none", source=room.source())
    source = DepthInput(SensorDepth(KinectSensor(simulation.load)))
    assert comes_true(source.depth)
    assert "sends depth" in source.status
    simulation.host.unplug(simulation.kinect)
    assert comes_true(lambda: "unplugged" in source.status, 1.5)
    assert len(source.poll(0.5)) == 16, "the stand-in stands on"
    simulation.host.plug(simulation.kinect)
    assert comes_true(lambda: "sends depth" in source.status, 4.0)
    source.close()
    source.close()
    assert "switched off" in source.status
