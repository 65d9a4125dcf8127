"""Depth points on the screen: where the vertex shader puts them, and what is sent to the graphics card."""

from collections.abc import Iterator

import moderngl
import numpy as np
import pytest

from game.drawables import DepthPoints, Layer
from game.render.camera import Camera
from game.render.capture import read_pixels
from game.render.gl_window import NoPicture, open_gl
from game.render.renderer import Renderer
from game.scenes.scene import CameraHint
from game.tunables import Settings

SIZE = (320, 240)
METRES = np.zeros(2048, dtype=np.float32)
METRES[1:1000] = np.arange(1, 1000) / 200.0  # a code is half a centimetre
TURN = np.array([[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
SHIFT = np.array([2.5, 0.0, 1.0])


@pytest.fixture(scope="module")
def drawn() -> Iterator[tuple[moderngl.Context, Renderer, Camera]]:
    try:
        window = open_gl(*SIZE, "points", headless=True)
    except NoPicture as missing:
        pytest.skip(str(missing))
    renderer = Renderer(window.ctx, "medium", Settings({"picture.vignette": 0.0}))
    camera = Camera(CameraHint((2.5, 0.0, 1.0), (0.0, 0.0, 1.0), 40.0))
    yield window.ctx, renderer, camera
    renderer.release()
    window.close()


def square(code: int = 400) -> np.ndarray:
    """A picture whose middle 40 x 40 pixels hold one code."""
    codes = np.zeros((480, 640), dtype=np.uint16)
    codes[220:260, 300:340] = code
    return codes


def shoot(drawn: tuple[moderngl.Context, Renderer, Camera], *layers: Layer) -> np.ndarray:
    ctx, renderer, camera = drawn
    renderer.render(layers, camera, ctx.screen, SIZE)
    assert ctx.error == "GL_NO_ERROR"
    return read_pixels(ctx.screen, SIZE)[..., :3].astype(int)


def cloud(codes: np.ndarray, **changes: object) -> Layer:
    return Layer("cloud", (DepthPoints(codes, METRES, 575.0, (320.0, 240.0), TURN, SHIFT, **changes),))  # type: ignore[arg-type]


def lit(drawn: tuple[moderngl.Context, Renderer, Camera], layer: Layer) -> np.ndarray:
    """(n, 2) columns and rows of the pixels that the layer changes."""
    return np.argwhere(np.abs(shoot(drawn, layer) - shoot(drawn)).max(axis=2) > 12)[:, ::-1]


def test_what_lies_straight_before_the_depth_camera_is_drawn_where_that_looks(drawn) -> None:
    seen = lit(drawn, cloud(square()))
    # 40 px / 575 px at 2 m is 0.139 m; the picture's 240 lines show 2 tan(20 deg) 2 m = 1.456 m
    assert seen.mean(axis=0) == pytest.approx((159.5, 119.5), abs=1.5)
    assert np.ptp(seen, axis=0) == pytest.approx((22.9, 22.9), abs=3.0)


def test_the_depth_picture_s_left_and_top_stay_left_and_top(drawn) -> None:
    codes = np.zeros((480, 640), dtype=np.uint16)
    codes[160:180, 200:220] = 400
    assert np.all(lit(drawn, cloud(codes)).mean(axis=0) < (120.0, 90.0))


@pytest.mark.parametrize(
    "codes", [square(0), square(1500), square(2047), square(5000)], ids=["0", "no metres", "no data", "beyond the table"]
)
def test_codes_without_metres_draw_nothing(drawn, codes: np.ndarray) -> None:
    assert len(lit(drawn, cloud(codes))) == 0


def test_nothing_is_drawn_beyond_reach(drawn) -> None:
    assert len(lit(drawn, cloud(square(), reach_m=1.9))) == 0 and len(lit(drawn, cloud(square(), reach_m=2.1))) > 0


def test_nearer_points_hide_farther_ones(drawn) -> None:
    near, far = cloud(square(300), diameter_m=0.02), cloud(square(800), diameter_m=0.02)
    middle = (slice(117, 122), slice(157, 162))
    alone = shoot(drawn, near)[middle]
    assert np.abs(shoot(drawn, far, near)[middle] - alone).max() <= 3
    assert np.abs(shoot(drawn, near, far)[middle] - alone).max() <= 3
    assert np.abs(shoot(drawn, far)[middle] - alone).max() > 30


def test_a_picture_that_has_not_changed_is_not_sent_again(drawn) -> None:
    _, renderer, _ = drawn
    codes = square()
    shoot(drawn, cloud(codes))
    assert renderer._cloud is not None
    before = renderer._cloud.uploads
    shoot(drawn, cloud(codes))
    assert renderer._cloud.uploads == before
    shoot(drawn, cloud(square()))
    assert renderer._cloud.uploads == before + 1


def test_a_picture_of_another_size_can_follow(drawn) -> None:
    shoot(drawn, cloud(square()))
    assert len(lit(drawn, cloud(np.full((60, 80), 400, dtype=np.uint16)))) > 0
