"""How far a human's joints go, as boxes of the rotation vector child in parent: x forward, y left, z up in the idle stance.

Ranges in degrees: American Academy of Orthopaedic Surgeons' and American Medical Association's tables (as in Norkin & White, appendix A)
for shoulder, elbow, wrist, trunk and neck; hip, knee and ankle after Soucie et al. 2011 (Haemophilia 17:500, men of 20 to 44) and the same
tables. Four of them are wider than the joint itself, because the mapping (Eq. 3.1 of Zwennes 2014) gives no limb a twist about its length,
so that the next joint has to show it: the elbow bends as far about any axis across the forearm as about its own, the wrist about any, the
knee leans with a turned thigh, the ankle turns the foot out. They are estimates, wide enough for real recordings; a knee that may lean
by 25 degrees instead of 15 gives way under shoves and lunges. A standing ankle bends further than one that is
measured lying: 40 degrees, as in a deep lunge.
"""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import JOINTS
from game.compiled import compiled

Floats = NDArray[np.float64]

DEGREES: dict[str, tuple[tuple[float, float], ...]] = {
    # side bending 35, forward 80 and back 25 to 30, turning 45
    "spine": ((-40.0, 40.0), (-30.0, 85.0), (-45.0, 45.0)),
    # side bending 45, nodding 50 and 60 back, turning 80
    "neck": ((-45.0, 45.0), (-60.0, 50.0), (-80.0, 80.0)),
    # across the body 75, sideways up 180; forward up 180, back 60; inward 70, outward 90
    "shoulder": ((-75.0, 180.0), (-180.0, 60.0), (-70.0, 90.0)),
    # bending 150; widened to every direction across the arm
    "elbow": ((-150.0, 150.0), (-150.0, 150.0), (-80.0, 80.0)),
    # bending 80 and 70, to the thumb 20, to the little finger 30; widened
    "wrist": ((-80.0, 70.0), (-70.0, 70.0), (-10.0, 10.0)),
    # across 30, sideways 45; forward 130, back 17 and a little of the pelvis; turning 45
    "hip": ((-30.0, 50.0), (-130.0, 30.0), (-45.0, 45.0)),
    # bending 150, over-stretching 3; sideways widened, the shank's own turning 15
    "knee": ((-15.0, 15.0), (-3.0, 150.0), (-15.0, 15.0)),
    # sole inward 35, outward 20; toes up 40 (standing), down 55; turned out and in: widened
    "ankle": ((-35.0, 25.0), (-40.0, 55.0), (-40.0, 40.0)),
}
"""(minus, plus) about x, y, z of the joints of the left side and the middle."""


def _ranges() -> tuple[Floats, Floats]:
    low, high = np.empty((len(JOINTS), 3)), np.empty((len(JOINTS), 3))
    for row, joint in enumerate(JOINTS):
        name, _, side = joint.partition("_")
        for axis, (minus, plus) in enumerate(DEGREES[name]):
            # a mirror swaps the two ways to turn about the axes that lie in it
            low[row, axis], high[row, axis] = (-plus, -minus) if side == "right" and axis != 1 else (minus, plus)
    return np.radians(low), np.radians(high)


LOW, HIGH = _ranges()
"""(14, 3) rad each."""


@compiled
def joint_angles(joint_rotation: Floats) -> Floats:
    """(14, 3) rad, rotation vectors of the joints (14, 4), each the one nearer to its range."""
    angles = np.empty((len(joint_rotation), 3))
    for j in range(len(joint_rotation)):
        angles[j] = in_range_of(joint_rotation[j], LOW[j], HIGH[j])
    return angles


@compiled
def in_range_of(turn: Floats, low: Floats, high: Floats) -> Floats:
    """The rotation vector (3,) of `turn` (4,), of the two that mean it the one nearer to low and high (3,) rad.

    An arm that is raised by 190 degrees has not been lowered by 170.
    """
    angle = one.log(turn)
    size = one.length(angle)
    if size > 0.5 * math.pi and one.dot(angle, low + high) < 0.0:
        other = (1.0 - 2.0 * math.pi / size) * angle
        past, other_past = 0.0, 0.0
        for axis in range(3):
            past = max(past, low[axis] - angle[axis], angle[axis] - high[axis])
            other_past = max(other_past, low[axis] - other[axis], other[axis] - high[axis])
        if other_past < past:
            return other
    return angle
