"""A player made of events: moves the mouse and presses keys through the same callbacks that GLFW calls."""

import glfw
from imgui_bundle import imgui

from game.app import App
from game.inputs.keyboard import KEY_CODES
from game.overlay.tunable_widget import Place
from game.overlay.ui import Overlay

BACKEND = imgui.backends


class Pilot:
    """Plays one App, frame by frame."""

    def __init__(self, app: App) -> None:
        assert app.picture.overlay is not None
        self.app = app
        self.overlay: Overlay = app.picture.overlay
        BACKEND.glfw_window_focus_callback(self.overlay.address, 1)
        BACKEND.glfw_cursor_enter_callback(self.overlay.address, 1)
        self.frames(2)

    def frames(self, count: int = 1) -> None:
        for _ in range(count):
            self.app.frame()

    def move(self, x: float, y: float) -> None:
        BACKEND.glfw_cursor_pos_callback(self.overlay.address, x, y)
        self.frames()

    def button(self, down: bool, button: int = glfw.MOUSE_BUTTON_LEFT) -> None:
        BACKEND.glfw_mouse_button_callback(self.overlay.address, button, glfw.PRESS if down else glfw.RELEASE, 0)
        self.frames()

    def click(self, place: Place, button: int = glfw.MOUSE_BUTTON_LEFT) -> None:
        self.move((place.left + place.right) / 2, (place.top + place.bottom) / 2)
        self.button(True, button)
        self.button(False, button)
        self.frames()

    def ctrl_click(self, place: Place) -> None:
        """Ctrl is the one key that Dear ImGui's back end polls from the window, where no synthetic event can hold it: so it is told."""
        self.move((place.left + place.right) / 2, (place.top + place.bottom) / 2)
        io = imgui.get_io()
        io.add_key_event(imgui.Key.mod_ctrl, True)
        io.add_mouse_button_event(0, True)
        self.frames(2)
        io.add_mouse_button_event(0, False)
        io.add_key_event(imgui.Key.mod_ctrl, False)
        self.frames(2)

    def drag(self, start: tuple[float, float], end: tuple[float, float], button: int = glfw.MOUSE_BUTTON_LEFT) -> None:
        self.move(*start)
        self.button(True, button)
        for part in (0.25, 0.5, 0.75, 1.0):
            self.move(start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1]))
        self.button(False, button)

    def wheel(self, notches: float) -> None:
        BACKEND.glfw_scroll_callback(self.overlay.address, 0.0, notches)
        self.frames(2)

    def key(self, name: str, down: bool) -> None:
        code = KEY_CODES[name]
        BACKEND.glfw_key_callback(self.overlay.address, code, 0, glfw.PRESS if down else glfw.RELEASE, 0)
        self.frames()

    def press(self, name: str) -> None:
        self.key(name, True)
        self.key(name, False)

    def type(self, text: str) -> None:
        for character in text:
            BACKEND.glfw_char_callback(self.overlay.address, ord(character))
            self.frames()

    def show(self, tunable: str) -> Place:
        """Where a tunable's control is, filtered into sight as a player would."""
        self.overlay.shown.panel = True
        self.overlay.shown.filter = tunable
        self.frames(3)
        return self.overlay.panel.places[tunable]
