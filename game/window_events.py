"""What happens at the window between two frames: keys, mouse, dropped files. Other code only reads it."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import glfw

from game.inputs.keyboard import Keyboard


@dataclass
class Mouse:
    """Movement since last asked, in screen units: orbit with the left button, pan with the right or middle one, wheel notches."""

    position: tuple[float, float] = (0.0, 0.0)
    orbit: tuple[float, float] = (0.0, 0.0)
    pan: tuple[float, float] = (0.0, 0.0)
    wheel: float = 0.0
    held: set[int] = field(default_factory=set)

    def take(self) -> tuple[tuple[float, float], tuple[float, float], float]:
        """(orbit, pan, wheel) since the last call."""
        taken = self.orbit, self.pan, self.wheel
        self.orbit, self.pan, self.wheel = (0.0, 0.0), (0.0, 0.0), 0.0
        return taken


class WindowEvents:
    """Listens to one GLFW window. `mouse_taken` and `typing` say whether the overlay wants the mouse or the keys just now."""

    def __init__(self, handle: Any) -> None:
        self.keyboard = Keyboard()
        self.mouse = Mouse()
        self.dropped: list[str] = []
        self.mouse_taken: Callable[[], bool] = lambda: False
        self.typing: Callable[[], bool] = lambda: False
        self._windowed: tuple[int, int, int, int] | None = None
        self._handle = handle
        glfw.set_key_callback(handle, self._on_key)
        glfw.set_cursor_pos_callback(handle, self._on_move)
        glfw.set_mouse_button_callback(handle, self._on_button)
        glfw.set_scroll_callback(handle, self._on_scroll)
        glfw.set_drop_callback(handle, self._on_drop)  # type: ignore[arg-type]  # pyGLFW hands over (window, paths)
        glfw.set_window_focus_callback(handle, self._on_focus)

    def take_drops(self) -> list[str]:
        """Paths dropped onto the window since the last call."""
        taken, self.dropped = self.dropped, []
        return taken

    def toggle_fullscreen(self) -> None:
        """Between a window and the whole of the screen it is on."""
        if self._windowed is not None:
            x, y, width, height = self._windowed
            no_monitor: Any = None
            glfw.set_window_monitor(self._handle, no_monitor, x, y, width, height, 0)
            self._windowed = None
            return
        monitor = glfw.get_primary_monitor()
        mode = glfw.get_video_mode(monitor) if monitor else None
        if mode is None:
            return
        self._windowed = (*glfw.get_window_pos(self._handle), *glfw.get_window_size(self._handle))
        glfw.set_window_monitor(self._handle, monitor, 0, 0, mode.size.width, mode.size.height, mode.refresh_rate)

    def _on_key(self, _window: Any, key: int, _scancode: int, action: int, _mods: int) -> None:
        self.keyboard.event(key, action, self.typing())

    def _on_move(self, _window: Any, x: float, y: float) -> None:
        dx, dy = x - self.mouse.position[0], y - self.mouse.position[1]
        self.mouse.position = (x, y)
        if glfw.MOUSE_BUTTON_LEFT in self.mouse.held:
            self.mouse.orbit = (self.mouse.orbit[0] + dx, self.mouse.orbit[1] + dy)
        elif self.mouse.held:
            self.mouse.pan = (self.mouse.pan[0] + dx, self.mouse.pan[1] + dy)

    def _on_button(self, _window: Any, button: int, action: int, _mods: int) -> None:
        if action == glfw.RELEASE:
            self.mouse.held.discard(button)
        elif not self.mouse_taken():
            self.mouse.held.add(button)

    def _on_scroll(self, _window: Any, _dx: float, dy: float) -> None:
        if not self.mouse_taken():
            self.mouse.wheel += dy

    def _on_drop(self, _window: Any, paths: list[str]) -> None:
        self.dropped.extend(str(path) for path in paths)

    def _on_focus(self, _window: Any, focused: int) -> None:
        if not focused:
            self.keyboard.release_all()
            self.mouse.held.clear()
