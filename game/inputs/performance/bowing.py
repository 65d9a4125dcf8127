"""Bowing down (thesis Table 1: sudden COM shift): the trunk goes forward, the hips go back to keep the weight over the feet."""

from game.inputs.performance.curves import Curve, keys
from game.inputs.performance.script import STANDING, Script, both

LENGTH_S = 9.2
BOWS = ((1.0, 2.2, 3.0, 4.3), (4.8, 5.9, 6.8, 8.2))
"""(start, down, up again, straight) of each bow, seconds."""


def script() -> Script:
    return Script(
        LENGTH_S,
        {
            "trunk.pitch": _bow(0.0, 70.0),
            "pelvis.pitch": _bow(0.0, 46.0),
            "head.pitch": _bow(0.0, 72.0),
            "pelvis.height": _bow(STANDING["pelvis.height"], 0.915),
            **both("flex", _bow(STANDING["left.flex"], 52.0)),
            **both("side", _bow(STANDING["left.side"], 4.0)),
            "zmp.x": _bow(0.0, 0.015),
        },
    )


def _bow(idle: float, bent: float) -> Curve:
    return keys(*(pair for start, down, up, end in BOWS for pair in ((start, idle), (down, bent), (up, bent), (end, idle))))
