"""Depth beside the character: points and picture, shown where the input sees depth and wanted."""

import numpy as np
import pytest

from game.characters.body_plan import load_body_plan
from game.drawables import DepthPoints
from game.inputs.kinect_replay import DepthInput
from game.inputs.open_input import open_input
from game.scenes.depth_layer import depth_picture, depth_points
from game.scenes.mirror import Mirror
from game.tunables import Settings
from kinect.depth.depth_stream import RecordedDepth
from kinect.depth.disparity import NO_DATA
from kinect.depth.recording_format import DepthRecording
from tests.depth.depth_sessions import session

HERE = np.zeros(3)


def recorded_room() -> DepthInput:
    frames = session(90)
    times = np.array([frame.time_s for frame in frames])
    return DepthInput(RecordedDepth(DepthRecording("a room", times, lambda: iter(frames))))


@pytest.fixture
def source() -> DepthInput:
    source = recorded_room()
    source.poll(0.1)
    return source


def test_the_points_are_the_frame_s_own_codes_with_its_own_table(source: DepthInput) -> None:
    (layer,) = depth_points(source, Settings(), False, HERE)
    (cloud,) = layer.drawables
    frame = source.depth()
    assert isinstance(cloud, DepthPoints) and frame is not None
    assert layer.name == "points" and cloud.codes is frame.raw
    assert np.array_equal(cloud.metres[frame.raw], frame.metres(), equal_nan=True)
    assert (cloud.focal_px, cloud.centre_px) == (581.0, (318.5, 243.25))


def test_mirrored_points_lie_on_the_other_side_and_beside_the_character(source: DepthInput) -> None:
    settings = Settings()
    clouds = [depth_points(source, settings, mirrored, HERE)[0].drawables[0] for mirrored in (False, True)]
    settings.set("intake.mirror", False)
    clouds.append(depth_points(source, settings, True, HERE)[0].drawables[0])
    left = np.array([0.5, 0.0, 2.5])  # to the sensor's left is the world's right
    ys = [float((cloud.turn @ left + cloud.shift)[1]) for cloud in clouds if isinstance(cloud, DepthPoints)]
    assert ys == pytest.approx([0.4, 1.4, 0.4])


def test_switching_a_layer_off_takes_it_away(source: DepthInput) -> None:
    settings = Settings()
    assert depth_points(source, settings, False, HERE) != () and depth_picture(source, settings) is not None
    settings.set("layer.points", False)
    settings.set("layer.depth_picture", False)
    assert depth_points(source, settings, False, HERE) == () and depth_picture(source, settings) is None


def test_an_input_without_depth_shows_none() -> None:
    puppet = open_input("puppet")
    assert depth_points(puppet, Settings(), False, HERE) == () and depth_picture(puppet, Settings()) is None


def test_in_the_picture_near_is_warm_far_is_cold_and_nothing_is_dark(source: DepthInput) -> None:
    picture = depth_picture(source, Settings())
    frame = source.depth()
    assert picture is not None and frame is not None and picture.shape == (240, 320, 4) and picture.dtype == np.uint8
    raw = frame.raw[::2, ::2]
    warmth = picture[..., 0].astype(int) - picture[..., 2]
    seen = raw != NO_DATA
    assert warmth[seen & (raw < 620)].min() > 40 and warmth[seen & (raw > 880)].max() < 0
    assert picture[~seen][:, :3].max() < 30


def test_in_a_scene_the_character_stands_and_the_depth_is_shown() -> None:
    settings = Settings()
    scene = Mirror(load_body_plan("original"), recorded_room, settings, 0, "kinect-replay:a room")
    scene.enter()
    for _ in range(150):
        scene.fixed_update()
    shown = {layer.name for layer in scene.drawables(1.0)}
    assert "points" in shown and scene.depth_picture is not None
    readouts = scene.readouts()
    assert readouts["fell_at_s"] == -1.0 and "No body tracking yet" in str(readouts["input"])
    scene.leave()
