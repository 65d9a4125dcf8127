"""The depth camera's picture in the corner of the screen."""

import numpy as np
import pytest
from imgui_bundle import imgui

from game.overlay.layout import depth_area, plots_area
from game.overlay.view import Shown
from game.render.capture import read_pixels
from tests.app.bouncing_box import BouncingBox
from tests.overlay.conftest import PlayBox

RED, BLUE = (230, 20, 20, 255), (20, 20, 230, 255)


def two_halves(left: tuple[int, ...], right: tuple[int, ...]) -> np.ndarray:
    picture = np.empty((240, 320, 4), dtype=np.uint8)
    picture[:, :160], picture[:, 160:] = left, right
    return picture


class BoxWithDepth(BouncingBox):
    """A scene that has a depth picture besides."""

    depth_picture: np.ndarray | None = None


def colours(pilot) -> tuple[np.ndarray, np.ndarray]:
    """The pixels at a quarter and at three quarters of the panel's picture."""
    window = pilot.app.picture.window
    screen = read_pixels(window.screen, window.framebuffer_size)
    style = imgui.get_style()
    area = depth_area(Shown(), pilot.overlay.size, style.font_size_base * style.font_scale_dpi)
    y = int(area.top + 0.55 * area.height)
    return tuple(screen[y, int(area.left + share * area.width), :3].astype(int) for share in (0.25, 0.75))  # type: ignore[return-value]


def test_the_picture_is_shown_upright_and_unmirrored_and_follows_its_changes(play_box: PlayBox) -> None:
    scene = BoxWithDepth()
    scene.depth_picture = two_halves(RED, BLUE)
    pilot = play_box(scene=scene)
    pilot.frames(3)
    left, right = colours(pilot)
    assert np.abs(left - RED[:3]).max() < 12 and np.abs(right - BLUE[:3]).max() < 12
    scene.depth_picture = two_halves(BLUE, RED)
    pilot.frames(2)
    left, right = colours(pilot)
    assert np.abs(left - BLUE[:3]).max() < 12 and np.abs(right - RED[:3]).max() < 12


def test_a_picture_that_stays_the_same_is_sent_once(play_box: PlayBox) -> None:
    scene = BoxWithDepth()
    scene.depth_picture = two_halves(RED, BLUE)
    pilot = play_box(scene=scene)
    pilot.frames(5)
    assert pilot.overlay.depth.uploads == 1


def test_without_depth_there_is_no_panel(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.frames(2)
    assert pilot.overlay.depth.uploads == 0


@pytest.mark.parametrize("size", [(1280.0, 720.0), (1920.0, 1080.0), (640.0, 360.0)])
def test_the_panel_keeps_clear_of_the_plots_and_of_the_screen_s_edges(size: tuple[float, float]) -> None:
    em = size[1] / 40.0
    alone, beside = depth_area(Shown(), size, em), depth_area(Shown(plots=True), size, em)
    assert beside.left >= plots_area(size, em).right and beside.right < size[0]
    assert alone.left > 0.0 and alone.top > 0.0 and alone.top + alone.height < size[1] - 2.5 * em
