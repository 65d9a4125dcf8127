"""Balancing on one leg (thesis Table 1: limited ground support): left leg up, then the right."""

from game.inputs.performance.curves import Curve, keys
from game.inputs.performance.script import STANDING, Lift, Script, Side

LENGTH_S = 28.3
SHIFT_S, RAISE_S = 1.3, 1.1
STANDS: tuple[tuple[Side, float, float], ...] = (("left", 2.6, 10.6), ("right", 15.6, 23.6))
"""(lifted foot, leaves the floor, is back on it), seconds."""
STANCE_ZMP_M = 0.097


def script() -> Script:
    sides: tuple[Side, Side] = ("left", "right")
    airborne: dict[Side, tuple[Lift, ...]] = {
        side: tuple((leaves, lands) for foot, leaves, lands in STANDS if foot == side) for side in sides
    }
    return Script(
        LENGTH_S,
        {
            **{f"{side}.lift": _raised(0.0, 0.200, side) for side in sides},
            **{f"{side}.forward": _raised(0.0, 0.030, side) for side in sides},
            **{f"{side}.out": _raised(0.0, -0.060, side) for side in sides},
            **{f"{side}.tilt": _raised(0.0, 12.0, side) for side in sides},
            **{f"{side}.side": _shifted(STANDING["left.side"], 42.0) for side in sides},
            **{f"{side}.elbow": _shifted(STANDING["left.elbow"], 24.0) for side in sides},
            "zmp.y": _shifted(0.0, -STANCE_ZMP_M, STANCE_ZMP_M),
            "pelvis.height": _shifted(STANDING["pelvis.height"], 0.958),
            "pelvis.roll": _raised(0.0, 4.0, "right", "left"),
            "trunk.roll": _shifted(0.0, 2.0, -2.0),
        },
        airborne,
    )


def _shifted(idle: float, left_up: float, right_up: float | None = None) -> Curve:
    """Reached before the foot leaves the floor, kept until it is back."""
    points: list[tuple[float, float]] = []
    for foot, leaves, lands in STANDS:
        value = left_up if foot == "left" or right_up is None else right_up
        points += [(leaves - SHIFT_S, idle), (leaves, value), (lands, value), (lands + SHIFT_S, idle)]
    return keys(*points)


def _raised(idle: float, value: float, side: Side, opposite: Side | None = None) -> Curve:
    """Reached after the foot has left the floor; with opposite the negative value while that foot is up."""
    points: list[tuple[float, float]] = [(0.0, idle)]
    for foot, leaves, lands in STANDS:
        if foot in (side, opposite):
            signed = value if foot == side else -value
            points += [(leaves, idle), (leaves + RAISE_S, signed), (lands - RAISE_S, signed), (lands, idle)]
    return keys(*points)
