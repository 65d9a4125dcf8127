"""The first gamepad that GLFW knows, as plain numbers."""

from dataclasses import dataclass

import glfw

AXES = ("left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger")
BUTTONS = (
    "a", "b", "x", "y", "left_bumper", "right_bumper", "back", "start", "guide", "left_thumb", "right_thumb",
    "dpad_up", "dpad_right", "dpad_down", "dpad_left",
)  # fmt: skip


@dataclass(frozen=True)
class GamepadState:
    """axes: `AXES` order, sticks -1..1 (x right, y down as GLFW gives them), triggers -1 released .. 1 pulled; buttons: `BUTTONS` order."""

    axes: tuple[float, ...]
    buttons: tuple[bool, ...]
    name: str = "gamepad"

    def held(self, button: str) -> bool:
        """Is the button of this name down?"""
        return self.buttons[BUTTONS.index(button)]


def read_gamepad() -> GamepadState | None:
    """The state of the first connected gamepad, or None. GLFW must be initialised."""
    for joystick in range(glfw.JOYSTICK_1, glfw.JOYSTICK_LAST + 1):
        if not glfw.joystick_present(joystick) or not glfw.joystick_is_gamepad(joystick):
            continue
        state = glfw.get_gamepad_state(joystick)
        if state is not None:
            name = glfw.get_gamepad_name(joystick)
            axes = tuple(float(state.axes[i]) for i in range(len(AXES)))
            buttons = tuple(bool(state.buttons[i]) for i in range(len(BUTTONS)))
            return GamepadState(axes, buttons, name.decode(errors="replace") if isinstance(name, bytes) else str(name))
    return None
