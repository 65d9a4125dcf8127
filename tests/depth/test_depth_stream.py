"""A depth recording as time passes: frame by frame, and once more through packets and the driver."""

from pathlib import Path

import numpy as np
import pytest

from kinect.depth.depth_stream import RecordedDepth, WiredDepth
from kinect.depth.recording import open_depth_recording
from tests.depth.depth_sessions import session, write_fakenect
from tests.depth.recorded_depth import PERSON_MM, PERSON_RAW, recorded


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_fakenect(tmp_path / "fake", session(10, typical=True))
    return tmp_path / "fake"


def test_frames_come_when_their_time_has_come_and_once_only(folder: Path) -> None:
    stream = RecordedDepth(open_depth_recording(folder))
    assert [frame.time_s for frame in stream.poll(0.0)] == [0.0]
    assert stream.poll(0.03) == []
    assert len(stream.poll(0.1)) == 2  # 33 and 67 ms; the next is due at 100.1 ms
    assert len(stream.poll(60.0)) == 7 and stream.poll(61.0) == []
    assert stream.status == "Recorded depth, ended after 0.3 s."


def test_a_recording_that_breaks_off_says_so_and_raises_nothing(folder: Path) -> None:
    fourth = sorted(folder.glob("d-*"))[3]
    fourth.write_bytes(b"P6")
    stream = RecordedDepth(open_depth_recording(folder))
    assert len(stream.poll(60.0)) == 3 and stream.poll(60.0) == []
    assert fourth.name in stream.status


def test_a_closed_stream_is_silent(folder: Path) -> None:
    for stream in (RecordedDepth(open_depth_recording(folder)), WiredDepth(open_depth_recording(folder))):
        stream.close()
        stream.close()
    assert RecordedDepth(open_depth_recording(folder)).poll(0.0) != []


def wired_and_read(path: Path, until_s: float) -> tuple[list, list]:
    wired = WiredDepth(open_depth_recording(path))
    got = [frame for k in range(int(60 * until_s) + 1) for frame in wired.poll(k / 60.0)]
    wired.close()
    return got, [frame for frame in open_depth_recording(path) if frame.time_s <= until_s]


def test_what_went_through_the_wire_is_what_was_recorded(folder: Path) -> None:
    got, read = wired_and_read(folder, 0.4)
    assert len(got) == len(read) == 10
    for one, other in zip(got, read, strict=True):
        assert np.array_equal(one.raw, other.raw) and one.time_s == pytest.approx(other.time_s, abs=1e-3)
    assert got[-1].accel is not None and abs(got[-1].accel[1] - 804) <= 1


@pytest.mark.shared_data
@pytest.mark.parametrize("path", [PERSON_RAW, PERSON_MM], ids=["raw", "millimetres"])
def test_real_recordings_pass_the_wire_unchanged(path: Path) -> None:
    got, read = wired_and_read(recorded(path), 1.0)
    assert len(got) == len(read) > 25
    for one, other in zip(got, read, strict=True):
        assert np.array_equal(one.raw, other.raw) and np.array_equal(one.metres(), other.metres(), equal_nan=True)
