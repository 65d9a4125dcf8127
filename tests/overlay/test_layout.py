"""What the overlay writes stays on the screen and is big enough to read, on small and on dense screens."""

from typing import Any

import numpy as np
import pytest
from imgui_bundle import imgui

from game.overlay.help_keys import FOOT_EM, ROW_EM, TOP_EM, caps_of, help_opacity
from game.overlay.ink import Ink
from game.overlay.layout import free_span, panel_area, plots_area
from game.overlay.style import interface_scale
from game.overlay.view import Shown, View
from game.tunables import Settings
from tests.overlay.conftest import PlayBox
from tests.overlay.pilot import Pilot

SCREENS = [(1280, 720, 1.0), (2560, 1440, 2.0), (1280, 720, 2.0), (1920, 1080, 1.0), (640, 360, 1.0)]


def at_scale(pilot: Pilot, content_scale: float, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("glfw.get_window_content_scale", lambda _window: (content_scale, content_scale))
    pilot.frames(3)


@pytest.mark.parametrize(("width", "height", "content_scale"), SCREENS)
def test_every_button_and_control_lies_on_the_screen_and_inside_its_panel(
    play_box: PlayBox, monkeypatch: pytest.MonkeyPatch, width: int, height: int, content_scale: float
) -> None:
    settings = Settings({"physics.self_collision": True})
    pilot = play_box(settings, size=(width, height))
    settings.set("physics.self_collision", False)
    at_scale(pilot, content_scale, monkeypatch)
    pilot.overlay.shown.panel = True
    pilot.frames(3)
    panel, menu = pilot.overlay.panel, pilot.overlay.menu
    em = imgui.get_style().font_size_base * imgui.get_style().font_scale_dpi
    area = panel_area(pilot.overlay.size, em)
    assert "restart" in panel.buttons
    for name, place in {**panel.places, **panel.buttons}.items():
        assert area.left <= place.left < place.right <= area.right, name
        assert place.right - place.left >= 1.2 * em, name
    assert panel.buttons["restart"].bottom <= area.top + area.height
    pilot.overlay.shown.panel, pilot.overlay.shown.menu = False, True
    pilot.frames(3)
    for name, place in menu.buttons.items():
        assert 0 <= place.left < place.right <= width, name
        if height / content_scale >= 700:
            assert 0 <= place.top < place.bottom <= height, name


@pytest.mark.parametrize(("width", "height", "content_scale"), SCREENS)
def test_the_panels_leave_the_middle_of_the_picture_free(width: int, height: int, content_scale: float) -> None:
    em = 18.0 * interface_scale(height, content_scale)
    left, right = free_span(Shown(panel=True, plots=True), (width, height), em)
    if height / content_scale >= 700:
        assert left < 0.38 * width
        assert right > 0.6 * width
    assert plots_area((width, height), em).right < panel_area((width, height), em).left or width < 1280 * content_scale


def test_text_is_never_smaller_than_eleven_pixels_and_grows_with_the_screen() -> None:
    sizes = [18.0 * interface_scale(height, 1.0) for height in (180, 360, 720, 1080, 2160)]
    assert sizes == sorted(sizes)
    assert sizes[0] >= 11.0
    assert 18.0 * interface_scale(1440, 2.0) == 2 * 18.0 * interface_scale(720, 1.0)


def test_nothing_of_the_overlay_lies_over_the_hero_at_the_start(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.app.scene.drawables = lambda blend: ()  # type: ignore[method-assign]  # the box carries a word of its own
    pilot.frames(5)
    picture = pilot.app.output.read().astype(int)
    hero = picture[140:700, 340:940]
    assert np.ptp(hero.reshape(-1, 3), axis=0).max() == 0, "the middle of the picture shows the plain backdrop"
    assert np.ptp(picture.reshape(-1, 3), axis=0).max() > 100, "and the writing is there"


def test_the_keys_are_shown_for_fifteen_seconds_and_leave_once_somebody_plays() -> None:
    view = View("duel", Settings(), now_s=10.0)
    assert help_opacity(view) == 1.0
    assert help_opacity(View("duel", Settings(), now_s=14.9)) == 1.0
    assert help_opacity(View("duel", Settings(), now_s=17.0)) == 0.0
    assert help_opacity(View("duel", Settings(), now_s=10.0, first_input_s=2.0)) == 0.0


def test_key_caps_are_one_for_each_key() -> None:
    assert caps_of("W A S D") == ("W", "A", "S", "D")
    assert caps_of("Left Shift") == ("Left Shift",)
    assert caps_of("Q / E") == ("Q", "E")


@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (1280, 400)])
@pytest.mark.parametrize("count", [1, 9, 20])
def test_the_card_of_keys_stays_in_the_left_part_of_the_screen(play_box: PlayBox, size: tuple[int, int], count: int) -> None:
    pilot = play_box(size=size)
    pairs = tuple((f"{chr(65 + i)} {chr(66 + i)}", "do something") for i in range(count))
    pilot.app.scene.help_keys = lambda: pairs  # type: ignore[method-assign]
    pilot.frames(1)
    columns, em = pilot.overlay.hud._help_keys._columns, 18.0 * pilot.overlay.scale
    assert [row for column in columns for row in column.rows] == [(caps_of(keys), meaning) for keys, meaning in pairs]
    height = len(columns[0].rows) * ROW_EM * em
    assert height + (TOP_EM + FOOT_EM) * em <= size[1]
    assert sum(column.width for column in columns) <= (0.33 if count <= 9 else 0.75) * size[0]


def test_the_score_moves_aside_for_a_panel(play_box: PlayBox, monkeypatch: pytest.MonkeyPatch) -> None:
    pilot = play_box(size=(640, 360))
    written: dict[str, tuple[float, float]] = {}
    write = Ink.text

    def note(self: Ink, x: float, y: float, text: str, *rest: Any, **more: Any) -> None:
        written[text] = (x, x + self.width(text, rest[1] if len(rest) > 1 else 1.0, rest[2] if len(rest) > 2 else None))
        write(self, x, y, text, *rest, **more)

    monkeypatch.setattr(Ink, "text", note)
    pilot.frames(1)
    left, right = written["You 2 : 1 Rival"]
    assert (left + right) / 2 == pytest.approx(320)
    pilot.overlay.shown.panel = True
    pilot.frames(2)
    assert written["You 2 : 1 Rival"][1] < panel_area((640.0, 360.0), 18.0 * pilot.overlay.scale).left
