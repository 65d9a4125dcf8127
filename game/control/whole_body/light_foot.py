"""The ankle of a foot that stood but carried nothing: it eases into its work, or it would whip the foot round before the floor bears it."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import LEG_JOINTS

Floats = NDArray[np.float64]

LIGHT_N, EASED = 50.0, 0.15
"""A foot that was planned to carry less has its ankle planned with this share of its strength for one tick."""

_ANKLES = tuple(slice(3 * joint, 3 * joint + 3) for joint in LEG_JOINTS[2::3])


def eased(strength: Floats, standing: Sequence[int], carried_n: Mapping[int, float]) -> Floats:
    """`strength` (2, 42) N m, less at the ankles of `standing` feet that carried nothing.

    carried_n: what each foot that stood a tick ago was planned to carry. One that has just landed is on the floor with its weight.
    """
    light = [side for side in standing if carried_n.get(side, LIGHT_N) < LIGHT_N]
    if not light:
        return strength
    out = strength.copy()
    for side in light:
        out[:, _ANKLES[side]] *= EASED
    return out
