"""Keys and gamepad: whoever touches last steers, and nobody disturbs a script."""

import glfw

from game.inputs.gamepad import AXES, BUTTONS, GamepadState
from game.inputs.keyboard import KEY_CODES, KEY_NAMES, Keyboard
from game.inputs.open_input import open_input
from game.inputs.puppet_controls import AXIS_ORDER, BUTTON_ORDER, KEYS, PuppetControls, controls_from_gamepad, controls_from_keys
from game.inputs.steering import Steering, present
from game.shortcuts import SHORTCUTS
from kinect.body import Joint


class Doll:
    def __init__(self) -> None:
        self.controls = PuppetControls()


def pad(**axes: float) -> GamepadState:
    rest = {name: -1.0 if name.endswith("trigger") else 0.0 for name in AXES}
    return GamepadState(tuple({**rest, **axes}.values()), (False,) * len(BUTTONS))


def test_nobody_at_the_keys_leaves_a_scripted_puppet_alone() -> None:
    steering, doll = Steering(controls_from_keys, controls_from_gamepad), Doll()
    doll.controls.lean_forward = 0.7
    for _ in range(3):
        assert not steering.route(doll, frozenset(), pad())
    assert doll.controls.lean_forward == 0.7
    assert not steering.touched


def test_letting_go_of_the_stick_gives_the_held_keys_their_due() -> None:
    steering, doll = Steering(controls_from_keys, controls_from_gamepad), Doll()
    steering.route(doll, {"space"}, pad())
    assert doll.controls.jump
    steering.route(doll, {"space"}, pad(left_y=-1.0))
    assert doll.controls.lean_forward == 1.0
    steering.route(doll, {"space"}, pad())
    assert doll.controls.jump
    steering.route(doll, frozenset(), pad())
    assert doll.controls == PuppetControls()


def test_every_puppet_key_is_a_key_of_the_keyboard_and_none_is_a_shortcut() -> None:
    names = {key.name.lower() for key in KEYS}
    assert names <= set(KEY_CODES)
    assert not names & set(SHORTCUTS)


def test_every_shortcut_is_a_key_of_the_keyboard() -> None:
    assert set(SHORTCUTS) <= set(KEY_CODES)


def test_gamepad_state_is_in_the_order_the_puppet_reads() -> None:
    assert AXES == AXIS_ORDER
    assert BUTTONS == BUTTON_ORDER
    assert len(AXES) == glfw.GAMEPAD_AXIS_LAST + 1
    assert len(BUTTONS) == glfw.GAMEPAD_BUTTON_LAST + 1


def test_key_names_and_codes_are_one_to_one() -> None:
    assert len(KEY_CODES) == len(KEY_NAMES)
    assert KEY_NAMES[glfw.KEY_LEFT_SHIFT] == "left_shift"


def test_a_press_while_typing_is_not_a_game_key_but_its_release_always_counts() -> None:
    keyboard = Keyboard()
    keyboard.event(glfw.KEY_W, glfw.PRESS)
    keyboard.event(glfw.KEY_E, glfw.PRESS, typing=True)
    assert keyboard.pressed == {"w"}
    keyboard.event(glfw.KEY_W, glfw.RELEASE, typing=True)
    assert keyboard.pressed == set()
    assert keyboard.take_presses() == ["w"]
    assert keyboard.take_presses() == []
    keyboard.event(-1, glfw.PRESS)
    assert keyboard.pressed == set()


def test_a_puppet_that_a_restart_opened_anew_does_what_is_still_held() -> None:
    steering, first, second = Steering(controls_from_keys, controls_from_gamepad), Doll(), Doll()
    steering.route(present(lambda: first), {"space"}, None)
    steering.route(present(lambda: second), {"space"}, None)
    assert second.controls.jump
    assert present(second) is second
    assert present(None) is None


def test_keys_reach_the_puppet_through_the_sensor_model_and_never_a_recording() -> None:
    source = open_input("puppet")
    steering = Steering(controls_from_keys, controls_from_gamepad)
    steering.route(present(lambda: source), {"q"}, None)
    before = source.poll(0.5)[-1].positions[Joint.WRIST_LEFT, 1]
    assert source.poll(2.0)[-1].positions[Joint.WRIST_LEFT, 1] > before + 0.2, "the left wrist rises"
    assert present(open_input("performer:waving")) is None
