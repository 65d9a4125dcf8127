"""Knees bend forward: in a deep bow or a lunge the sensor shows them bent back or sideways, as no leg can."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.joint_limits import DEGREES
from game.compiled import compiled
from game.intake.gate_legs import LEGS

Floats = NDArray[np.float64]

_ASIDE, _BENT, _ = DEGREES["knee"]
BACK, SIDE = math.sin(math.radians(-_BENT[0])), math.sin(math.radians(_ASIDE[1]))
"""Sines of the angles by which a character's knee over-stretches and leans sideways."""

TURNED_OUT = 1.0
"""A thigh that is turned at the hip by 45 degrees shows a bent knee as far to the side as it is bent forward."""

_DOWN = np.array([0.0, 0.0, -1.0])


@compiled
def bend_forward(joints: Floats) -> None:
    """Moves the knees of joints (20, 3), world frame, in place: at right angles to the line from hip to ankle, which stay."""
    left = joints[LEGS[0, 0]] - joints[LEGS[1, 0]]
    across = math.hypot(left[0], left[1])
    if across < 1e-6:
        return
    ahead = np.array([left[1] / across, -left[0] / across, 0.0])
    for side in range(2):
        hip, knee, ankle = joints[LEGS[side, 0]], joints[LEGS[side, 1]], joints[LEGS[side, 2]]
        span = one.length(ankle - hip)
        if span < 1e-6:
            continue
        along = (ankle - hip) / span
        # of a leg that swings without a twist, from hanging straight down to where it is
        forward = one.turn(one.matrix(one.between(_DOWN, along)), ahead)
        outward = one.cross(along, forward)
        off = knee - hip
        off = off - one.dot(off, along) * along
        bent, aside = one.dot(off, forward), one.dot(off, outward)
        # a knee bent by an angle is off the line by reach times its sine
        reach = one.length(knee - hip) * one.length(ankle - knee) / span
        new_bent = max(bent, -BACK * reach)
        most_aside = max(SIDE * reach, TURNED_OUT * new_bent)
        new_aside = min(max(aside, -most_aside), most_aside)
        for axis in range(3):
            joints[LEGS[side, 1], axis] += (new_bent - bent) * forward[axis] + (new_aside - aside) * outward[axis]
