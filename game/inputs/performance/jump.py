"""Small jumps on the spot (thesis Table 1: losing ground support): crouch, push off over the balls of the feet, land softly."""

from game.inputs.performance.balance import GRAVITY
from game.inputs.performance.curves import Curve, bump, keys, through, total
from game.inputs.performance.script import STANDING, Script, both

LENGTH_S = 21.2
STARTS_S = (1.0, 6.0, 11.0, 16.0)
# Take-off and touch-down fall on the 120 Hz grid of motion.py, so that no grid step is half in the air.
CROUCH_S, PUSH_S, FLIGHT_S, ABSORB_S, RISE_S = 0.80, 0.35, 28.0 / 120.0, 0.31, 0.95
CROUCH_M, TAKE_OFF_M, LANDING_M, ABSORB_M = -0.150, 0.015, -0.005, -0.150
"""Centre of mass against standing: at the bottom of the crouch, when the feet leave, when they touch, at the bottom of the landing."""
TAKE_OFF_M_S = (LANDING_M - TAKE_OFF_M) / FLIGHT_S + GRAVITY * FLIGHT_S / 2.0
LANDING_M_S = TAKE_OFF_M_S - GRAVITY * FLIGHT_S
BALL_ZMP_M = 0.080


def _times(start: float) -> tuple[float, float, float, float, float]:
    """(bottom of the crouch, take-off, touch-down, bottom of the landing, upright)."""
    bottom = start + CROUCH_S
    leaves = bottom + PUSH_S
    lands = leaves + FLIGHT_S
    return bottom, leaves, lands, lands + ABSORB_S, lands + ABSORB_S + RISE_S


def script() -> Script:
    flights = tuple(_times(start)[1:3] for start in STARTS_S)
    return Script(
        LENGTH_S,
        {
            "trunk.pitch": _phases(0.0, 32.0, 16.0, 30.0),
            "pelvis.pitch": _phases(0.0, 16.0, 10.0, 16.0),
            "head.pitch": _phases(0.0, 12.0, 2.0, 8.0),
            **both("flex", _phases(STANDING["left.flex"], -30.0, 42.0, 22.0)),
            **both("elbow", _phases(STANDING["left.elbow"], 26.0, 44.0, 34.0)),
            **both("lift", total(*(bump(leaves, lands, 0.084) for leaves, lands in flights))),
            **both("tilt", _heels()),
            "zmp.x": _weight(),
        },
        {"left": flights, "right": flights},
        _height(),
    )


def _height() -> Curve:
    knots = []
    for start in STARTS_S:
        bottom, leaves, lands, landed, upright = _times(start)
        knots += [
            (start, 0.0, 0.0, 0.0),
            (bottom, CROUCH_M, 0.0, 2.0),
            (leaves, TAKE_OFF_M, TAKE_OFF_M_S, -GRAVITY),
            (lands, LANDING_M, LANDING_M_S, -GRAVITY),
            (landed, ABSORB_M, 0.0, 1.6),
            (upright, 0.0, 0.0, 0.0),
        ]
    return through(*knots)


def _phases(idle: float, crouched: float, aloft: float, absorbed: float) -> Curve:
    points = []
    for start in STARTS_S:
        bottom, leaves, lands, landed, upright = _times(start)
        points += [(start, idle), (bottom, crouched), (leaves, aloft), (lands, aloft), (landed, absorbed), (upright, idle)]
    return keys(*points)


def _heels() -> Curve:
    points = []
    for start in STARTS_S:
        _, leaves, lands, _, _ = _times(start)
        points += [(leaves - 0.15, 0.0), (leaves + 0.06, 26.0), (lands - 0.02, 18.0), (lands + 0.14, 0.0)]
    return keys(*points)


def _weight() -> Curve:
    """Onto the balls of the feet while the heels are off the floor."""
    points = []
    for start in STARTS_S:
        bottom, leaves, lands, landed, _ = _times(start)
        points += [(bottom - 0.3, 0.0), (leaves - 0.15, BALL_ZMP_M), (lands + 0.14, BALL_ZMP_M), (landed + 0.3, 0.0)]
    return keys(*points)
