"""The loop: the same states for any clock, endings, pictures, and nothing left behind."""

import io
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from game.app import App, Options, play
from game.inputs.steering import Steering
from game.pacing import WallPace
from game.progress import Progress
from game.render.gl_window import NoPicture
from game.stage_times import StageTimes
from game.tunables import Settings
from tests.app.bouncing_box import BouncingBox, push_from_gamepad, push_from_keys
from tests.overlay.conftest import Backdrop

MakeApp = Callable[..., App]


@pytest.fixture
def make_app() -> Iterator[MakeApp]:
    apps: list[App] = []

    def make(scene: BouncingBox, clock: Callable[[], float] | None = None, **options: Any) -> App:
        chosen = Options(**{"headless": True, "size": (160, 90), "overlay": False, **options})
        try:
            steering = Steering(push_from_keys, push_from_gamepad)
            app = App(scene, Settings(), chosen, scene.pusher, None, clock or time.perf_counter, Backdrop(), steering)
        except NoPicture as missing:
            pytest.skip(str(missing))
        apps.append(app)
        return app

    yield make
    for app in apps:
        app.close()


class JitteryClock:
    """Seconds that pass unevenly, now and then by half a second at once."""

    def __init__(self, seed: int) -> None:
        self._rng = np.random.default_rng(seed)
        self._now = 100.0

    def __call__(self) -> float:
        self._now += 0.5 if self._rng.random() < 0.02 else self._rng.uniform(0.001, 0.03)
        return self._now


def run_out(app: App, limit: int = 5000) -> None:
    while not app.over:
        app.frame()
        limit -= 1
        assert limit, "the run does not end"


def test_any_clock_gives_the_same_states(make_app: MakeApp) -> None:
    headless = BouncingBox()
    run_out(make_app(headless, seconds=2.0))
    assert len(headless.history) == 120
    for seed in range(3):
        paced = BouncingBox()
        app = make_app(paced, clock=JitteryClock(seed), seconds=2.0)
        app.pace = WallPace()
        run_out(app)
        assert paced.history == headless.history


def test_a_video_of_thirty_frames_a_second_has_the_same_states_as_one_of_sixty(make_app: MakeApp) -> None:
    sixty, thirty = BouncingBox(), BouncingBox()
    run_out(make_app(sixty, seconds=1.0))
    run_out(app := make_app(thirty, seconds=1.0, fps=30))
    assert sixty.history == thirty.history
    assert app.frames == 30


def test_a_headless_run_ends_after_the_asked_seconds_and_else_with_the_recording(make_app: MakeApp) -> None:
    for length, seconds, updates in ((0.5, None, 30), (0.5, 0.2, 12), (0.5, 1.0, 60)):
        scene = BouncingBox(length_s=length)
        run_out(make_app(scene, seconds=seconds))
        assert len(scene.history) == updates


def test_the_picture_is_the_last_frame_in_the_asked_size(make_app: MakeApp, tmp_path: Path) -> None:
    path = tmp_path / "new" / "last.png"
    app = make_app(BouncingBox(), seconds=0.1, picture=path)
    run_out(app)
    report = app.close()
    assert report.files == (path,)
    with Image.open(path) as picture:
        assert picture.size == (160, 90)
        assert np.abs(np.asarray(picture)[45, 80] - np.array([140, 128, 110])).max() <= 1
    assert (report.updates, report.frames) == (6, 6)
    assert report.simulated_s == pytest.approx(0.1)
    assert {"update", "draw", "swap"} <= set(report.stage_ms)


def test_the_video_has_one_picture_for_every_update(make_app: MakeApp, tmp_path: Path) -> None:
    av = pytest.importorskip("av", reason="videos are written by PyAV")
    app = make_app(BouncingBox(), seconds=0.5, video=tmp_path / "film" / "box.mp4")
    run_out(app)
    assert app.close().files == (tmp_path / "film" / "box.mp4",)
    with av.open(str(tmp_path / "film" / "box.mp4")) as film:
        frames = list(film.decode(video=0))
    assert len(frames) == 30
    assert (frames[0].width, frames[0].height) == (160, 90)


def test_closing_leaves_the_scene_and_a_second_close_is_harmless(make_app: MakeApp) -> None:
    scene = BouncingBox()
    app = make_app(scene)
    app.frame()
    app.close()
    app.close()
    assert scene.left >= 1


def test_games_can_follow_each_other_in_one_process(make_app: MakeApp) -> None:
    for _ in range(3):
        app = make_app(BouncingBox(), overlay=True)
        app.frame()
        app.close()


def test_play_shows_its_progress_and_closes_when_the_scene_breaks(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("game.picture._renderer", lambda window, quality, settings: Backdrop())
    options = Options(headless=True, size=(64, 36), seconds=0.5, overlay=False)
    try:
        report = play(BouncingBox(), Settings(), options)
    except NoPicture as missing:
        pytest.skip(str(missing))
    assert report.updates == 30
    assert "100 %" in capsys.readouterr().err
    broken = BouncingBox()
    broken.fixed_update = lambda: 1 / 0  # type: ignore[method-assign]
    with pytest.raises(ZeroDivisionError):
        play(broken, Settings(), options)
    assert broken.left == 1
    assert play(BouncingBox(), Settings(), options).updates == 30, "the next game finds a clean house"


def test_progress_on_a_file_is_ten_lines_and_not_a_thousand() -> None:
    stream = io.StringIO()
    bar = Progress("topple", 10.0, stream)
    for tenth in range(1001):
        bar.show(tenth / 100)
    bar.close()
    lines = stream.getvalue().splitlines()
    assert len(lines) == 11
    assert "[##############################] 100 %  10.0 of 10.0 s" in lines[-1]


def test_the_bar_counts_the_hang_and_the_seconds_do_not() -> None:
    stream = io.StringIO()
    bar = Progress("topple", 3.0, stream, start_s=-1.0)
    for now in (-1.0, 0.0, 3.0):
        bar.show(now)
    assert ["0 %  0.0 of 3.0 s" in stream.getvalue().splitlines()[0], " 25 %  0.0 of" in stream.getvalue()] == [True, True]
    assert "100 %  3.0 of 3.0 s" in stream.getvalue()


def test_a_run_of_unknown_length_counts_seconds() -> None:
    stream = io.StringIO()
    bar = Progress("topple", None, stream)
    for tenth in range(300):
        bar.show(tenth / 10)
    assert [line.split(",")[0] for line in stream.getvalue().splitlines()] == ["topple  0 s", "topple  10 s", "topple  20 s"]


def test_a_headless_run_of_what_never_ends_is_twenty_seconds_long(make_app: MakeApp) -> None:
    scene = BouncingBox()
    scene.endless = True  # type: ignore[attr-defined]
    assert make_app(scene).seconds == 20.0
    assert make_app(scene, seconds=3.0).seconds == 3.0
    assert make_app(BouncingBox(length_s=32.0)).seconds is None


def test_a_scene_that_cannot_start_leaves_no_window_behind(make_app: MakeApp) -> None:
    broken = BouncingBox()
    broken.enter = lambda: int("nobody")  # type: ignore[method-assign, assignment, return-value]
    with pytest.raises(ValueError, match="nobody"):
        make_app(broken)
    assert broken.left == 1
    assert make_app(BouncingBox()).picture.window.kind in ("egl", "osmesa")


def test_memory_without_a_window_draws_the_same_picture(make_app: MakeApp, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("TOPPLE_GL", "osmesa")
    app = make_app(BouncingBox(), seconds=0.05, picture=tmp_path / "memory.png", overlay=True)
    assert app.picture.overlay is None
    run_out(app)
    assert app.picture.window.ctx.error == "GL_NO_ERROR"
    app.close()
    with Image.open(tmp_path / "memory.png") as picture:
        assert np.abs(np.asarray(picture)[45, 80] - np.array([140, 128, 110])).max() <= 1


def test_stage_times_are_medians_of_the_newest_samples() -> None:
    times = StageTimes()
    for ms in (100.0, 1.0, 2.0, 3.0):
        times.add("draw", ms)
    assert times.medians(3)["draw"] == 2.0
    with times.measure("update"):
        pass
    assert list(times.medians()) == ["draw", "update"]
