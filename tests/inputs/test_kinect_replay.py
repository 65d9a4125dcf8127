"""A depth recording as an input: depth and floor are there, bodies are not, and a stand-in stands."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from game.inputs.kinect_replay import DepthInput, replay, replay_through_driver
from game.inputs.open_input import InputError, open_input
from game.inputs.puppet import puppet_of
from game.intake.world_frame import Levelling
from game.scenes.depth_layer import room_placement
from kinect.body import BodyFrame, Floor, Joint
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.depth_seen import depth_seen_by
from kinect.depth.depth_stream import RecordedDepth
from kinect.depth.point_cloud import point_cloud
from kinect.depth.recording_format import DepthRecording
from tests.depth.depth_sessions import session, write_fakenect
from tests.depth.ray_cast_room import FURNITURE, Stand, depth_frame, person

STAND = Stand(1.0, -4.0, 3.0)
SEEN = depth_frame(STAND, FURNITURE + person(0.2, 2.4), accel_error_deg=1.0)


def input_of(*frames: DepthFrame) -> DepthInput:
    times = np.array([frame.time_s for frame in frames])
    return DepthInput(RecordedDepth(DepthRecording("a room", times, lambda: iter(frames))))


def test_the_stand_in_stands_still_on_both_feet_while_the_recording_lasts() -> None:
    source = input_of(SEEN, *(replace(SEEN, time_s=t) for t in (1.0, 2.0)))
    frames = source.poll(10.0)
    assert source.length_s == 2.0 and len(frames) == 61 and frames[0].time_s == 0.0
    positions = np.array([frame.positions for frame in frames])
    assert np.ptp(positions[:, [Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]], axis=0).max() < 0.01
    assert np.ptp(positions[:, Joint.HEAD], axis=0).max() < 0.1


def test_no_key_reaches_the_stand_in() -> None:
    assert puppet_of(input_of(SEEN)) is None


def test_the_picture_is_that_of_the_time_polled_for(tmp_path: Path) -> None:
    taken = session(6, typical=True)
    write_fakenect(tmp_path / "fake", taken)
    source = replay(tmp_path / "fake")
    assert (first := source.depth()) is not None and np.array_equal(first.raw, taken[0].raw)
    source.poll(0.1)
    assert (later := source.depth()) is not None and np.array_equal(later.raw, taken[2].raw)
    assert source.depth() is later


def test_through_the_driver_the_same_pictures_come(tmp_path: Path) -> None:
    taken = session(6, typical=True)
    write_fakenect(tmp_path / "fake", taken)
    source = replay_through_driver(tmp_path / "fake")
    source.poll(0.1)
    assert (frame := source.depth()) is not None and np.array_equal(frame.raw, taken[2].raw)
    source.close()


def test_the_status_tells_why_there_is_no_body_and_whether_there_is_a_floor() -> None:
    source = input_of(SEEN)
    assert "No body tracking yet" in source.status and "loor" not in source.status
    source.poll(0.0)
    source.depth()
    assert source.floor is not None and "Floor 1.0" in source.status
    upwards = input_of(depth_frame(Stand(1.1, 22.0), FURNITURE))
    upwards.poll(0.0)
    upwards.depth()
    assert upwards.floor is None and upwards.drawn_floor is not None and "No floor seen" in upwards.status
    assert upwards.floor_why.startswith("no floor in view")


def test_whoever_asks_for_depth_finds_it_inside_a_wrapped_source() -> None:
    class Wrapped:
        source = input_of(SEEN)

    assert depth_seen_by(Wrapped()) is Wrapped.source
    assert depth_seen_by(open_input("puppet")) is None and depth_seen_by(None) is None


def test_a_body_measured_over_the_found_floor_stands_upright_on_the_room_s() -> None:
    """The plane goes into a BodyFrame, and the intake's levelling takes out pitch, roll and height of the sensor."""
    source = input_of(SEEN, replace(SEEN, time_s=1.0))
    first = source.poll(0.0)[-1]  # over the stand-in's own level floor
    source.depth()
    floor = source.floor
    assert floor is not None
    assert source.poll(0.5)[-1].floor == floor, "every frame carries the plane once it is found"
    standing, own = first.positions, first.floor
    assert own is not None
    in_room = standing + np.array([0.0, own.d, 0.0])
    tilted = (in_room - np.array([0.0, STAND.height_m, 0.0])) @ STAND.to_room()
    world = Levelling().apply(BodyFrame(0.0, tilted, np.ones(20), floor=floor))
    expected = Levelling().apply(BodyFrame(0.0, standing, np.ones(20), floor=own))
    # what is left is the turn about the vertical, which no floor tells, and less than a centimetre of height
    assert np.abs(world[:, 2] - expected[:, 2]).max() < 0.03
    upright = world[Joint.HEAD] - 0.5 * (world[Joint.ANKLE_LEFT] + world[Joint.ANKLE_RIGHT])
    straight = expected[Joint.HEAD] - 0.5 * (expected[Joint.ANKLE_LEFT] + expected[Joint.ANKLE_RIGHT])
    assert np.degrees(np.arccos(upright[2] / np.linalg.norm(upright))) == pytest.approx(
        np.degrees(np.arccos(straight[2] / np.linalg.norm(straight))), abs=0.5
    )


@pytest.mark.parametrize("mirrored", [False, True])
def test_the_player_s_points_stand_on_the_room_s_floor(mirrored: bool) -> None:
    source = input_of(SEEN)
    source.poll(0.0)
    frame = source.depth()
    floor = source.drawn_floor
    assert frame is not None and floor is not None
    turn, shift = room_placement(floor, mirrored)
    world = point_cloud(frame.metres(), frame.intrinsics, 2) @ turn.T + shift
    side = -0.2 if not mirrored else 0.2  # the person stands 0.2 m to the sensor's left, the world's right
    about = (np.abs(world[:, 1] - side) < 0.25) & (np.abs(world[:, 0] - 0.1) < 0.3)
    body = world[about & (world[:, 2] > 0.15)]
    assert np.quantile(body[:, 2], 0.999) == pytest.approx(1.74, abs=0.05)
    ground = world[(world[:, 2] < 0.1) & (np.abs(world[:, 1]) < 1.0)]
    assert abs(np.median(ground[:, 2])) < 0.02 and np.quantile(world[:, 2], 0.002) > -0.03


def test_turned_by_a_floor_the_sensor_lies_over_the_point_in_front() -> None:
    turn, shift = room_placement(Floor(0.0, 1.0, 0.0, 0.9), False)
    assert np.allclose(shift, (2.5, 0.0, 0.9)) and np.allclose(turn @ (0.0, 0.0, 2.5) + shift, (0.0, 0.0, 0.9))


def test_a_recording_that_is_none_is_refused_at_the_door(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"nowhere\.npz: there is no such file"):
        open_input(f"kinect-replay:{tmp_path / 'nowhere.npz'}")
