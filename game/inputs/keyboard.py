"""Which keys are down, by name, from GLFW's key events."""

import glfw

KEY_NAMES: dict[int, str] = {
    code: name[4:].lower() for name, code in vars(glfw).items() if name.startswith("KEY_") and isinstance(code, int) and code > 0
}
KEY_NAMES.pop(glfw.KEY_LAST, None)
KEY_NAMES[glfw.KEY_MENU] = "menu"
"""GLFW key code -> name: a, 1, space, left_shift, up, f1, kp_4 ..."""

KEY_CODES: dict[str, int] = {name: code for code, name in KEY_NAMES.items()}


class Keyboard:
    """The set of keys held down and the presses since last asked. Feed it every GLFW key event."""

    def __init__(self) -> None:
        self.pressed: set[str] = set()
        self._fresh: list[str] = []

    def event(self, key: int, action: int, typing: bool = False) -> None:
        """One key event; while a text field has the keys (`typing`) presses are not ours, releases always are."""
        name = KEY_NAMES.get(key)
        if name is None:
            return
        if action == glfw.RELEASE:
            self.pressed.discard(name)
        elif action == glfw.PRESS and not typing:
            self.pressed.add(name)
            self._fresh.append(name)

    def take_presses(self) -> list[str]:
        """Keys pressed since the last call, oldest first."""
        fresh, self._fresh = self._fresh, []
        return fresh

    def release_all(self) -> None:
        """Let go of everything: the window lost the keyboard, so no release events will come."""
        self.pressed.clear()
