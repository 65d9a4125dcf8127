"""Compiles what is compiled before the first play: `python -m game.warm_up` plays a little of everything without a picture."""

import sys
from functools import cache
from typing import Any

from numba.core import event

from game.commands.casting import Casting
from game.tunables import Settings
from game.undrawn import run_undrawn

WARM_UP_S = 0.2
"""Simulated seconds after the hang; by then every loop of the method has run."""

PLAYS: tuple[tuple[str, str, dict[str, str], float], ...] = (
    ("mirror", "performer:standing", {}, WARM_UP_S),
    ("mirror", "performer:stepping", {}, 2.5),
    ("mirror", "performer:jump", {"whole_body.strength": "0.4"}, 4.6),
    ("duel", "script", {}, WARM_UP_S),
    (
        "mirror",
        "performer:standing",
        {"balance.strategy": "ankle", "ik.method": "sdls", "pd.ratio": "manual", "sensor.noise": "1"},
        WARM_UP_S,
    ),
    (
        "mirror",
        "performer:standing",
        {"balance.strategy": "none", "ik.method": "pseudoinverse", "pd.gravity_feedforward": "off"},
        WARM_UP_S,
    ),
)
"""Scene, input, settings and simulated seconds that together call every compiled loop: the weak jumper falls and tries to get up."""


class TellOnce(event.Listener):
    """Says on stderr that something is being compiled, before the first of it: nothing that is loaded from the cache counts."""

    def __init__(self) -> None:
        self._told = False

    def on_start(self, event: Any) -> None:
        if not self._told:
            self._told = True
            print("topple: compiling the loops of control and physics (some seconds, once)", file=sys.stderr, flush=True)

    def on_end(self, event: Any) -> None:
        pass


@cache
def tell_of_compiling() -> None:
    """From now on the first thing that has to be compiled is announced in one line on stderr; a second call changes nothing."""
    event.register("numba:compile", TellOnce())


def warm_up() -> None:
    """Play each of PLAYS for a moment; what they compile stays in the cache beside the modules, or in the user's cache folder."""
    for name, spec, values, seconds in PLAYS:
        run_undrawn(Casting(spec, "original", Settings(values), 0).scene(name), seconds)


if __name__ == "__main__":
    tell_of_compiling()
    warm_up()
