"""Recordings sent once more over the wire: the same octets come out, at the recorded times."""

from typing import Any

import numpy as np
import pytest

from kinect.usb.capture_time import DEPTH_PERIOD_TICKS
from kinect.usb.packet import DEPTH_11
from kinect.usb.wire_replay import WireReplay, places_of
from tests.usb.simulated_sensor import PICTURES, SHARED

RAW_SESSION = SHARED / "openiss_person_raw11.npz"


def needs(path) -> None:
    """Skip, saying why, where the recordings are not beside the project."""
    if not path.exists():
        pytest.skip(f"{path.name} is not in ../shared/data/depth beside the project")


@pytest.mark.shared_data
def test_the_real_raw_session_comes_out_byte_identical_at_its_recorded_times() -> None:
    needs(RAW_SESSION)
    with np.load(RAW_SESSION) as session:
        raw, ticks = session["raw11"], session["ticks"]
    replay = WireReplay(list(raw), [int(t) for t in ticks])
    frames = []
    until = 0.0
    while len(frames) < len(raw) and until < replay.length_s + 1.0:
        until += 0.25
        arrived = replay.poll(until)
        assert all(frame.time_s <= until for frame in arrived)
        frames += arrived
    assert len(frames) == len(raw) == 210
    for frame, original in zip(frames, raw):
        np.testing.assert_array_equal(frame.disparity, original)
        assert frame.packets == DEPTH_11.packets
    recorded = (ticks.astype(np.int64) - int(ticks[0])) % (1 << 32) / 60e6
    np.testing.assert_allclose([frame.time_s for frame in frames], recorded, atol=1e-6)
    replay.close()


@pytest.mark.shared_data
@pytest.mark.parametrize("name", ["squat", "waving_left_arm", "kicking_left_leg"])
def test_a_depth_clip_comes_back_within_two_millimetres(name: str) -> None:
    path = SHARED / f"{name}.npz"
    needs(path)
    with np.load(path) as clip:
        depth_mm = clip["depth_mm"][:60].astype(float)
    seen = depth_mm > 0
    raw: Any = np.full(depth_mm.shape, 2047, np.uint16)
    raw[seen] = np.round(1088.93 - 345_490.0 / depth_mm[seen]).astype(np.uint16)
    replay = WireReplay([*raw])
    frames = replay.poll(replay.length_s)
    assert len(frames) == len(raw)
    with np.errstate(divide="ignore"):
        metres = 345_490.0 / (1088.93 - np.arange(2048))
    back = np.stack([metres[frame.disparity] for frame in frames])
    assert np.abs(back - depth_mm)[seen].max() <= 2.0
    assert all((frame.disparity == 2047)[~s].all() for frame, s in zip(frames, seen))
    replay.close()


def test_a_replay_follows_the_time_it_is_asked_for_and_begins_at_zero() -> None:
    replay = WireReplay(PICTURES, loop=True)
    assert [f.time_s for f in replay.poll(0.0)] == [0.0]
    assert [round(f.time_s, 4) for f in replay.poll(0.1)] == [0.0334, 0.0667]
    assert replay.poll(0.1) == []
    more = replay.poll(2.0)
    assert len(more) == 57
    for k, frame in enumerate(more, start=3):
        np.testing.assert_array_equal(frame.disparity, PICTURES[k % 4])
    replay.close()


def test_a_replay_ends_with_its_last_frame() -> None:
    replay = WireReplay(PICTURES)
    assert len(replay.poll(100.0)) == 4
    assert replay.poll(200.0) == []
    replay.close()


def test_two_replays_of_one_recording_are_equal() -> None:
    a, b = WireReplay(PICTURES), WireReplay(PICTURES)
    for one, other in zip(a.poll(1.0), b.poll(1.0)):
        assert one.time_s == other.time_s and one.ticks == other.ticks
        np.testing.assert_array_equal(one.disparity, other.disparity)
    a.close()
    b.close()


def test_frames_that_a_recording_lost_leave_gaps() -> None:
    period = DEPTH_PERIOD_TICKS
    start = (1 << 32) - period
    ticks = [(start + period * k) % (1 << 32) for k in (0, 1, 3, 4)]
    assert places_of(ticks) == [0, 1, 3, 4]
    replay = WireReplay(PICTURES, ticks)
    assert [round(f.time_s / 0.03336925) for f in replay.poll(1.0)] == [0, 1, 3, 4]
    replay.close()


def test_ticks_out_of_order_are_refused() -> None:
    with pytest.raises(ValueError, match="in order"):
        places_of([1000, 1000, 2_003_155])
