"""A live Kinect as an input: it streams beside the game, says what is wrong, waits out a pulled plug, and leaves nothing behind."""

import gc
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

from game.inputs.kinect_live import LiveKinect
from game.inputs.kinect_live_switching import STREAMING_INTERVAL_S, hold_quick_switching, let_go_of_quick_switching
from game.inputs.kinect_replay import NO_BODY
from game.inputs.open_input import open_input
from kinect.depth.depth_seen import depth_seen_by
from kinect.usb.sensor import KinectSensor
from kinect.usb.simulated_faults import Simulation, simulate
from kinect.usb.simulated_libusb import in_use, misuse


def live(simulation: Simulation) -> LiveKinect:
    return LiveKinect(lambda: KinectSensor(simulation.load))


def comes_true(condition: Callable[[], Any], within_s: float = 5.0) -> float | None:
    """Wait for it in real time; how long it took, None where it did not come."""
    began = time.monotonic()
    while time.monotonic() - began < within_s:
        if condition():
            return time.monotonic() - began
        time.sleep(0.005)
    return None


def threads() -> set[str]:
    return {thread.name for thread in threading.enumerate() if thread.name.startswith("kinect")}


def test_it_streams_depth_and_finds_the_floor_while_a_stand_in_stands() -> None:
    source = live(simulate("none"))
    assert source.status == "Looking for a Kinect." and source.interrupted == ""
    assert comes_true(source.depth) is not None
    assert comes_true(lambda: source.depth() and source.floor) is not None
    assert source.floor is not None and source.floor.d == pytest.approx(0.9, abs=0.02)
    assert source.drawn_floor == source.floor and "0.90 m" in source.floor_why
    frames = source.poll(1.0)
    assert [round(30 * f.time_s) for f in frames] == list(range(31)) and source.length_s is None
    assert all((f.positions == frames[0].positions).all() for f in frames)
    assert "sends depth" in source.status and NO_BODY in source.status and "Floor 0.90 m below" in source.status
    assert depth_seen_by(source) is source
    source.close()


def test_a_room_without_a_floor_in_view_is_said_and_drawn_by_a_guess() -> None:
    source = live(simulate("tilted"))
    assert comes_true(lambda: source.depth() and source.drawn_floor) is not None
    assert source.floor is None and "No floor seen." in source.status and "no floor in view" in source.floor_why
    source.close()


def test_a_pulled_plug_is_said_within_half_a_second_and_pictures_come_back_within_three() -> None:
    simulation = simulate("none")
    source = live(simulation)
    assert comes_true(source.depth) is not None and source.interrupted == ""
    simulation.host.unplug(simulation.kinect)
    told = comes_true(lambda: source.interrupted, 2.0)
    assert told is not None and told < 0.5
    assert "unplugged" in source.interrupted and source.status == source.interrupted
    last = source.depth()
    assert last is not None, "the last picture stays"
    time.sleep(0.3)
    simulation.host.plug(simulation.kinect)
    back = comes_true(lambda: source.interrupted == "" and source.depth() is not last, 5.0)
    assert back is not None and back < 3.0
    newest = source.depth()
    assert newest is not None and newest.time_s > last.time_s
    source.close()
    assert in_use(simulation.host)["handles"] == 0


@pytest.mark.parametrize(("fault", "words"), [("no-device", "I see no Kinect"), ("no-power", "12 V"), ("permission", "install-rules")])
def test_what_never_came_is_said_but_nobody_waits_for_it(fault: str, words: str) -> None:
    source = live(simulate(fault))
    source.poll(0.0)
    assert comes_true(lambda: words in source.status, 3.0) is not None
    assert source.interrupted == "" and source.depth() is None
    assert len(source.poll(0.5)) == 15
    source.close()


def test_a_kinect_plugged_in_later_is_found() -> None:
    simulation = simulate("none")
    simulation.host.unplug(simulation.kinect)
    source = live(simulation)
    source.poll(0.0)
    assert comes_true(lambda: "I see no Kinect" in source.status) is not None
    simulation.host.plug(simulation.kinect)
    assert comes_true(source.depth, 3.0) is not None
    source.close()


def test_no_call_waits_for_the_bus() -> None:
    """The bus takes 0.4 s for each look, as a real one may."""
    simulation = simulate("none")

    def slowly() -> Any:
        time.sleep(0.4)
        return simulation.load()

    source = LiveKinect(lambda: KinectSensor(slowly))
    longest, began = 0.0, time.monotonic()
    while time.monotonic() - began < 1.5:
        before = time.monotonic()
        source.poll(before - began)
        source.depth()
        longest = max(longest, time.monotonic() - before)
        time.sleep(0.005)
    assert source.depth() is not None and longest < 0.1
    source.close()


def test_the_device_is_not_touched_until_it_is_polled() -> None:
    simulation = simulate("none")
    before = threads()
    source = live(simulation)
    source.close()
    assert source.poll(1.0) == [] and source.depth() is None
    assert simulation.kinect.camera.registers.get(0x06, 0) == 0 and threads() == before
    assert source.status == "The Kinect was switched off."


def test_opening_and_closing_leaves_no_thread_no_handle_and_the_interpreter_as_it_was() -> None:
    simulation = simulate("none")
    interval, before = sys.getswitchinterval(), threads()
    for _ in range(10):
        source = live(simulation)
        assert comes_true(source.depth) is not None
        assert sys.getswitchinterval() == pytest.approx(STREAMING_INTERVAL_S)
        assert threads() > before
        source.close()
        source.close()
        assert source.poll(9.0) == [] and source.interrupted == ""
    del source
    gc.collect()
    assert threads() == before and sys.getswitchinterval() == pytest.approx(interval)
    assert in_use(simulation.host) == {"handles": 0, "transfers": 0, "references": 0} and misuse() == []


def test_closed_while_it_opens_it_leaves_the_device_to_the_next() -> None:
    """As when a scene is entered twice in a row."""
    simulation = simulate("none")
    before = threads()
    for k in range(8):
        source = live(simulation)
        source.poll(0.0)
        time.sleep(0.01 * k)
        source.close()
    source = live(simulation)
    assert comes_true(source.depth, 3.0) is not None
    source.close()
    assert threads() == before and in_use(simulation.host)["handles"] == 0 and misuse() == []


def test_of_two_sensors_the_last_to_end_puts_the_interpreter_back() -> None:
    interval = sys.getswitchinterval()
    hold_quick_switching()
    hold_quick_switching()
    let_go_of_quick_switching()
    assert sys.getswitchinterval() == pytest.approx(STREAMING_INTERVAL_S)
    let_go_of_quick_switching()
    assert sys.getswitchinterval() == pytest.approx(interval)


def test_the_word_kinect_opens_it() -> None:
    source = open_input("kinect")
    assert isinstance(source, LiveKinect)
    source.close()
