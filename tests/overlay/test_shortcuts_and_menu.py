"""Keys, mouse, menu and gamepad reach the game by the path real events take."""

from pathlib import Path

import pytest

from game.actions import Staged
from game.inputs.gamepad import AXES, BUTTONS, GamepadState
from game.inputs.puppet_controls import KEYS, PuppetControls
from game.shortcuts import SHORTCUTS
from game.tunables import TUNABLES
from tests.app.bouncing_box import BouncingBox, Push
from tests.overlay.conftest import PlayBox
from tests.overlay.pilot import Pilot


@pytest.mark.parametrize(("key", "part"), [("tab", "panel"), ("f1", "help"), ("f8", "plots"), ("escape", "menu")])
def test_a_key_opens_a_part_of_the_overlay_and_closes_it_again(play_box: PlayBox, key: str, part: str) -> None:
    pilot = play_box()
    assert not getattr(pilot.overlay.shown, part)
    pilot.press(key)
    assert getattr(pilot.overlay.shown, part)
    pilot.press(key)
    assert not getattr(pilot.overlay.shown, part)


def test_p_stops_time_and_a_full_stop_lets_one_update_through(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.press("p")
    held = pilot.app.updates
    pilot.frames(3)
    assert pilot.app.updates == held
    pilot.press("period")
    assert pilot.app.updates == held + 1
    pilot.press("p")
    assert pilot.app.updates > held + 1


def test_r_restarts_the_scene(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.frames(10)
    pilot.key("r", True)
    assert pilot.app.scene.time_s <= 1 / 60
    assert pilot.app.scene.entered == 2  # type: ignore[attr-defined]


def test_a_key_held_through_a_restart_still_steers(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.key("w", True)
    assert pilot.app.controls is not None
    enter = pilot.app.scene.enter

    def enter_with_a_fresh_puppet() -> None:
        enter()
        pilot.app.controls.controls = Push()

    pilot.app.scene.enter = enter_with_a_fresh_puppet  # type: ignore[method-assign]
    pilot.key("r", True)
    pilot.frames(1)
    assert pilot.app.controls.controls == Push(along=1.0)


def test_keys_steer_while_they_are_held(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.key("w", True)
    assert pilot.app.controls is not None
    assert pilot.app.controls.controls == Push(along=1.0)
    pilot.key("space", True)
    assert pilot.app.controls.controls == Push(along=1.0, jump=True)
    pilot.key("w", False)
    pilot.key("space", False)
    assert pilot.app.controls.controls == Push()


def test_a_gamepad_steers_and_its_start_button_opens_the_menu(play_box: PlayBox) -> None:
    pilot = play_box()
    rest = GamepadState((0.0,) * len(AXES), (False,) * len(BUTTONS))
    pilot.app.actions.gamepad = lambda: GamepadState((0.0, -1.0, *rest.axes[2:]), rest.buttons)
    pilot.frames()
    assert pilot.app.controls is not None
    assert pilot.app.controls.controls == Push(along=1.0)
    pilot.app.actions.gamepad = lambda: GamepadState(rest.axes, tuple(name == "start" for name in BUTTONS))
    pilot.frames()
    assert pilot.overlay.shown.menu
    assert pilot.app.controls.controls == Push(), "what the menu interrupts is let go"


def test_every_layer_has_a_key(play_box: PlayBox) -> None:
    pilot = play_box()
    for name in (n for n, t in TUNABLES.items() if t.group == "layer"):
        key = next(k for k, s in SHORTCUTS.items() if s.action == f"toggle {name}")
        before = pilot.app.settings.switch(name)
        pilot.press(key)
        assert pilot.app.settings.switch(name) is not before


def test_the_mouse_turns_pans_and_zooms_the_camera_but_not_through_a_panel(play_box: PlayBox) -> None:
    pilot = play_box()
    camera = pilot.app.picture.camera
    seen = [camera.eye]
    pilot.drag((500, 400), (600, 400))
    seen.append(camera.eye)
    target = camera.target
    pilot.drag((500, 400), (500, 300), button=1)
    assert camera.target != target
    seen.append(camera.eye)
    pilot.wheel(2.0)
    seen.append(camera.eye)
    assert len(set(seen)) == 4
    pilot.overlay.shown.panel = True
    pilot.frames(2)
    pilot.drag((1000, 300), (1000, 200))
    pilot.wheel(2.0)
    assert camera.eye == seen[-1]


def test_dragging_to_the_right_turns_what_is_in_front_to_the_right(play_box: PlayBox) -> None:
    pilot = play_box()
    camera = pilot.app.picture.camera
    near = [0.6 * e + 0.4 * t for e, t in zip(camera.eye, camera.target)]
    before = camera.project(near, (1280, 720))  # type: ignore[arg-type]
    pilot.drag((500, 400), (560, 400))
    after = camera.project(near, (1280, 720))  # type: ignore[arg-type]
    assert before is not None
    assert after is not None
    assert after[0] > before[0] + 10


def test_a_number_key_goes_to_that_camera_preset(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.press("2")
    pilot.frames(45)
    assert pilot.app.picture.camera.eye == pytest.approx((0.0, 3.0, 1.2), abs=1e-6)


def test_f12_writes_a_screenshot_into_the_output_folder(play_box: PlayBox, tmp_path: Path) -> None:
    pilot = play_box(output_dir=tmp_path / "topple-output", size=(320, 180))
    pilot.press("f12")
    pictures = list((tmp_path / "topple-output").glob("*.png"))
    assert len(pictures) == 1
    assert pictures[0].read_bytes().startswith(b"\x89PNG")


def open_menu(pilot: Pilot) -> None:
    pilot.press("escape")
    pilot.frames(3)


def test_the_menu_pauses_and_continue_goes_on(play_box: PlayBox) -> None:
    pilot = play_box()
    open_menu(pilot)
    held = pilot.app.updates
    pilot.frames(3)
    assert pilot.app.updates == held
    pilot.click(pilot.overlay.menu.buttons["Continue"])
    pilot.frames(2)
    assert pilot.app.updates > held


def test_the_menu_changes_the_scene_through_the_caller(play_box: PlayBox) -> None:
    asked: list[tuple[str, str]] = []
    duel = BouncingBox()
    duel.name = "duel"

    def on_request(kind: str, value: str) -> Staged:
        asked.append((kind, value))
        return Staged(duel, duel.pusher)

    pilot = play_box(on_request=on_request)
    mirror = pilot.app.scene
    open_menu(pilot)
    pilot.click(pilot.overlay.menu.buttons["duel"])
    pilot.frames(2)
    assert asked == [("scene", "duel")]
    assert pilot.app.scene is duel
    assert duel.entered == 1
    assert mirror.left == 1  # type: ignore[attr-defined]
    pilot.key("w", True)
    assert duel.pusher.controls == Push(along=1.0)


def test_a_dropped_file_is_asked_for_as_a_recording_and_a_refusal_is_said(play_box: PlayBox) -> None:
    def refuse(kind: str, value: str) -> Staged | None:
        raise ValueError(f"{kind} {value} is no recording.")

    pilot = play_box(on_request=refuse)
    events = pilot.app.picture.events
    assert events is not None
    events._on_drop(None, ["/tmp/walk.npz"])
    pilot.frames()
    assert [toast.text for toast in pilot.overlay.hud.toasts.visible(pilot.app.now_s)][-1] == "input clip:/tmp/walk.npz is no recording."


def test_quit_ends_the_game(play_box: PlayBox) -> None:
    pilot = play_box()
    open_menu(pilot)
    assert not pilot.app.over
    pilot.click(pilot.overlay.menu.buttons["Quit"])
    pilot.frames()
    assert pilot.app.over


def test_keys_are_let_go_when_the_window_loses_the_keyboard(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.key("w", True)
    events = pilot.app.picture.events
    assert events is not None
    events._on_focus(None, 0)
    pilot.frames()
    assert pilot.app.controls is not None
    assert pilot.app.controls.controls == Push()


def test_f11_fills_the_screen_and_gives_the_window_back(play_box: PlayBox) -> None:
    pilot = play_box(size=(640, 360))
    pilot.press("f11")
    full = pilot.app.picture.window.framebuffer_size
    assert full != (640, 360)
    assert pilot.app.output.read().shape == (full[1], full[0], 3)
    pilot.press("f11")
    assert pilot.app.picture.window.framebuffer_size == (640, 360)


class Doll:
    """Has the puppet's controls and no body."""

    controls = PuppetControls()


def test_the_puppets_keys_reach_its_controls(play_box: PlayBox) -> None:
    doll = Doll()
    pilot = play_box(puppet=doll)
    for binding in KEYS:
        pilot.key(binding.name.lower(), True)
        assert getattr(doll.controls, binding.control) == binding.value, binding.name
        pilot.key(binding.name.lower(), False)
        assert doll.controls == PuppetControls()


def test_the_first_input_starts_the_fading_of_the_keys(play_box: PlayBox) -> None:
    pilot = play_box()
    assert pilot.app.actions.view().first_input_s is None
    pilot.key("w", True)
    assert pilot.app.actions.view().first_input_s == pytest.approx(pilot.app.now_s, abs=0.05)


def test_a_gamepad_that_comes_and_goes_is_said(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.app.actions.gamepad = lambda: GamepadState((0.0,) * len(AXES), (False,) * len(BUTTONS), "Pad 7")
    pilot.frames()
    pilot.app.actions.gamepad = lambda: None
    pilot.frames()
    said = [toast.text for toast in pilot.overlay.hud.toasts.visible(pilot.app.now_s)]
    assert said[-2:] == ["Gamepad connected: Pad 7", "Gamepad gone: Pad 7"]


def test_arrows_and_enter_walk_through_the_menu(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.frames(5)
    open_menu(pilot)
    for key in ("down", "enter"):
        pilot.press(key)
        pilot.frames(2)
    assert not pilot.overlay.shown.menu
    assert pilot.app.scene.entered == 2, "the second entry restarts"  # type: ignore[attr-defined]
    open_menu(pilot)
    pilot.press("enter")
    pilot.frames(2)
    assert not pilot.overlay.shown.menu
    assert pilot.app.scene.entered == 2, "the first entry only goes on"  # type: ignore[attr-defined]
