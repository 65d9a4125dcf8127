"""Scene `mirror`: the character does what the input does, upright and to its end, whatever clock paces the picture."""

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from game.app import App, Options
from game.characters.skeleton import PARTS
from game.commands.casting import Casting
from game.pacing import WallPace
from game.render.gl_window import NoPicture
from game.scenes.fighter import NoBodyError
from game.scenes.mirror import Mirror
from game.tunables import Settings
from game.undrawn import run_undrawn
from kinect.body import Joint
from kinect.clip import checked_clip, write_clip
from tests.kinect.recordings import moving_clip
from tests.overlay.conftest import Backdrop
from tests.scenes.staged import make_scene, run_s


@pytest.fixture
def raised_hand(tmp_path: Path) -> str:
    """A recording of somebody who slowly stretches the left arm out to the side and holds it there."""
    still = moving_clip(60)
    positions = np.repeat(still.positions[:1], 60, axis=0)
    share = np.clip((np.arange(60) - 15) / 20.0, 0.0, 1.0)[:, None]
    shoulder = positions[:, Joint.SHOULDER_LEFT]
    for joint, reach in ((Joint.ELBOW_LEFT, 0.29), (Joint.WRIST_LEFT, 0.55), (Joint.HAND_LEFT, 0.63)):
        hanging, outward = positions[:, joint] - shoulder, np.array([-reach, 0.0, 0.0])
        way = (1.0 - share) * hanging + share * outward
        positions[:, joint] = shoulder + way / np.linalg.norm(way, axis=1, keepdims=True) * np.linalg.norm(hanging, axis=1, keepdims=True)
    path = tmp_path / "arm.npz"
    write_clip(path, checked_clip(path.name, positions, np.ones((60, 20)), still.t, still.floor, None, {}))
    return f"clip:{path}"


def hands_beside_the_trunk(spec: str, mirrored: bool) -> tuple[float, float]:
    """How far the left and the right hand are beside the trunk at the end of the recording, m, outward."""
    scene = make_scene("mirror", spec, Settings({"intake.mirror": mirrored}))
    assert isinstance(scene, Mirror)
    run_undrawn(scene, None)
    body = scene.simulation.world.characters[0]
    left, right, trunk = (body.box_centre[PARTS.index(name)] for name in ("hand_left", "hand_right", "trunk"))
    assert scene.finished and scene.report()["fell_at_s"] is None
    return float(left[1] - trunk[1]), float(trunk[1] - right[1])


def test_the_character_lifts_the_hand_on_your_side_of_the_glass_and_your_own_hand_without_it(raised_hand: str) -> None:
    left, right = hands_beside_the_trunk(raised_hand, mirrored=True)
    assert right > left + 0.25, "you lift the left hand, and it lifts the one across from it"
    left, right = hands_beside_the_trunk(raised_hand, mirrored=False)
    assert left > right + 0.25


def test_the_hang_is_short_and_leaves_the_character_where_it_stood() -> None:
    scene = make_scene("mirror", "performer:standing")
    assert isinstance(scene, Mirror)
    scene.enter()
    hang_s = -scene.time_s
    assert 0.0 < hang_s < 1.5
    body = scene.simulation.world.characters[0]
    height = body.joint[0, 2]
    run_s(scene, 0.5)
    assert abs(body.joint[0, 2] - height) < 0.08
    assert scene.readouts()["upright_s"] == pytest.approx(0.5)
    scene.leave()


def test_a_fall_is_told_and_the_run_goes_on() -> None:
    weak = Settings({"pd.kp_hat": 100.0, "pd.gravity_feedforward": False, "balance.strategy": "none"})
    scene = make_scene("mirror", "performer:bowing", weak)
    scene.enter()
    run_s(scene, 2.0)
    fell = scene.readouts()["fell_at_s"]
    assert isinstance(fell, float) and 0.0 < fell < 2.0
    assert scene.messages()[-1] == f"It fell after {fell:.1f} s. R starts again."
    scene.enter()
    assert scene.readouts()["fell_at_s"] == -1.0 and "fell" not in " ".join(scene.messages())
    scene.leave()


def test_an_input_in_which_nobody_is_cannot_begin(tmp_path: Path) -> None:
    clip = moving_clip()
    write_clip(tmp_path / "empty.npz", checked_clip("empty", clip.positions, np.zeros((40, 20)), clip.t, None, None, {}))
    with pytest.raises(NoBodyError, match="No frame shows a whole body"):
        make_scene("mirror", f"clip:{tmp_path / 'empty.npz'}").enter()


def test_frames_that_cannot_be_are_held_and_counted(tmp_path: Path) -> None:
    clip = moving_clip()
    positions = clip.positions.copy()
    positions[20:23] += 3.0
    write_clip(tmp_path / "jump.npz", checked_clip("jump", positions, clip.confidence, clip.t, None, None, {}))
    scene = make_scene("mirror", f"clip:{tmp_path / 'jump.npz'}")
    run_undrawn(scene, None)
    assert scene.report()["held_frames"] == 3
    assert scene.report()["fell_at_s"] is None


def test_a_recording_is_played_to_its_end_unless_seconds_are_asked_for(tmp_path: Path) -> None:
    write_clip(tmp_path / "sway.npz", moving_clip())
    spec = f"clip:{tmp_path / 'sway.npz'}"
    for seconds, ends in ((None, 39 / 30.0), (0.5, 0.5), (2.0, 2.0)):
        scene = make_scene("mirror", spec)
        run_undrawn(scene, seconds)
        assert scene.time_s == pytest.approx(ends, abs=1.5 / 60.0)


@pytest.mark.parametrize("name", ["mirror", "duel"])
def test_a_slow_or_stumbling_clock_and_the_pictures_change_no_state(name: str) -> None:
    alone = make_scene(name, "script")
    run_undrawn(alone, 0.3)
    ticks = np.random.default_rng(5).uniform(0.002, 0.2, 100_000).cumsum()
    for clock in (None, iter(ticks).__next__):
        report = _paced(name, clock)
        assert report == alone.report()["state_sha256"]


def _paced(name: str, clock: Callable[[], float] | None) -> object:
    """The state hash of 0.3 s in the loop with a picture, paced by this clock, or by none."""
    settings = Settings()
    casting = Casting("script", "original", settings, 0)
    scene = casting.scene(name)
    options = Options(headless=True, size=(64, 64), seconds=0.3, overlay=False)
    try:
        app = App(scene, settings, options, None, clock=clock or time.perf_counter, renderer=Backdrop())
    except NoPicture as missing:
        pytest.skip(str(missing))
    if clock is not None:
        app.pace = WallPace()
    while not app.over:
        app.frame()
    report = app.close()
    assert clock is None or report.frames != report.updates, "this clock owes now none and now several updates a picture"
    return scene.report()["state_sha256"]
