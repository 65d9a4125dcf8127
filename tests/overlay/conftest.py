"""The game on a window without a display, with a box for a hero and a plain backdrop."""

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from game.app import App, Options
from game.inputs.steering import Steering
from game.render.gl_window import NoPicture
from game.tunables import Settings
from tests.app.bouncing_box import BouncingBox, push_from_gamepad, push_from_keys
from tests.overlay.pilot import Pilot


class Backdrop:
    """Stands in for the renderer: two plain colours."""

    def render(self, layers: Any, camera: Any, framebuffer: Any, size: tuple[int, int]) -> None:
        framebuffer.use()
        framebuffer.clear(0.55, 0.50, 0.43, 1.0)


PlayBox = Callable[..., Pilot]


@pytest.fixture
def play_box() -> Iterator[PlayBox]:
    """Starts a game and gives its pilot; every game is closed at the end, and none may have left an OpenGL error."""
    apps: list[App] = []

    def start(
        settings: Settings | None = None, on_request: Any = None, scene: BouncingBox | None = None, puppet: Any = None, **options: Any
    ) -> Pilot:
        chosen = Options(
            **{"headless": True, "size": (1280, 720), "scenes": ("mirror", "duel"), "inputs": ("puppet", "performer:boxing"), **options}
        )
        scene = scene or BouncingBox()
        steering = None if puppet else Steering(push_from_keys, push_from_gamepad)
        try:
            app = App(scene, settings or Settings(), chosen, puppet or scene.pusher, on_request, renderer=Backdrop(), steering=steering)
        except NoPicture as missing:
            pytest.skip(str(missing))
        app.actions.gamepad = lambda: None
        apps.append(app)
        if app.picture.overlay is None:
            app.close()
            pytest.skip("there is no overlay without EGL")
        return Pilot(app)

    yield start
    errors = []
    for app in apps:
        if app.picture.window.handle is not None:
            errors.append(app.picture.window.ctx.error)
        app.close()
    assert all(error == "GL_NO_ERROR" for error in errors), errors
