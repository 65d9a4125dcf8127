"""Every tunable has its control, and a real mouse and keyboard turn it."""

import glfw
import pytest

from game.presets import PRESETS
from game.tunables import TUNABLES, Settings
from tests.overlay.conftest import PlayBox


def test_every_tunable_has_a_control_and_every_control_a_tunable(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.overlay.shown.panel = True
    pilot.frames(2)
    assert set(pilot.overlay.panel.places) == set(TUNABLES)


def test_dragging_a_slider_to_the_right_raises_its_tunable(play_box: PlayBox) -> None:
    settings = Settings()
    pilot = play_box(settings)
    place = pilot.show("balance.w_vel")
    middle = (place.top + place.bottom) / 2
    before = settings.number("balance.w_vel")
    grab = place.left + before * (place.right - place.left)
    pilot.drag((grab, middle), (grab + 0.3 * (place.right - place.left), middle))
    assert settings.number("balance.w_vel") == pytest.approx(before + 0.3, abs=0.06)


def test_every_number_can_be_dragged_to_both_ends_of_its_range(play_box: PlayBox) -> None:
    settings = Settings()
    pilot = play_box(settings, size=(640, 360))
    for name, tunable in TUNABLES.items():
        if tunable.choices or isinstance(tunable.default, bool):
            continue
        place = pilot.show(name)
        middle = (place.top + place.bottom) / 2
        pilot.drag(((place.left + place.right) / 2, middle), (place.right + 20, middle))
        assert settings.number(name) == pytest.approx(tunable.high), name
        pilot.drag(((place.left + place.right) / 2, middle), (place.left - 20, middle))
        assert settings.number(name) == pytest.approx(tunable.low), name


def test_ctrl_click_types_a_value_and_no_key_of_it_reaches_the_game(play_box: PlayBox) -> None:
    settings = Settings()
    pilot = play_box(settings)
    place = pilot.show("balance.ankle_clamp_rad")
    pilot.ctrl_click(place)
    for key in ("0", "period", "0", "3", "4"):
        pilot.press(key)
    pilot.type("0.0345")
    pilot.press("enter")
    assert settings.number("balance.ankle_clamp_rad") == 0.0345
    assert not pilot.app.actions.paused
    assert "3" not in pilot.app.picture.events.keyboard.pressed  # type: ignore[union-attr]


def test_a_typed_value_beyond_the_range_stops_at_its_end(play_box: PlayBox) -> None:
    settings = Settings()
    pilot = play_box(settings)
    place = pilot.show("ik.damping")
    pilot.ctrl_click(place)
    pilot.type("50")
    pilot.press("enter")
    assert settings.number("ik.damping") == TUNABLES["ik.damping"].high


def test_a_switch_is_clicked_and_a_choice_is_picked(play_box: PlayBox) -> None:
    settings = Settings()
    pilot = play_box(settings)
    pilot.click(pilot.show("pd.gravity_feedforward"))
    assert settings.switch("pd.gravity_feedforward") is not TUNABLES["pd.gravity_feedforward"].default
    place = pilot.show("ik.method")
    pilot.click(place)
    pilot.move(place.left + 20, place.bottom + 12)
    pilot.button(True)
    pilot.button(False)
    assert settings.choice("ik.method") == TUNABLES["ik.method"].choices[0]


def test_a_right_click_offers_the_way_back_to_the_default(play_box: PlayBox) -> None:
    settings = Settings({"balance.w_vel": 0.9})
    pilot = play_box(settings)
    place = pilot.show("balance.w_vel")
    pilot.click(place, glfw.MOUSE_BUTTON_RIGHT)
    pilot.frames(2)
    x, y = (place.left + place.right) / 2, (place.top + place.bottom) / 2
    pilot.move(x + 25, y + 20)
    pilot.button(True)
    pilot.button(False)
    assert settings.number("balance.w_vel") == TUNABLES["balance.w_vel"].default


def test_the_preset_button_writes_the_thesis_and_leaves_the_picture_alone(play_box: PlayBox) -> None:
    settings = Settings({"picture.exposure": 2.0, "ik.damping": 1.0})
    pilot = play_box(settings)
    pilot.overlay.shown.panel = True
    pilot.frames(2)
    pilot.click(pilot.overlay.panel.buttons["preset thesis"])
    assert {name: settings.get(name) for name in PRESETS["thesis"]} == PRESETS["thesis"]
    assert settings.number("picture.exposure") == 2.0
    pilot.click(pilot.overlay.panel.buttons["reset all"])
    pilot.frames(2)
    assert settings.as_dict() == Settings().as_dict()


def test_typing_into_the_filter_leaves_only_what_matches(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.overlay.shown.panel = True
    pilot.frames(2)
    pilot.click(pilot.overlay.panel.buttons["filter"])
    pilot.type("ankle clamp")
    assert set(pilot.overlay.panel.places) == {"balance.ankle_clamp_rad"}


def test_what_takes_effect_at_restart_says_so_and_its_button_restarts(play_box: PlayBox) -> None:
    settings = Settings()
    pilot = play_box(settings)
    pilot.overlay.shown.panel = True
    pilot.frames(2)
    assert "restart" not in pilot.overlay.panel.buttons
    settings.set("physics.self_collision", True)
    pilot.frames(2)
    pilot.click(pilot.overlay.panel.buttons["restart"])
    pilot.frames(2)
    assert "restart" not in pilot.overlay.panel.buttons
    assert pilot.app.scene.entered == 2  # type: ignore[attr-defined]


def test_saved_settings_come_back_by_the_load_button(play_box: PlayBox, tmp_path) -> None:
    settings = Settings({"balance.w_vel": 0.7, "ik.method": "sdls"})
    pilot = play_box(settings, settings_path=tmp_path / "topple" / "settings.toml")
    pilot.overlay.shown.panel = True
    pilot.frames(2)
    pilot.click(pilot.overlay.panel.buttons["save"])
    pilot.click(pilot.overlay.panel.buttons["reset all"])
    pilot.frames(2)
    assert settings.number("balance.w_vel") == TUNABLES["balance.w_vel"].default
    pilot.click(pilot.overlay.panel.buttons["load"])
    pilot.frames(2)
    assert (settings.number("balance.w_vel"), settings.choice("ik.method")) == (0.7, "sdls")
