"""Stepping on the spot (thesis Table 1: controlled ground support change): the weight goes to one foot before the other lifts."""

from game.inputs.performance.curves import Curve, bump, keys, total
from game.inputs.performance.script import STANDING, Script, Side

LENGTH_S = 10.7
STEPS = 11
FIRST_LIFT_S, PERIOD_S, OFF_FLOOR_S = 1.50, 0.78, 0.50
STANCE_ZMP_M = 0.094
LIFT_M = 0.103


def lifts() -> list[tuple[Side, float, float]]:
    """(foot, leaves, lands) of every step."""
    times = [FIRST_LIFT_S + PERIOD_S * index for index in range(STEPS)]
    return [("right" if index % 2 == 0 else "left", t, t + OFF_FLOOR_S) for index, t in enumerate(times)]


def script() -> Script:
    airborne: dict[Side, tuple[tuple[float, float], ...]] = {
        side: tuple((leaves, lands) for foot, leaves, lands in lifts() if foot == side) for side in ("left", "right")
    }
    end = lifts()[-1][2]
    moving = (0.85, FIRST_LIFT_S, end, end + 0.7)
    return Script(
        LENGTH_S,
        {
            **{f"{side}.lift": _lift(side, LIFT_M) for side in airborne},
            **{f"{side}.tilt": _lift(side, 9.0) for side in airborne},
            **{f"{side}.flex": _arm_swing(side) for side in airborne},
            **{f"{side}.elbow": _between(moving, STANDING["left.elbow"], 32.0) for side in airborne},
            "zmp.y": _weight(),
            "pelvis.roll": total(*(bump(leaves - 0.1, lands + 0.1, -3.0 if foot == "left" else 3.0) for foot, leaves, lands in lifts())),
            "pelvis.height": _between(moving, STANDING["pelvis.height"], 0.955),
        },
        airborne,
    )


def _between(moving: tuple[float, float, float, float], idle: float, value: float) -> Curve:
    return keys((moving[0], idle), (moving[1], value), (moving[2], value), (moving[3], idle))


def _lift(side: str, height: float) -> Curve:
    return total(*(bump(leaves, lands, height) for foot, leaves, lands in lifts() if foot == side))


def _arm_swing(side: str) -> Curve:
    """The arm opposite to the lifted leg swings forward."""
    return total(
        keys((0.0, STANDING[f"{side}.flex"])),
        *(bump(leaves - 0.15, lands + 0.15, -12.0 if foot == side else 16.0) for foot, leaves, lands in lifts()),
    )


def _weight() -> Curve:
    """The ground force rests in the stance foot while the other is up and crosses over while both are down.

    Before the first step it goes to the foot that will lift and so throws the weight to the other (anticipatory postural adjustment).
    """
    points = [(0.80, 0.0), (1.04, -0.045)]
    for foot, leaves, lands in lifts():
        stance = STANCE_ZMP_M if foot == "right" else -STANCE_ZMP_M
        points += [(leaves, stance), (lands, stance)]
    return keys(*points, (points[-1][0] + 0.7, 0.0))
