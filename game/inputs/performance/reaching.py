"""Reaching down with bent knees (thesis Table 1: full body controlled motion), as if to lift a box off the floor."""

from game.inputs.performance.curves import Curve, keys
from game.inputs.performance.script import STANDING, Script, both

LENGTH_S = 8.6
REACHES = ((0.9, 2.3, 2.9, 4.2), (4.4, 5.8, 6.4, 7.8))
"""(start, down, up again, straight) of each reach, seconds."""


def script() -> Script:
    return Script(
        LENGTH_S,
        {
            "pelvis.height": _reach(STANDING["pelvis.height"], 0.63),
            "pelvis.pitch": _reach(0.0, 31.0),
            "trunk.pitch": _reach(0.0, 49.0),
            "head.pitch": _reach(0.0, 30.0),
            **both("flex", _reach(STANDING["left.flex"], 72.0)),
            **both("side", _reach(STANDING["left.side"], 2.0)),
            **both("elbow", _reach(STANDING["left.elbow"], 8.0)),
            "zmp.x": _reach(0.0, 0.015),
        },
    )


def _reach(idle: float, down_there: float) -> Curve:
    return keys(*(pair for start, down, up, end in REACHES for pair in ((start, idle), (down, down_there), (up, down_there), (end, idle))))
