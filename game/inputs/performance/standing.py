"""Quiet standing: arms hang, weight above the middle of the feet, a slow sway of a few millimetres."""

from game.inputs.performance.curves import swing
from game.inputs.performance.script import Script

LENGTH_S = 10.0


def script() -> Script:
    return Script(
        LENGTH_S,
        {
            "zmp.x": swing(0.8, 9.2, 0.004, 0.31, 1.5),
            "zmp.y": swing(0.8, 9.2, 0.003, 0.23, 1.5),
        },
    )
