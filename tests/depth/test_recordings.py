"""Depth recordings: written, killed, read back, in our format and in others'."""

import os
import signal
import subprocess
import sys
import time
import zlib
from pathlib import Path

import numpy as np
import pytest

from kinect.depth.disparity import metres_from_raw, raw_from_metres
from kinect.depth.disparity_grid import disparity_grid
from kinect.depth.recorder import DepthRecorder
from kinect.depth.recording import open_depth_recording
from kinect.depth.recording_format import seconds_from_ticks
from kinect.device_calibration import TYPICAL, DeviceCalibration
from tests.depth.depth_sessions import STEP_TICKS, same, session, write_fakenect
from tests.depth.recorded_depth import PERSON_MM, PERSON_RAW, recorded

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("accel", [True, False])
def test_what_is_recorded_is_played_back_bit_for_bit(tmp_path: Path, accel: bool) -> None:
    taken = session(11, accel=accel)
    with DepthRecorder(tmp_path / "out", chunk_frames=4) as recorder:
        for frame in taken:
            recorder.write(frame)
    assert recorder.frames_written == 11
    recording = open_depth_recording(tmp_path / "out")
    assert len(recording) == 11 and recording.length_s == pytest.approx(taken[-1].time_s) and recording.notes == ()
    assert all(same(one, other) for one, other in zip(taken, recording, strict=True))
    assert sum(1 for _ in recording) == 11  # and a second time


def test_each_second_on_disk_is_an_archive_of_its_own(tmp_path: Path) -> None:
    with DepthRecorder(tmp_path / "out", chunk_frames=3) as recorder:
        for frame in session(7):
            recorder.write(frame)
    assert len(list((tmp_path / "out").iterdir())) == 3
    chunk = np.load(tmp_path / "out" / "depth-000001.npz")
    assert chunk["raw11"].shape == (3, 480, 640)
    assert len(list(open_depth_recording(tmp_path / "out" / "depth-000001.npz"))) == 3


def test_a_killed_recording_keeps_all_but_its_last_second(tmp_path: Path) -> None:
    program = f"""
import sys, time
sys.path.insert(0, {str(ROOT)!r})
from kinect.depth.recorder import DepthRecorder
from tests.depth.depth_sessions import session
recorder = DepthRecorder({str(tmp_path / "out")!r}, chunk_frames=5)
for frame in session(23):
    recorder.write(frame)
while recorder.frames_written < 20:
    time.sleep(0.01)
print("written", flush=True)
time.sleep(60)
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None and process.stdout.readline() == b"written\n"
        os.kill(process.pid, signal.SIGKILL)
    recording = open_depth_recording(tmp_path / "out")
    assert len(recording) == 20
    assert all(same(one, other) for one, other in zip(session(23), recording, strict=False))


def test_a_chunk_that_was_being_written_when_the_end_came_is_left_out_and_told(tmp_path: Path) -> None:
    with DepthRecorder(tmp_path / "out", chunk_frames=3) as recorder:
        for frame in session(6):
            recorder.write(frame)
    last = tmp_path / "out" / "depth-000001.npz"
    last.rename(last.with_suffix(".part"))
    recording = open_depth_recording(tmp_path / "out")
    assert len(recording) == 3 and "cut off" in recording.notes[0]


def test_a_fakenect_session_gives_its_depth_frames_each_with_the_last_accelerometer_reading(tmp_path: Path) -> None:
    taken = session(4, typical=True)
    write_fakenect(tmp_path / "fake", taken)
    recording = open_depth_recording(tmp_path / "fake")
    assert len(recording) == 4
    assert all(same(one, other) for one, other in zip(taken, recording, strict=True))


def test_a_fakenect_recorder_killed_in_a_frame_costs_that_frame_only(tmp_path: Path) -> None:
    write_fakenect(tmp_path / "fake", session(3, typical=True))
    index = tmp_path / "fake" / "INDEX.txt"
    last = tmp_path / "fake" / [line for line in index.read_text().split() if line.startswith("d-")][-1]
    last.write_bytes(last.read_bytes()[:50_000])
    index.write_text(index.read_text()[:-7])
    recording = open_depth_recording(tmp_path / "fake")
    assert len(list(recording)) == 2


def test_the_clock_runs_on_when_the_ticks_wrap_and_over_a_dropped_frame() -> None:
    ticks = (2**32 - 3 * STEP_TICKS + STEP_TICKS * np.array([0, 1, 2, 4, 5])) % 2**32
    seconds, advancing = seconds_from_ticks(ticks.astype(np.uint32))
    assert seconds == pytest.approx(np.array([0, 1, 2, 4, 5]) * STEP_TICKS / 60e6) and np.all(advancing)


def test_a_gap_longer_than_the_clock_is_measured_by_the_host() -> None:
    ticks = np.array([1000, (1000 + round(200.0 * 60e6)) % 2**32, (1000 + round(200.1 * 60e6)) % 2**32], dtype=np.uint32)
    seconds, _ = seconds_from_ticks(ticks, np.array([0.0, 200.02, 200.11]))
    assert seconds == pytest.approx([0.0, 200.0, 200.1])


def test_a_frame_told_twice_or_out_of_turn_does_not_advance() -> None:
    ticks = np.array([0, 5, 5, 3, 6], dtype=np.uint32) * STEP_TICKS
    for host in (None, np.array([0.0, 0.17, 0.17, 0.1, 0.2])):
        assert list(seconds_from_ticks(ticks, host)[1]) == [True, True, False, False, True]


@pytest.mark.parametrize(
    "device", [TYPICAL, DeviceCalibration(1.2, 0.001042, 0.075, 199.88), DeviceCalibration(1.17, 0.00102, 0.0745, 201.3)]
)
def test_the_grid_of_a_device_is_found_in_its_millimetres(device: DeviceCalibration) -> None:
    raw = np.arange(880, 960, dtype=np.uint16)
    millimetres = np.round(metres_from_raw(raw, device) * 1000.0).astype(np.uint16)
    grid = disparity_grid(np.concatenate((millimetres, [0])))
    back = metres_from_raw(grid.codes[millimetres], grid.calibration) * 1000.0
    assert np.abs(back - millimetres).max() < 2.0 and grid.worst_mm < 2.0
    assert len(np.unique(grid.codes[millimetres])) == 80  # no two codes fall together
    assert grid.codes[0] == raw_from_metres(0.0, TYPICAL)


@pytest.mark.shared_data
def test_the_real_raw_session_is_read_frame_for_frame() -> None:
    archive = np.load(recorded(PERSON_RAW))
    recording = open_depth_recording(PERSON_RAW)
    for frame, raw, ticks in zip(recording, archive["raw11"], archive["ticks"], strict=True):
        assert np.array_equal(frame.raw, raw) and frame.ticks == ticks
    first = next(iter(recording))
    up = first.up()
    assert first.accel is not None and up is not None and np.degrees(np.arctan2(up[2], up[1])) == pytest.approx(13.0, abs=1.0)
    assert np.diff(recording.times).min() == pytest.approx(0.033369, abs=1e-5)


@pytest.mark.shared_data
@pytest.mark.parametrize("name", ["squat", "waving_left_arm", "kicking_left_leg"])
def test_real_millimetre_clips_come_back_within_two_millimetres(name: str) -> None:
    path = recorded(PERSON_MM.with_stem(name))
    archive = np.load(path)["depth_mm"]
    for frame, millimetres in zip(open_depth_recording(path), archive[:20], strict=False):
        back = np.nan_to_num(frame.metres()) * 1000.0
        assert np.abs(back - millimetres).max() <= 2.0


def test_recording_costs_less_than_half_of_packing_the_same_pictures_harder(tmp_path: Path) -> None:
    """Both in the same run, so that the machine's own speed does not count."""
    frames = session(30)
    pictures = np.stack([frame.raw for frame in frames]).tobytes()
    times = [time.process_time()]
    zlib.compress(pictures, 6)
    times.append(time.process_time())
    with DepthRecorder(tmp_path / "out") as recorder:
        for frame in frames:
            recorder.write(frame)
    times.append(time.process_time())
    packing, recording = np.diff(times)
    assert recording < 0.5 * packing
