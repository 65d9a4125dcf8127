"""The floor over time: steady, remembered while hidden, forgotten when the sensor is moved."""

from dataclasses import replace

import numpy as np
import pytest

from kinect.depth.depth_frame import DepthFrame
from kinect.depth.disparity import NO_DATA
from kinect.depth.floor_guess import guessed_floor
from kinect.depth.floor_watch import FloorWatch
from kinect.depth.recording import open_depth_recording
from tests.depth.ray_cast_room import FURNITURE, Stand, depth_frame, person
from tests.depth.recorded_depth import PERSON_MM, PERSON_RAW, recorded

STAND = Stand(0.9, -8.0)
SEEN = depth_frame(STAND, FURNITURE + person(0.2, 2.4), accel_error_deg=1.0)


def at(frame: DepthFrame, time_s: float) -> DepthFrame:
    return replace(frame, time_s=time_s)


def nothing(time_s: float) -> DepthFrame:
    return replace(SEEN, raw=np.full((480, 640), NO_DATA, dtype=np.uint16), time_s=time_s)


def test_before_the_first_frame_there_is_no_floor_and_it_says_so() -> None:
    watch = FloorWatch()
    assert watch.floor is None and "no floor" in watch.why


def test_a_floor_once_seen_stays_while_somebody_stands_before_the_camera() -> None:
    watch = FloorWatch()
    first = watch.see(at(SEEN, 0.0))
    assert first is not None and first.d == pytest.approx(0.9, abs=0.01)
    for k in range(1, 300):
        assert watch.see(nothing(k / 30.0)) is not None
    assert tuple(watch.floor or ()) == pytest.approx(tuple(first), abs=0.01) and "m below the sensor" in watch.why


def test_it_looks_twice_a_second_only() -> None:
    watch = FloorWatch()
    assert watch.see(nothing(0.0)) is None
    assert watch.see(at(SEEN, 0.4)) is None
    assert watch.see(at(SEEN, 0.6)) is not None


def test_pieces_seen_a_moment_ago_count_with_those_seen_now() -> None:
    left, right = (SEEN.raw.copy() for _ in range(2))
    left[:, 230:] = NO_DATA
    right[:, :330] = NO_DATA
    watch = FloorWatch()
    watch.see(replace(SEEN, raw=left, time_s=0.0))
    floor = watch.see(replace(SEEN, raw=right, time_s=0.6))
    assert floor is not None
    lean = np.degrees(np.arccos(min(1.0, float(np.array(floor[:3]) @ STAND.up()))))
    assert lean < 0.5 and abs(floor.d - 0.9) < 0.01


def test_a_moved_sensor_starts_anew() -> None:
    watch = FloorWatch()
    watch.see(at(SEEN, 0.0))
    tipped = depth_frame(Stand(0.9, 25.0), FURNITURE)
    assert watch.see(at(tipped, 1.0)) is None
    lowered = Stand(0.7, -12.0)
    floor = watch.see(at(depth_frame(lowered, FURNITURE), 2.0))
    assert floor is not None and floor.d == pytest.approx(0.7, abs=0.01)


@pytest.mark.parametrize(("stand", "height_m"), [(Stand(1.1, 22.0), 0.9), (Stand(1.5, 0.0), 1.5)], ids=["sees no ground", "sees it"])
def test_where_no_floor_shows_the_lowest_thing_seen_is_drawn_on_the_ground(stand: Stand, height_m: float) -> None:
    guess = guessed_floor(depth_frame(stand, FURNITURE + person(0.2, 2.4)))
    assert guess is not None and guess.d == pytest.approx(height_m, abs=0.05)
    assert np.array(guess[:3]) @ stand.up() > 0.999
    assert guessed_floor(nothing(0.0)) is None


@pytest.mark.shared_data
def test_the_real_session_never_shows_its_floor() -> None:
    watch = FloorWatch()
    for frame in open_depth_recording(recorded(PERSON_RAW)):
        assert watch.see(frame) is None
    assert watch.why.startswith("no floor in view")


@pytest.mark.shared_data
def test_scraps_of_floor_under_a_cut_out_person_are_no_floor_but_show_where_to_draw_the_feet() -> None:
    path = recorded(PERSON_MM)
    joints = np.load(path)["sdk_joints"].astype(float)
    watch = FloorWatch()
    soles = []
    for frame, seen in zip(open_depth_recording(path), joints, strict=True):
        assert watch.see(frame) is None
        hint = watch.hint
        if hint is not None:
            soles.append(seen[[15, 19]] @ np.array(hint[:3]) + hint.d)
    assert np.nanmedian(np.array(soles)) == pytest.approx(0.03, abs=0.04)  # metres of the SDK's FOOT joints above the plane
