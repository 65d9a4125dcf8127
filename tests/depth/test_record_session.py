"""Recording a session: what a stream gave lies on disk afterwards, whole."""

from pathlib import Path

import numpy as np
import pytest

from kinect.depth.depth_stream import RecordedDepth
from kinect.depth.record_session import record_session
from kinect.depth.recording import DepthRecordingError, open_depth_recording
from kinect.depth.recording_format import DepthRecording
from tests.depth.depth_sessions import same, session

TAKEN = session(40)


class PassingTime:
    """A clock that passes only while somebody sleeps."""

    def __init__(self) -> None:
        self.s = 5.0

    def now(self) -> float:
        return self.s

    def sleep(self, seconds: float) -> None:
        self.s += seconds


def stream() -> RecordedDepth:
    return RecordedDepth(DepthRecording("a session", np.array([frame.time_s for frame in TAKEN]), lambda: iter(TAKEN)))


def test_a_whole_session_is_recorded_and_told_twice_a_second(tmp_path: Path) -> None:
    clock = PassingTime()
    told = list(record_session(stream(), tmp_path / "out", None, clock.now, clock.sleep))
    assert [round(t.seconds, 1) for t in told] == [0.5, 1.0, 1.3] and told[-1].frames == 40
    recording = open_depth_recording(tmp_path / "out")
    assert len(recording) == 40 and all(same(one, other) for one, other in zip(TAKEN, recording, strict=True))


def test_time_is_up_after_the_seconds_asked_for(tmp_path: Path) -> None:
    clock = PassingTime()
    last = list(record_session(stream(), tmp_path / "out", 0.7, clock.now, clock.sleep))[-1]
    assert last.frames == len(open_depth_recording(tmp_path / "out")) == 21


def test_who_stops_asking_keeps_what_was_taken(tmp_path: Path) -> None:
    clock = PassingTime()
    going = record_session(stream(), tmp_path / "out", None, clock.now, clock.sleep)
    taken = next(going).frames
    going.close()
    assert len(open_depth_recording(tmp_path / "out")) == taken > 10


def test_a_folder_in_use_is_refused(tmp_path: Path) -> None:
    (tmp_path / "old.npz").write_bytes(b"")
    with pytest.raises(DepthRecordingError, match="not empty"):
        next(record_session(stream(), tmp_path))
