"""Leaning from side to side (thesis Table 1: slow COM shift): the trunk bends, the hips give way to the other side."""

from game.inputs.performance.curves import Curve, keys
from game.inputs.performance.script import Script

LENGTH_S = 32.0
LEAN_S, HOLD_S = 1.85, 0.85
FIRST_S = 1.0
SWAYS = 5


def script() -> Script:
    return Script(
        LENGTH_S,
        {
            "trunk.roll": _sway(31.0),
            "pelvis.roll": _sway(6.0),
            "head.roll": _sway(20.0),
            "zmp.y": _sway(-0.050),
            "left.side": keys(*_arm(1.0)),
            "right.side": keys(*_arm(-1.0)),
            "pelvis.height": keys((0.9, 0.968), (2.0, 0.94), (29.2, 0.94), (30.7, 0.968)),
        },
    )


def _times() -> list[tuple[float, float]]:
    """(time, direction) keys: right, left, right ... each reached in LEAN_S or a little more and held for HOLD_S."""
    points, t = [(FIRST_S, 0.0)], FIRST_S
    for index in range(2 * SWAYS):
        direction = 1.0 if index % 2 == 0 else -1.0
        t += LEAN_S if index == 0 else 1.05 * LEAN_S
        points.append((t, direction))
        points.append((t + HOLD_S, direction))
        t += HOLD_S
    points.append((t + LEAN_S, 0.0))
    return points


def _sway(amplitude: float) -> Curve:
    return keys(*((t, amplitude * direction) for t, direction in _times()))


def _arm(sign: float) -> list[tuple[float, float]]:
    """The arm on the leaning side hangs away from the body, the other slides along it."""
    return [(t, 6.0 + 22.0 * max(0.0, -sign * direction) + 8.0 * max(0.0, sign * direction)) for t, direction in _times()]
