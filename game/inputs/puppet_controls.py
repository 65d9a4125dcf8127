"""What a player asks of the puppet, and which key, stick and button asks for it."""

from collections.abc import Sequence, Set
from dataclasses import dataclass
from typing import Final


@dataclass
class PuppetControls:
    """Everything the puppet can be asked to do at one moment; the person's own left and right.

    lean_forward, lean_left: -1..1, negative is back and right. crouch, raise_*, thrust_*: 0..1. The switches act while
    held: steps and kicks repeat, both steps together march; a jump starts once both feet stand.
    """

    lean_forward: float = 0.0
    lean_left: float = 0.0
    crouch: float = 0.0
    raise_left: float = 0.0
    raise_right: float = 0.0
    thrust_left: float = 0.0
    thrust_right: float = 0.0
    guard: bool = False
    wave: bool = False
    step_left: bool = False
    step_right: bool = False
    kick_left: bool = False
    kick_right: bool = False
    jump: bool = False


@dataclass(frozen=True)
class Binding:
    """One key, button or axis: its name, the field of `PuppetControls` it moves, to which value, and words for the player."""

    name: str
    control: str
    text: str
    value: float | bool = 1.0


KEYS: Final[tuple[Binding, ...]] = (
    Binding("UP", "lean_forward", "lean forward"),
    Binding("DOWN", "lean_forward", "lean back", -1.0),
    Binding("LEFT", "lean_left", "lean left"),
    Binding("RIGHT", "lean_left", "lean right", -1.0),
    Binding("A", "thrust_left", "thrust the left fist"),
    Binding("D", "thrust_right", "thrust the right fist"),
    Binding("Q", "raise_left", "raise the left arm"),
    Binding("E", "raise_right", "raise the right arm"),
    Binding("W", "wave", "wave", True),
    Binding("F", "guard", "guard", True),
    Binding("S", "crouch", "crouch"),
    Binding("Z", "step_left", "step with the left foot", True),
    Binding("X", "step_right", "step with the right foot", True),
    Binding("C", "kick_left", "kick with the left foot", True),
    Binding("V", "kick_right", "kick with the right foot", True),
    Binding("SPACE", "jump", "jump", True),
)
"""Keyboard: names as in GLFW without its prefix; the keys of a field that pull both ways cancel."""

AXES: Final[tuple[Binding, ...]] = (
    Binding("left_x", "lean_left", "lean left and right", -1.0),
    Binding("left_y", "lean_forward", "lean forward and back", -1.0),
    Binding("right_y", "crouch", "crouch (pull down)"),
    Binding("left_trigger", "thrust_left", "thrust the left fist"),
    Binding("right_trigger", "thrust_right", "thrust the right fist"),
)
"""Gamepad axes; the value is the factor from axis to control. Sticks run -1..1 (y down), triggers -1..1 (-1 released)."""

BUTTONS: Final[tuple[Binding, ...]] = (
    Binding("a", "jump", "jump", True),
    Binding("b", "guard", "guard", True),
    Binding("x", "kick_left", "kick with the left foot", True),
    Binding("y", "kick_right", "kick with the right foot", True),
    Binding("left_bumper", "raise_left", "raise the left arm"),
    Binding("right_bumper", "raise_right", "raise the right arm"),
    Binding("dpad_left", "step_left", "step with the left foot", True),
    Binding("dpad_right", "step_right", "step with the right foot", True),
    Binding("dpad_up", "wave", "wave", True),
    Binding("dpad_down", "crouch", "crouch"),
)

GAMEPAD: Final[tuple[Binding, ...]] = AXES + BUTTONS

AXIS_ORDER: Final = ("left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger")
BUTTON_ORDER: Final = (
    "a", "b", "x", "y", "left_bumper", "right_bumper", "back", "start", "guide", "left_thumb", "right_thumb",
    "dpad_up", "dpad_right", "dpad_down", "dpad_left",
)  # fmt: skip
"""The order in which GLFW's gamepad state lists axes and buttons."""

_DEAD_ZONE: Final = 0.15
_LOWEST: Final = {"lean_forward": -1.0, "lean_left": -1.0}


def controls_from_keys(pressed: Set[str]) -> PuppetControls:
    """The controls for the set of keys held down (names in any case); unknown keys do nothing."""
    names = {name.upper() for name in pressed}
    return _controls([(key.control, key.value) for key in KEYS if key.name in names])


def controls_from_gamepad(axes: Sequence[float], buttons: Sequence[bool]) -> PuppetControls:
    """The controls for a gamepad's axes (`AXIS_ORDER`) and buttons (`BUTTON_ORDER`); shorter lists read as untouched."""
    by_axis = dict(zip(AXIS_ORDER, axes, strict=False))
    held = {name for name, down in zip(BUTTON_ORDER, buttons, strict=False) if down}
    asked: list[tuple[str, float | bool]] = []
    for axis in AXES:
        if axis.name in by_axis:
            asked.append((axis.control, axis.value * _deflection(axis.name, by_axis[axis.name])))
    asked += [(button.control, button.value) for button in BUTTONS if button.name in held]
    return _controls(asked)


def _deflection(name: str, value: float) -> float:
    """Stick or trigger without its dead zone, scaled so that it starts at 0 where the dead zone ends."""
    pull = 0.5 * (value + 1.0) if name.endswith("trigger") else value
    size = max(0.0, abs(pull) - _DEAD_ZONE) / (1.0 - _DEAD_ZONE)
    return min(size, 1.0) if pull > 0.0 else -min(size, 1.0)


def _controls(asked: list[tuple[str, float | bool]]) -> PuppetControls:
    controls = PuppetControls()
    for name, value in asked:
        if isinstance(value, bool):
            setattr(controls, name, value)
        else:
            total = getattr(controls, name) + value
            setattr(controls, name, min(1.0, max(_LOWEST.get(name, 0.0), total)))
    return controls
