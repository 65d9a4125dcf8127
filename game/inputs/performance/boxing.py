"""Boxing on the spot (thesis Table 1: energetic full body motion): guard, then seven times jab and cross."""

from game.inputs.performance.curves import Curve, ease
from game.inputs.performance.script import STANDING, Script, Side
from kinect.body import Floats

LENGTH_S = 15.6
GUARD = (0.8, 1.7, 13.8, 14.8)
"""Fists rise between the first two times and fall between the last two, seconds."""
COMBINATION: tuple[tuple[float, Side], ...] = ((0.0, "left"), (0.72, "right"))
PUNCHES: tuple[tuple[float, Side], ...] = tuple((2.1 + 1.62 * times + after, side) for times in range(7) for after, side in COMBINATION)
OUT_S, HELD_S, BACK_S = 0.205, 0.045, 0.35
GUARD_ARM = {"flex": 30.0, "side": 10.0, "twist": -20.0, "elbow": 130.0}
PUNCH_ARM = {"flex": 84.0, "side": 0.0, "twist": -24.0, "elbow": 15.0}
TWIST_DEG = 15.0
SHIFT_M = 0.020
"""The weight goes over to the foot across from the fist."""


def script() -> Script:
    arms = {f"{side}.{turn}": _arm(side, turn) for side in ("left", "right") for turn in GUARD_ARM}
    return Script(
        LENGTH_S,
        {
            **arms,
            "trunk.yaw": _twist(TWIST_DEG),
            "pelvis.yaw": _twist(0.4 * TWIST_DEG),
            "pelvis.height": lambda t: STANDING["pelvis.height"] - 0.035 * _guard(t),
            "trunk.pitch": lambda t: 6.0 * _guard(t),
            "zmp.x": lambda t: 0.012 * _guard(t),
            "zmp.y": _twist(SHIFT_M),
        },
    )


def _guard(t: Floats) -> Floats:
    """0 with the arms hanging, 1 with the fists up."""
    return ease(t, GUARD[0], GUARD[1]) - ease(t, GUARD[2], GUARD[3])


def _out(t: Floats, start: float) -> Floats:
    """0 in the guard, 1 with the fist out."""
    return ease(t, start, start + OUT_S) - ease(t, start + OUT_S + HELD_S, start + OUT_S + HELD_S + BACK_S)


def _arm(side: str, turn: str) -> Curve:
    idle, guard, punch = STANDING[f"{side}.{turn}"], GUARD_ARM[turn], PUNCH_ARM[turn]

    def curve(t: Floats) -> Floats:
        value = idle + (guard - idle) * _guard(t)
        for start, arm in PUNCHES:
            if arm == side:
                value = value + (punch - guard) * _out(t, start)
        return value

    return curve


def _twist(amount: float) -> Curve:
    """To minus amount (right) with each left fist, to amount with each right one: the punching shoulder comes forward."""

    def curve(t: Floats) -> Floats:
        value = 0.0 * t
        for start, arm in PUNCHES:
            turn = -amount if arm == "left" else amount
            value = value + turn * (ease(t, start - 0.06, start + OUT_S + 0.02) - ease(t, start + OUT_S + HELD_S, start + 0.76))
        return value

    return curve
