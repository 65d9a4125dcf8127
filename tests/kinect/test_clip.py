"""Recordings keep what was recorded, and play by the rules for time, confidence and floor."""

import numpy as np
import pytest

from kinect.body import Floor, Joint
from kinect.clip import Clip, ClipSource, checked_clip, read_clip, write_clip
from kinect.clip_floor import floor_from_resting_ankles
from tests.kinect.recordings import SHARED, moving_clip, raw_fields, standing_joints

FLOOR = Floor(0.0, 0.8, 0.6, 0.9)


@pytest.mark.parametrize("name", ["walk.npz", "walk.csv", "walk.txt"])
def test_a_written_recording_reads_back_the_same(tmp_path, name):
    clip = moving_clip(floor=FLOOR)
    clip.positions[7, Joint.HAND_LEFT] = np.nan
    clip.confidence[7, Joint.HAND_LEFT] = 0.0
    write_clip(tmp_path / name, clip)
    back = read_clip(tmp_path / name)
    np.testing.assert_allclose(back.positions, clip.positions, atol=6e-6, equal_nan=True)
    np.testing.assert_array_equal(back.confidence, clip.confidence)
    np.testing.assert_allclose(back.t, clip.t, atol=1e-6)
    assert back.floor == pytest.approx(FLOOR)
    assert back.floor_est is None
    assert back.meta["motion"] == "sway" and back.meta["license"] == "CC0"


def test_a_frame_whose_time_does_not_advance_is_dropped_and_counted():
    fields = raw_fields(moving_clip())
    t = fields["t"].copy()
    t[10] = t[9]
    t[20] = t[5]
    clip = checked_clip("x", fields["positions"], None, t)
    assert clip.dropped_frames == 2
    assert len(clip.t) == len(t) - 2
    assert np.all(np.diff(clip.t) > 0.0)
    np.testing.assert_array_equal(clip.positions[10], fields["positions"][11])
    assert "2 frames without a new time" in ClipSource(clip).status


def test_time_starts_at_zero_whatever_the_recording_says():
    fields = raw_fields(moving_clip())
    clip = checked_clip("x", fields["positions"], None, fields["t"] + 1234.5)
    assert clip.t[0] == 0.0
    assert clip.length_s == pytest.approx(fields["t"][-1])


def test_unknown_confidence_is_one_and_a_joint_without_position_has_none():
    fields = raw_fields(moving_clip())
    fields["positions"][4, Joint.HEAD, 1] = np.inf
    fields["confidence"][5] = np.nan
    clip = checked_clip("x", fields["positions"], fields["confidence"], fields["t"])
    assert clip.confidence[4, Joint.HEAD] == 0.0 and np.all(np.isnan(clip.positions[4, Joint.HEAD]))
    assert np.all(clip.confidence[5] == 1.0)
    assert np.all(checked_clip("x", fields["positions"], None, fields["t"]).confidence[0] == 1.0)


def test_csv_without_time_runs_at_thirty_frames_a_second_and_understands_the_sdks_states(tmp_path):
    path = tmp_path / "sdk.csv"
    rows = []
    for state in (2, 2, 1, 0, 2):
        rows.append(" ".join(f"{x:.4f} {y:.4f} {z:.4f} {state}" for x, y, z in standing_joints()))
    path.write_text("\n".join(rows))
    clip = read_clip(path)
    np.testing.assert_allclose(np.diff(clip.t), 1.0 / 30.0)
    np.testing.assert_array_equal(clip.confidence[:, 0], [1.0, 1.0, 0.5, 0.0, 1.0])


def test_npz_without_time_runs_at_its_frame_rate(tmp_path):
    np.savez(tmp_path / "rate.npz", positions=moving_clip().positions, fps=24.0)
    np.testing.assert_allclose(np.diff(read_clip(tmp_path / "rate.npz").t), 1.0 / 24.0)


def test_the_floor_is_the_recorded_plane_else_the_makers_estimate_else_under_the_resting_ankles():
    clip = moving_clip(floor=FLOOR)
    recorded = Clip(clip.positions, clip.confidence, clip.t, FLOOR, Floor(0.0, 1.0, 0.0, 1.1))
    estimated = Clip(clip.positions, clip.confidence, clip.t, None, Floor(0.0, 1.0, 0.0, 1.1))
    bare = Clip(clip.positions, clip.confidence, clip.t)
    assert ClipSource(recorded).poll(0.0)[0].floor == FLOOR
    assert ClipSource(estimated).poll(0.0)[0].floor == Floor(0.0, 1.0, 0.0, 1.1)
    found = ClipSource(bare).poll(0.0)[0].floor
    assert found is not None and found == pytest.approx((0.0, 1.0, 0.0, 0.9), abs=0.002)


def test_a_floor_that_points_down_or_is_not_unit_is_the_same_plane():
    clip = checked_clip("x", moving_clip().positions, None, moving_clip().t, np.array([0.0, -4.0, -3.0, -4.5]))
    assert clip.floor == pytest.approx((0.0, 0.8, 0.6, 0.9))


def test_playing_hands_out_every_frame_once_in_order_by_the_clock_it_is_asked_with():
    clip = moving_clip()
    source = ClipSource(clip)
    seen = [frame for until in (0.0, 0.0, 0.5, 0.51, 9.0) for frame in source.poll(until)]
    assert [frame.time_s for frame in seen] == list(clip.t)
    assert len(ClipSource(clip).poll(0.0)) == 1
    assert source.length_s == clip.length_s
    assert source.poll(99.0) == []
    assert "ended" in source.status


def test_a_looping_recording_goes_on_with_growing_time():
    clip = moving_clip()
    source = ClipSource(clip, loop=True)
    frames = source.poll(3.5 * clip.length_s)
    times = np.array([frame.time_s for frame in frames])
    np.testing.assert_allclose(np.diff(times), 1.0 / 30.0)
    assert len(times) > 3 * len(clip.t)
    np.testing.assert_array_equal(frames[len(clip.t)].positions, clip.positions[0])
    assert source.length_s is None


def test_changing_a_frame_does_not_change_the_recording():
    clip = moving_clip()
    ClipSource(clip).poll(0.0)[0].positions[:] = 0.0
    assert clip.positions[0, 0, 2] == pytest.approx(2.5)


@pytest.mark.shared_data
@pytest.mark.skipif(not SHARED.is_dir(), reason="the shared recordings are not beside this checkout")
class TestSharedRecordings:
    @pytest.mark.parametrize("path", sorted(SHARED.glob("*.npz")) if SHARED.is_dir() else [], ids=lambda path: path.stem)
    def test_every_one_plays_with_a_floor_under_the_feet(self, path):
        source = ClipSource(path)
        frames = source.poll(1e6)
        assert len(frames) == len(source.clip.t) > 50
        assert source.dropped_frames == (1 if "Touchyourtoes" in path.name else 0)
        floor = np.array(frames[0].floor)
        lower = np.nanmin(source.clip.positions[:, [Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]] @ floor[:3] + floor[3], axis=1)
        assert 0.03 < np.median(lower) < 0.12, "resting ankles are a hand's breadth above the floor"

    def test_resting_ankles_find_a_recorded_floor_within_four_centimetres(self):
        for path in sorted(SHARED.glob("*.npz")):
            clip = read_clip(path)
            if clip.floor is not None:
                found = floor_from_resting_ankles(clip)
                assert found is not None and abs(found.d - clip.floor.d) < 0.04, path.stem
