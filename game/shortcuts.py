"""The keys of the window itself, whatever the scene: one table for the loop that obeys them and the help that shows them."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from game.tunables import TUNABLES


@dataclass(frozen=True)
class Shortcut:
    """key: as in `game.inputs.keyboard`; shown: on the key cap; meaning: for the player; action: what the loop is asked to do."""

    key: str
    shown: str
    meaning: str
    action: str


def _layer_shortcuts() -> list[Shortcut]:
    layers = [name for name, t in TUNABLES.items() if t.group == "layer"]
    keys = ("f2", "f3", "f4", "f5", "f6", "f7", "f10", "g")
    words = [name.split(".", 1)[1].replace("_", " ") for name in layers]
    return [Shortcut(key, key.upper(), f"layer: {word}", f"toggle {name}") for key, word, name in zip(keys, words, layers)]


_TABLE: Final = (
    Shortcut("escape", "Esc", "menu", "menu"),
    Shortcut("f1", "F1", "keys and shortcuts", "help"),
    Shortcut("tab", "Tab", "tune every number", "panel"),
    Shortcut("p", "P", "pause", "pause"),
    Shortcut("period", ".", "one frame on, while paused", "advance"),
    Shortcut("r", "R", "restart", "restart"),
    *_layer_shortcuts(),
    Shortcut("f8", "F8", "plots and frame times", "plots"),
    Shortcut("f9", "F9", "hide or show this writing", "hud"),
    Shortcut("f11", "F11", "full screen", "fullscreen"),
    Shortcut("f12", "F12", "screenshot", "screenshot"),
    *(Shortcut(str(n), str(n), f"camera {n}", f"camera {n}") for n in range(1, 10)),
)

SHORTCUTS: Final[Mapping[str, Shortcut]] = {s.key: s for s in _TABLE}
"""By key name."""

MOUSE_HELP: Final = (
    ("drag", "orbit the camera"),
    ("right drag", "pan"),
    ("wheel", "zoom"),
    ("drop a file", "play a recording"),
)
