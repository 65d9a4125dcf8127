"""The motions a performer knows: the eight clips of thesis Table 1 and quiet standing."""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Final

from game.inputs.performance import balancing, bowing, boxing, jump, leaning, reaching, standing, stepping, waving
from game.inputs.performance.motion import Motion
from game.inputs.performance.script import Script

SCRIPTS: Final[Mapping[str, Callable[[], Script]]] = {
    "waving": waving.script,
    "leaning": leaning.script,
    "bowing": bowing.script,
    "reaching": reaching.script,
    "boxing": boxing.script,
    "stepping": stepping.script,
    "balancing": balancing.script,
    "jump": jump.script,
    "standing": standing.script,
}


@cache
def motion(name: str) -> Motion:
    """The motion of that name; ValueError names the valid ones."""
    if name not in SCRIPTS:
        raise ValueError(f"No motion is called {name!r}; a performer knows {', '.join(SCRIPTS)}.")
    return Motion(SCRIPTS[name]())
