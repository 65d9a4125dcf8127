"""The sensor in a living room: every fault has its words, what can heal heals, and a pulled plug is a pause."""

import numpy as np
import pytest

from kinect.usb.errors import Fault
from kinect.usb.models import Model
from kinect.usb.sensor import KinectSensor
from kinect.usb.sensor_options import SensorOptions, SensorState
from kinect.usb.simulated_faults import FAULTS, ROOMS
from kinect.usb.simulated_kinect import SimulatedKinect
from kinect.usb.simulated_libusb import in_use, kill_program, misuse
from kinect.usb.simulated_stream import replayed
from kinect.usb.stream_registers import DEPTH_ENDPOINT, VIDEO_ENDPOINT, Video
from tests.usb.simulated_sensor import PICTURES, bench

WORDS = {
    "no-libusb": (Fault.NO_LIBUSB, "pip install libusb-package"),
    "permission": (Fault.PERMISSION, "install the udev rule"),
    "busy": (Fault.BUSY, "close the other program"),
    "refused": (Fault.REFUSED, "another port"),
    "lossy": (Fault.LOSSY, "5% of the Kinect's packets are lost"),
    "silent": (Fault.SILENT, "sends no pictures"),
    "mute": (Fault.PROTOCOL, "does not answer command"),
    "unplugged": (Fault.UNPLUGGED, "plug it in again"),
    "no-device": (Fault.NO_DEVICE, "I see no Kinect"),
    "no-power": (Fault.NO_POWER, "but not its camera: is the 12 V supply plugged in?"),
    "no-power-1473": (Fault.NO_POWER, "but not its camera: is the 12 V supply plugged in?"),
    "kinect-v2": (Fault.KINECT_V2, "Kinect v2"),
    "azure": (Fault.AZURE, "Azure Kinect"),
}


@pytest.mark.parametrize("fault", WORDS)
def test_each_fault_that_needs_a_person_has_its_words_and_leaves_nothing_open(fault: str) -> None:
    b = bench(fault)
    b.run(4.5)
    expected, words = WORDS[fault]
    assert b.sensor.fault is expected and words in b.sensor.status
    b.sensor.close()
    assert in_use(b.simulation.host) == {"handles": 0, "transfers": 0, "references": 0} and misuse() == []


@pytest.mark.parametrize("fault", [f for f in FAULTS if f not in WORDS and f not in ROOMS])
def test_each_other_fault_heals_by_itself(fault: str) -> None:
    b = bench(fault)
    assert b.run(5.0, until=lambda: b.clock.now() > 4.1 and b.sensor.state is SensorState.STREAMING)
    assert b.sensor.fault is None and "sends depth" in b.sensor.status
    assert len(b.frames) > 25
    b.sensor.close()
    assert in_use(b.simulation.host) == {"handles": 0, "transfers": 0, "references": 0} and misuse() == []


@pytest.mark.parametrize("silent", [False, True], ids=["told by the system", "told by nobody"])
def test_a_pulled_plug_is_told_within_half_a_second_and_a_plug_put_back_streams_within_three(silent: bool) -> None:
    b = bench()
    b.run(1.0)
    host, kinect = b.simulation.host, b.simulation.kinect
    before = len(b.frames)
    host.unplug(kinect, silent)
    pulled = b.clock.now()
    assert b.run(1.0, until=lambda: b.sensor.fault is Fault.UNPLUGGED)
    assert b.clock.now() - pulled <= 0.5
    b.run(2.0)
    assert b.sensor.fault is Fault.UNPLUGGED and len(b.frames) <= before + 4
    host.plug(kinect)
    back, shown = b.clock.now(), len(b.frames)
    assert b.run(3.0, until=lambda: len(b.frames) > shown)
    assert b.clock.now() - back <= 3.0 and b.sensor.state is SensorState.STREAMING
    times = [frame.time_s for frame in b.frames]
    assert all(np.diff(times) > 0) and 2.0 < times[shown] - times[shown - 1] < 4.0
    assert b.sensor.counters().unplugs == 1
    b.sensor.close()
    assert in_use(host)["handles"] == in_use(host)["transfers"] == 0 and misuse() == []


def test_a_kinect_put_into_another_port_is_the_same_to_the_game() -> None:
    b = bench()
    b.run(0.5)
    b.simulation.host.unplug(b.simulation.kinect)
    b.simulation.host.plug(SimulatedKinect(replayed(PICTURES), Model.XBOX_1473, ports=(7, 3)))
    shown = len(b.frames)
    assert b.run(2.0, until=lambda: len(b.frames) > shown + 5)
    assert b.sensor.model is Model.XBOX_1473 and "port 7.3.1" in b.sensor.status
    b.sensor.close()


def test_a_stream_that_falls_silent_is_started_anew_after_two_seconds() -> None:
    b = bench()
    b.run(1.0)
    camera = b.simulation.kinect.camera
    camera.streams.clear()
    stopped, shown = b.clock.now(), len(b.frames)
    assert b.run(4.0, until=lambda: len(b.frames) > shown + 3)
    assert 2.0 < b.clock.now() - stopped < 2.5
    assert b.sensor.counters().stream_restarts == 1 and b.sensor.counters().reopens == 0
    assert b.sensor.fault is None
    b.sensor.close()


def test_three_silences_in_a_row_open_the_device_anew_and_the_words_stay_until_a_picture_comes() -> None:
    b = bench("silent")
    b.run(6.5)
    assert (b.sensor.counters().stream_restarts, b.sensor.counters().reopens) == (2, 1)
    assert b.sensor.fault is Fault.SILENT
    b.simulation.kinect.camera.sends = True
    assert b.run(1.0, until=lambda: b.sensor.fault is None)
    b.sensor.close()


def test_a_transfer_cancelled_by_nobody_means_unplugged() -> None:
    b = bench()
    b.run(0.5)
    host = b.simulation.host
    host.cancel(next(iter(host.submissions)))
    b.run(0.1)
    assert b.sensor.counters().unplugs == 1
    assert b.run(2.0, until=lambda: b.sensor.state is SensorState.STREAMING)
    b.sensor.close()


@pytest.mark.parametrize("moment_s", [0.001, 0.004, 0.010, 0.0135, 0.02, 0.5])
def test_a_killed_program_leaves_a_device_that_opens_again(moment_s: float) -> None:
    b = bench()
    b.run(moment_s)
    camera = b.simulation.kinect.camera
    camera.answers.append((0.0, bytes.fromhex("52 42 01 00 03 00 39 00 00 00")))
    kill_program(b.simulation.host)
    heir = KinectSensor(b.simulation.load, b.clock)
    b.sensor = heir
    shown = len(b.frames)
    assert b.run(1.0, until=lambda: len(b.frames) > shown + 5)
    assert heir.fault is None and heir.counters().opens_failed == 0
    if moment_s < 0.4:
        assert heir.counters().replies_stale >= 1
    heir.close()


def test_closing_switches_projector_and_stream_off_and_is_harmless_twice() -> None:
    b = bench()
    b.run(0.5)
    b.sensor.close()
    b.sensor.close()
    assert b.simulation.kinect.camera.registers[0x06] == 0
    assert b.sensor.state is SensorState.CLOSED


def test_depth_starts_with_the_registers_of_the_working_drivers_and_colour_stays_off() -> None:
    b = bench()
    b.run(0.5)
    registers = b.simulation.kinect.camera.registers
    assert {r: registers[r] for r in (0x105, 0x06, 0x12, 0x13, 0x14, 0x17)} == {0x105: 0, 0x06: 2, 0x12: 3, 0x13: 1, 0x14: 30, 0x17: 0}
    assert registers[0x05] == 0 and VIDEO_ENDPOINT not in b.simulation.kinect.camera.streams
    b.sensor.close()


@pytest.mark.parametrize(("video", "octets", "register"), [(Video.RGB, 307_200, 1), (Video.INFRARED, 390_400, 3)])
def test_colour_or_infrared_run_beside_depth_where_asked_for(video: Video, octets: int, register: int) -> None:
    b = bench(options=SensorOptions(video=video))
    b.run(0.6)
    frame = b.sensor.latest_video()
    assert frame is not None and frame.octets.size == octets and frame.packets == frame.packets_expected
    assert b.simulation.kinect.camera.registers[0x05] == register and len(b.frames) > 10
    b.sensor.close()
    assert b.simulation.kinect.camera.registers[0x05] == 0


def test_a_sensor_that_nobody_asks_keeps_the_newest_frames_and_counts_the_rest() -> None:
    b = bench()
    while b.clock.now() < 2.0:
        b.sensor.step()
    kept = b.sensor.poll()
    assert len(kept) == 8 and b.sensor.counters().frames_overrun > 40
    sent = b.simulation.kinect.camera.streams[DEPTH_ENDPOINT].frames_sent(int(b.clock.now() * 8000))
    np.testing.assert_array_equal(kept[-1].disparity, PICTURES[(sent - 1) % 4])
    b.sensor.close()


def test_a_motor_that_fails_does_not_stop_the_depth() -> None:
    b = bench()
    b.run(0.5)
    b.simulation.kinect.motor.gone = True
    shown = len(b.frames)
    b.run(2.0)
    assert b.sensor.fault is None and len(b.frames) > shown + 50
    b.sensor.close()


def test_a_mistake_of_the_drivers_own_is_logged_and_not_the_end(monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture) -> None:
    b = bench()
    b.run(0.5)
    monkeypatch.setattr("kinect.usb.sensor.unpack11", lambda data: 1 / 0)
    b.run(0.1)
    assert "made a mistake" in caplog.text and b.sensor.state is not SensorState.STREAMING
    monkeypatch.undo()
    assert b.run(2.0, until=lambda: b.sensor.state is SensorState.STREAMING)
    b.sensor.close()
