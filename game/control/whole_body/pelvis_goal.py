"""Which way the pelvis may face: the player's, as far as the feet that stand let it turn."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled

Floats = NDArray[np.float64]

TWIST_RAD = 0.6
"""What hip, shank and ankle together let the pelvis turn against a foot that stands; a player who turns further turns on his toes."""


@compiled
def held_by_feet(upright: Floats, spin: Floats, yaws: tuple[float, float], stands: tuple[bool, bool]) -> Floats:
    """The orientation `upright` (4,) turned about the vertical to no more than TWIST_RAD from the yaw of any sole that stands.

    Edits its spin (3,), own frame: what is turned back does not turn on.
    """
    heading, back = one.yaw(upright), 0.0
    for side in range(2):
        if stands[side]:
            back += one.turn_within(heading + back, yaws[side], TWIST_RAD)
    if back == 0.0:
        return upright
    up = one.matrix(upright)[2]
    spin -= one.dot(up, spin) * up
    return one.multiply(one.about_z(back), upright)
