"""What the player asks for and what becomes of it: shortcuts, overlay requests, dropped files, steering."""

from __future__ import annotations

import datetime
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from game import settings_file
from game.inputs.gamepad import GamepadState, read_gamepad
from game.inputs.steering import Controls, Steering, present
from game.presets import apply_preset
from game.scenes.scene import Scene
from game.shortcuts import SHORTCUTS
from game.tunables import TUNABLES, Value

if TYPE_CHECKING:
    from game.app import App
    from game.overlay.view import Shown, View


@dataclass(frozen=True)
class Staged:
    """A scene that is to replace the one being played, what keys and gamepad steer in it, and the spec of its input."""

    scene: Scene
    controls: Controls = None
    input_spec: str = ""


class Actions:
    """Obeys the player. One per App; `paused`, `quit` and the steering state live here."""

    def __init__(self, app: App, steering: Steering, gamepad: Callable[[], GamepadState | None] = read_gamepad) -> None:
        self._app = app
        self.gamepad = gamepad
        self.steering = steering
        self.input_spec = app.options.input_spec
        self.first_input_s: float | None = None
        self.quit = False
        self._paused = False
        self._advances = 0
        self._last_s = 0.0
        self._screenshot_due = False
        self._start_held = False
        self._gamepad_name = ""
        self._at_start = _restart_values(app)

    @property
    def paused(self) -> bool:
        """No fixed updates run: the player paused, the menu is open, or the sensor was unplugged."""
        shown = self._shown
        return self._paused or (shown is not None and shown.menu) or self.interrupted != ""

    @property
    def interrupted(self) -> str:
        """Why the game waits for the player's sensor, in words; empty while it does not, as in a run that nobody watches."""
        return "" if self._app.options.headless else getattr(self._app.scene, "interrupted", "")

    @property
    def restart_pending(self) -> bool:
        """A tunable that takes effect at restart has been turned since the scene began."""
        return self._at_start != _restart_values(self._app)

    @property
    def _shown(self) -> Shown | None:
        overlay = self._app.picture.overlay
        return None if overlay is None else overlay.shown

    def take_advances(self) -> int:
        """Single updates asked for while paused, since the last call."""
        taken, self._advances = self._advances, 0
        return taken

    def frame_s(self, now_s: float) -> float:
        """Seconds since the last call, for what moves by the loop's own time."""
        passed, self._last_s = now_s - self._last_s, now_s
        return max(0.0, min(0.1, passed))

    def obey(self) -> None:
        """Carry out everything asked since the last frame, then hand keys and gamepad to what they steer."""
        events = self._app.picture.events
        if events is None:
            return
        for key in events.keyboard.take_presses():
            if key in SHORTCUTS:
                self.do(SHORTCUTS[key].action)
        for request in self._shown.take_requests() if self._shown is not None else []:
            self.do(request.kind, request.value)
        for path in events.take_drops():
            self.do("input", f"clip:{path}")
        gamepad = self.gamepad()
        self._greet(gamepad)
        self._start_button(gamepad)
        pressed = frozenset() if self.paused else frozenset(events.keyboard.pressed)
        if self.steering.route(present(self._app.controls), pressed, None if self.paused else gamepad) and self.first_input_s is None:
            self.first_input_s = self._app.now_s

    def do(self, action: str, value: str = "") -> None:
        """One action of `game.shortcuts`, or scene, input, preset, save, load, reset all, say, quit. What fails is said to the player."""
        word, _, rest = action.partition(" ")
        simple = {
            "pause": self._toggle_pause, "restart": self.restart, "quit": self._quit, "save": self._save, "load": self._load,
            "menu": self._menu, "advance": self._advance, "screenshot": self._screenshot, "fullscreen": self._fullscreen,
        }  # fmt: skip
        try:
            if word in simple:
                simple[word]()
            elif word in ("panel", "plots", "help", "hud"):
                self._flip(word)
            elif word == "toggle":
                self._app.settings.set(rest, not self._app.settings.switch(rest))
                self.say(f"{TUNABLES[rest].meaning}: {'on' if self._app.settings.switch(rest) else 'off'}")
            elif word == "camera":
                self._camera(int(rest))
            elif word == "preset":
                apply_preset(self._app.settings, value)
                self.say(f"Preset {value}")
            elif word == "reset":
                self._app.settings.reset()
                self.say("Every tunable is back at its default")
            elif word == "say":
                self.say(value)
            elif word in ("scene", "input"):
                self._stage(word, value)
        except (ValueError, OSError) as error:
            self.say(str(error))

    def say(self, text: str) -> None:
        """Show the player a sentence."""
        if self._app.picture.overlay is not None:
            self._app.picture.overlay.hud.toasts.add(text, self._app.now_s)

    def restart(self) -> None:
        """The scene from its beginning, with the settings as they are now."""
        self._app.scene.enter()
        self._at_start = _restart_values(self._app)
        self._paused = False
        self.steering.start_over()

    def _stage(self, kind: str, value: str) -> None:
        if self._app.on_request is None:
            return
        staged = self._app.on_request(kind, value)
        if staged is None:
            return
        self._app.scene.leave()
        self._app.scene, self._app.controls = staged.scene, staged.controls
        self.input_spec = staged.input_spec or (value if kind == "input" else self.input_spec)
        self.restart()
        self._app.picture.cut(staged.scene)

    def _greet(self, gamepad: GamepadState | None) -> None:
        name = "" if gamepad is None else gamepad.name
        if name != self._gamepad_name:
            self.say(f"Gamepad connected: {name}" if name else f"Gamepad gone: {self._gamepad_name}")
            self._gamepad_name = name

    def _start_button(self, gamepad: GamepadState | None) -> None:
        held = gamepad is not None and gamepad.held("start")
        if held and not self._start_held:
            self.do("menu")
        self._start_held = held

    def _toggle_pause(self) -> None:
        self._paused = not self._paused

    def _quit(self) -> None:
        self.quit = True

    def _advance(self) -> None:
        self._advances += 1 if self._paused else 0

    def _menu(self) -> None:
        shown = self._shown
        if shown is None:
            self._quit()
        elif shown.help:
            shown.help = False
        else:
            shown.menu = not shown.menu

    def _flip(self, part: str) -> None:
        if self._shown is not None:
            setattr(self._shown, part, not getattr(self._shown, part))

    def _fullscreen(self) -> None:
        if self._app.picture.events is not None:
            self._app.picture.events.toggle_fullscreen()

    def _camera(self, number: int) -> None:
        cameras = self._app.scene.cameras()
        if number <= len(cameras):
            name = list(cameras)[number - 1]
            self._app.picture.camera.go_to(cameras[name], 0.6)
            self.say(f"Camera: {name}")

    def _screenshot(self) -> None:
        stamp = datetime.datetime.now().strftime("%Y%m%d-%H%M%S-%f")[:-3]
        path = self._app.options.output_dir / f"topple-{stamp}.png"
        self._app.output.screenshot(path)
        self.say(f"Screenshot: {path}")

    def _save(self) -> None:
        self.say(settings_file.save(self._app.settings, self._path))

    def _load(self) -> None:
        complaints = settings_file.load(self._app.settings, self._path)
        found = f"Loaded {self._path}" if self._path.exists() else f"Nothing is saved yet at {self._path}"
        for sentence in complaints or (found,):
            self.say(sentence)

    @property
    def _path(self) -> settings_file.Path:
        return self._app.options.settings_path or settings_file.default_path()

    def view(self) -> View:
        """What the overlay shows this frame."""
        from game.view_of_scene import view_of_scene

        return view_of_scene(self._app)


def _restart_values(app: App) -> tuple[Value, ...]:
    return tuple(app.settings.get(name) for name, t in TUNABLES.items() if t.restart)
