"""Recording a Kinect: what is written plays back, Ctrl-C and a kill keep it, a pulled plug is a pause."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from game.commands import BAD_INPUT, main
from game.commands.kinect_record import SteadyTicks, record
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.intrinsics import factory_intrinsics
from kinect.depth.recorder import DepthRecorder
from kinect.depth.recording import open_depth_recording
from kinect.depth.recording_format import TICK_WRAP, seconds_from_ticks
from kinect.device_calibration import TYPICAL
from kinect.usb.sensor import KinectSensor
from kinect.usb.simulated_faults import simulate
from kinect.usb.simulated_libusb import in_use
from tests.door.the_door import RUN_GAME

PERIOD_S = 2_002_155 / 60e6


def test_the_simulated_room_is_recorded_and_plays_back_through_the_input(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "room"
    assert main(["kinect", "record", str(out), "--seconds", "1.5", "--simulate", "room"]) == 0
    said = capsys.readouterr()
    assert f"--input kinect-replay:{out}" in said.out and "sends depth" in said.err
    recording = open_depth_recording(out)
    assert 15 <= len(recording) <= 45 and recording.times[-1] < 1.5
    frames = list(recording)
    assert frames[0].raw.shape == (480, 640) and frames[-1].accel is not None
    assert f"wrote {len(frames)} pictures" in said.out


def test_a_pulled_plug_is_a_pause_and_its_length_is_kept(tmp_path: Path) -> None:
    simulation = simulate("none")
    host, kinect, began = simulation.host, simulation.kinect, simulation.host.clock.now()
    host.at(began + 0.7, lambda: host.unplug(kinect))
    host.at(began + 1.3, lambda: host.plug(kinect))
    sensor, recorder = KinectSensor(simulation.load), DepthRecorder(tmp_path / "out")
    record(sensor, recorder, 3.0, lambda: host.clock.now() - began > 2.6)
    times = open_depth_recording(tmp_path / "out").times
    gaps = np.diff(times)
    assert np.all(gaps > 0.0) and 0.5 < gaps.max() < 1.5 and np.median(gaps) < 0.1
    assert len(times) == recorder.frames_written and times[-1] > 1.5
    assert in_use(host)["handles"] == 0 and sensor.counters().unplugs == 1


def frame(time_s: float, ticks: int) -> DepthFrame:
    return DepthFrame(np.zeros((1, 1), np.uint16), time_s, ticks % TICK_WRAP, None, TYPICAL, factory_intrinsics(TYPICAL))


@pytest.mark.parametrize("gone_s", [2.0, 40.0, 70.0, 200.0])
@pytest.mark.parametrize("restarts_at", [0, 3_000_000_000])
def test_a_clock_that_starts_anew_is_carried_on(gone_s: float, restarts_at: int) -> None:
    before = [frame(k * PERIOD_S, 4_000_000_000 + round(k * PERIOD_S * 60e6)) for k in range(300)]
    again = before[-1].time_s + gone_s
    after = [frame(again + k * PERIOD_S, restarts_at + round(k * PERIOD_S * 60e6)) for k in range(300)]
    steady = SteadyTicks()
    written = [steady.steadied(f) for f in before + after]
    assert [f.ticks for f in written[:300]] == [f.ticks for f in before], "an undisturbed clock is left alone"
    times, kept = seconds_from_ticks(np.array([f.ticks for f in written], np.uint32), np.array([f.time_s for f in written]))
    assert kept.all()
    np.testing.assert_allclose(times, [f.time_s for f in written], atol=0.01)


def test_a_clock_that_runs_a_little_fast_is_left_alone_for_hours() -> None:
    steady = SteadyTicks()
    for k in range(0, 400_000, 50):
        fast = frame(k * PERIOD_S, round(k * PERIOD_S * 60e6 * 1.0002))
        assert steady.steadied(fast).ticks == fast.ticks


def begun(folder: Path, *words: str) -> subprocess.Popen[str]:
    """A recording in a process of its own that has written its first second."""
    command = [sys.executable, str(RUN_GAME), "kinect", "record", str(folder), "--simulate", "room", *words]
    env = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=env)
    end = time.monotonic() + 30.0
    while not (folder / "depth-000000.npz").exists():
        assert process.poll() is None and time.monotonic() < end
        time.sleep(0.05)
    return process


@pytest.mark.skipif(sys.platform == "win32", reason="signals as on Unix")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_or_a_polite_kill_end_it_with_everything_kept(tmp_path: Path, number: signal.Signals) -> None:
    process = begun(tmp_path / "out")
    time.sleep(0.3)
    process.send_signal(number)
    out, err = process.communicate(timeout=30)
    assert process.returncode == 0 and "Traceback" not in err
    recording = open_depth_recording(tmp_path / "out")
    assert f"wrote {len(recording)} pictures" in out and len(recording) > 30, "more than the first archive"
    assert recording.notes == () and not list((tmp_path / "out").glob("*.part"))


@pytest.mark.skipif(sys.platform == "win32", reason="signals as on Unix")
def test_a_killed_recording_plays_up_to_its_last_second(tmp_path: Path) -> None:
    process = begun(tmp_path / "out")
    process.kill()
    process.communicate(timeout=30)
    assert len(list(open_depth_recording(tmp_path / "out"))) >= 30


def test_where_no_picture_comes_it_says_so_and_points_to_the_doctor(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["kinect", "record", str(tmp_path / "out"), "--seconds", "0.3", "--simulate", "no-power"]) == 1
    err = capsys.readouterr().err
    assert "12 V" in err and "no picture came" in err and "kinect doctor" in err


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("full",), "not empty"),
        (("full/file.txt",), "file.txt"),
        (("new", "--seconds", "0"), "between 0 and"),
        (("new", "--simulate", "gremlins"), "'gremlins'"),
    ],
)
def test_bad_input_is_one_sentence_and_writes_nothing(
    words: tuple[str, ...], named: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("full").mkdir()
    Path("full/file.txt").write_text("mine")
    assert main(["kinect", "record", *words]) == BAD_INPUT
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1 and named in said.err
    assert not Path("new").exists() and Path("full/file.txt").read_text() == "mine"
