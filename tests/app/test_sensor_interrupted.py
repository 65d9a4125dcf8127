"""A pulled plug is a pause: the loop stops within half a second, says why, and goes on by itself."""

import time
from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest

from game.app import App, Options
from game.characters.body_plan import load_body_plan
from game.inputs.kinect_live import LiveKinect
from game.overlay.hud import _badges
from game.pacing import WallPace
from game.render.gl_window import NoPicture
from game.scenes.mirror import Mirror
from game.scenes.scene import Scene
from game.tunables import Settings
from kinect.usb.sensor import KinectSensor
from kinect.usb.simulated_faults import simulate
from kinect.usb.simulated_libusb import in_use
from tests.app.bouncing_box import BouncingBox
from tests.overlay.conftest import Backdrop

Watched = Callable[[Scene], App]


@pytest.fixture
def watched() -> Iterator[Watched]:
    """Makes the loop of a game that somebody watches, but without a window on a screen."""
    apps: list[App] = []

    def make(scene: Scene) -> App:
        try:
            app = App(scene, Settings(), Options(headless=True, size=(160, 90), overlay=False), renderer=Backdrop())
        except NoPicture as missing:
            pytest.skip(str(missing))
        app.options = replace(app.options, headless=False)
        app.pace = WallPace()
        apps.append(app)
        return app

    yield make
    for app in apps:
        app.close()


class Waiting(BouncingBox):
    """A scene whose sensor may be gone."""

    interrupted = ""


def frames_until(app: App, condition: Callable[[], bool], within_s: float) -> float | None:
    began = time.monotonic()
    while time.monotonic() - began < within_s:
        app.frame()
        if condition():
            return time.monotonic() - began
        time.sleep(0.005)
    return None


def test_while_the_sensor_is_gone_nothing_moves_and_the_view_says_why(watched: Watched) -> None:
    scene = Waiting()
    app = watched(scene)
    assert frames_until(app, lambda: scene.steps > 3, 2.0) is not None
    scene.interrupted = "The Kinect was unplugged."
    steps = scene.steps
    assert frames_until(app, lambda: scene.steps > steps, 0.2) is None
    assert app.actions.paused and app.actions.view().interrupted == scene.interrupted
    assert _badges(app.actions.view())[0][0] == "paused until the sensor is back"
    scene.interrupted = ""
    assert frames_until(app, lambda: scene.steps > steps, 2.0) is not None
    assert not app.actions.paused and app.actions.view().interrupted == ""


def test_who_paused_before_stays_paused_when_the_sensor_is_back(watched: Watched) -> None:
    scene = Waiting()
    app = watched(scene)
    app.actions.do("pause")
    scene.interrupted = "The Kinect was unplugged."
    app.frame()
    scene.interrupted = ""
    app.frame()
    assert app.actions.paused


def test_a_run_that_nobody_watches_does_not_wait(watched: Watched) -> None:
    scene = Waiting()
    app = watched(scene)
    app.options = replace(app.options, headless=True)
    scene.interrupted = "The Kinect was unplugged."
    assert not app.actions.paused


def test_the_game_pauses_when_the_plug_is_pulled_and_goes_on_when_it_is_back(watched: Watched) -> None:
    simulation = simulate("none")
    sources: list[LiveKinect] = []

    def opens() -> LiveKinect:
        sources.append(LiveKinect(lambda: KinectSensor(simulation.load)))
        return sources[-1]

    scene = Mirror(load_body_plan("original"), opens, Settings(), input_name="kinect")
    app = watched(scene)
    assert frames_until(app, lambda: scene.time_s > 0.1 and sources[-1].depth() is not None, 20.0) is not None
    simulation.host.unplug(simulation.kinect)
    assert (told := frames_until(app, lambda: app.actions.paused, 2.0)) is not None and told < 0.5
    stopped_s = scene.time_s
    assert "unplugged" in scene.messages()[0] and "unplugged" in app.actions.view().status
    assert frames_until(app, lambda: scene.time_s != stopped_s, 0.3) is None
    simulation.host.plug(simulation.kinect)
    back = frames_until(app, lambda: scene.time_s > stopped_s, 5.0)
    assert back is not None and back < 3.0
    assert len(sources) == 1, "nothing was opened anew for it"
    app.close()
    assert in_use(simulation.host)["handles"] == 0
