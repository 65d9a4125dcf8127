"""Every key, button and axis does one thing, everything can be done with either, and letting go stops it."""

from dataclasses import fields

import pytest

from game.inputs.keyboard import KEY_CODES
from game.inputs.puppet_controls import (
    AXIS_ORDER,
    BUTTON_ORDER,
    BUTTONS,
    GAMEPAD,
    KEYS,
    PuppetControls,
    controls_from_gamepad,
    controls_from_keys,
)  # fmt: skip
from game.shortcuts import SHORTCUTS

RELEASED = [0.0, 0.0, 0.0, 0.0, -1.0, -1.0]
CONTROLS = {control.name for control in fields(PuppetControls)}


def pad(*buttons: str, **axes: float) -> PuppetControls:
    values = [axes.get(name, rest) for name, rest in zip(AXIS_ORDER, RELEASED)]
    return controls_from_gamepad(values, [name in buttons for name in BUTTON_ORDER])


def test_every_control_has_a_key_and_a_place_on_the_gamepad():
    assert {key.control for key in KEYS} == CONTROLS
    assert {binding.control for binding in GAMEPAD} == CONTROLS


def test_no_key_has_two_meanings_and_none_is_a_shortcut_of_the_window():
    names = [key.name for key in KEYS]
    assert len(set(names)) == len(names)
    assert len({binding.name for binding in GAMEPAD}) == len(GAMEPAD)
    assert {name.lower() for name in names} <= set(KEY_CODES), "names as the keyboard gives them"
    assert not {name.lower() for name in names} & set(SHORTCUTS)
    assert all(binding.text for binding in KEYS + GAMEPAD)


@pytest.mark.parametrize("key", KEYS, ids=lambda key: key.name)
def test_a_key_moves_its_control_and_nothing_else(key):
    expected = PuppetControls()
    setattr(expected, key.control, key.value)
    assert controls_from_keys({key.name}) == expected
    assert controls_from_keys({key.name.lower(), "f5", "no such key"}) == expected


@pytest.mark.parametrize("button", BUTTONS, ids=lambda button: button.name)
def test_a_button_moves_its_control_and_nothing_else(button):
    expected = PuppetControls()
    setattr(expected, button.control, button.value)
    assert pad(button.name) == expected


def test_nothing_pressed_asks_for_nothing():
    assert controls_from_keys(set()) == controls_from_gamepad(RELEASED, []) == controls_from_gamepad([], []) == PuppetControls()


def test_opposite_keys_cancel():
    assert controls_from_keys({"UP", "DOWN", "LEFT", "RIGHT"}) == PuppetControls()


def test_sticks_lean_where_they_point_and_triggers_thrust():
    assert pad(left_y=-1.0).lean_forward == 1.0, "the stick pushed away, which GLFW calls -1"
    assert pad(left_y=1.0).lean_forward == -1.0
    assert pad(left_x=-1.0).lean_left == 1.0
    assert 0.3 < pad(left_x=0.5).lean_left * -1.0 < 0.5
    assert pad(right_trigger=1.0) == PuppetControls(thrust_right=1.0)
    assert 0.3 < pad(left_trigger=0.0).thrust_left < 0.5
    assert pad(right_y=1.0).crouch == 1.0
    assert pad(right_y=-1.0).crouch == 0.0, "a stick pushed up is no negative crouch"


def test_a_stick_at_rest_is_never_quite_at_zero_and_does_nothing():
    assert pad(left_x=0.1, left_y=-0.12, right_y=0.14, left_trigger=-0.8) == PuppetControls()


def test_two_ways_to_ask_do_not_add_up_to_more_than_all():
    assert pad("dpad_down", right_y=1.0).crouch == 1.0
