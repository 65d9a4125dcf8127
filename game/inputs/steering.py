"""Keys and gamepad to whatever they steer: the last of the two that was touched has it."""

import copy
from collections.abc import Callable, Set
from typing import Any, Protocol

from game.inputs.gamepad import GamepadState


class Steered(Protocol):
    """Something that does what its `controls` say, such as the puppet."""

    controls: Any


Controls = Any
"""What is steered: a Steered, a source around one (such as the sensor model around the puppet), a function that gives the present
one of either, since a restart may open a new puppet, or None."""


def present(controls: Controls) -> Steered | None:
    """The thing that is steered right now; None where keys steer nothing."""
    thing: Any = controls() if callable(controls) else controls
    while thing is not None and not hasattr(thing, "controls"):
        thing = getattr(thing, "source", None)
    return thing


class Steering:
    """Hands controls on only when they change, so that a script which steers the same puppet is left alone while nobody plays.

    from_keys takes the names of the keys held down; from_gamepad takes axes and buttons as in `game.inputs.gamepad`.
    """

    def __init__(self, from_keys: Callable[[Set[str]], Any], from_gamepad: Callable[[tuple[float, ...], tuple[bool, ...]], Any]) -> None:
        self._from_keys, self._from_gamepad = from_keys, from_gamepad
        self._idle = from_keys(frozenset())
        self._keys = self._idle
        self._pad = self._idle
        self._steered: Steered | None = None
        self.touched = False

    def start_over(self) -> None:
        """The scene began anew: hand what is still held down to whatever is steered next."""
        self._steered = None

    def route(self, steered: Steered | None, pressed: Set[str], gamepad: GamepadState | None) -> bool:
        """Once per picture frame; True where somebody steered in this one. `touched` says whether anybody ever has."""
        keys = self._from_keys(pressed)
        pad = self._idle if gamepad is None else self._from_gamepad(gamepad.axes, gamepad.buttons)
        changed = keys if keys != self._keys else pad if pad != self._pad else None
        self._keys, self._pad = keys, pad
        if changed is None and steered is not self._steered and self.touched:
            changed = self._idle  # a new puppet knows nothing of what is still held down
        self._steered = steered
        if changed is None:
            return False
        if changed == self._idle:  # one of the two was let go: the other may still be held
            changed = keys if keys != self._idle else pad
        if steered is not None:
            steered.controls = copy.copy(changed)
        self.touched = True
        return changed != self._idle
