"""A small window without a display, renderers of each quality, and a picture-taking function that fails on any OpenGL error."""

from collections.abc import Callable, Iterator, Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

import game  # noqa: F401  settles which GLFW is used, before anything imports it
from game.drawables import Layer
from game.render.camera import Camera
from game.render.gl_window import GLWindow, NoPicture, open_gl
from game.scenes.living_room import room_cameras
from game.tunables import Settings

SIZE = (320, 180)
Shoot = Callable[..., NDArray[np.uint8]]


@pytest.fixture(scope="session")
def window() -> Iterator[GLWindow]:
    try:
        opened = open_gl(*SIZE, "tests", headless=True)
    except NoPicture as missing:
        pytest.skip(str(missing))
    yield opened
    opened.close()


@pytest.fixture(autouse=True)
def current(request: pytest.FixtureRequest) -> None:
    """The shared window has OpenGL's ear again, whatever windows other tests opened and closed since."""
    if {"window", "shoot", "renderers"} & set(request.fixturenames):
        request.getfixturevalue("window").make_current()


@pytest.fixture(scope="session")
def renderers(window: GLWindow) -> Iterator[Callable]:
    from game.render.renderer import Renderer

    made: dict[str, Renderer] = {}

    def renderer(quality: str) -> Renderer:
        if quality not in made:
            made[quality] = Renderer(window.ctx, quality, Settings())
        return made[quality]

    yield renderer
    for used in made.values():
        used.release()


@pytest.fixture
def shoot(window: GLWindow, renderers: Callable) -> Iterator[Shoot]:
    """shoot(layers, quality="low", camera=None, **tunables) -> picture (180, 320, 3); tunables with _ for the dot's group picture."""
    from game.render.capture import read_pixels

    used = []

    def take(layers: Sequence[Layer], quality: str = "low", camera: Camera | None = None, **values: object) -> NDArray[np.uint8]:
        renderer = renderers(quality)
        used.append(renderer)
        for name, value in values.items():
            renderer.settings.set(f"picture.{name}", value)
        renderer.render(layers, camera or Camera(room_cameras()["mirror"]), window.screen, SIZE)
        assert window.ctx.error == "GL_NO_ERROR"
        return read_pixels(window.ctx.screen, SIZE)

    yield take
    for renderer in used:
        renderer.settings.reset()
