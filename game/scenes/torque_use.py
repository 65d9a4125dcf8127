"""How much of its strength each joint uses."""

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]

MOST_SHOWN = 3.0
"""A share beyond this says no more than that a joint without strength left is loaded all the same."""


@compiled
def torque_use(torque: Floats, low: Floats, high: Floats) -> Floats:
    """(n,) share of its limit that each ball joint uses, the largest of its three axes; torque, low <= 0 <= high (3 n,) N m."""
    out = np.zeros(len(torque) // 3)
    for row in range(len(torque)):
        limit = high[row] if torque[row] > 0.0 else -low[row]
        share = min(abs(torque[row]) / max(limit, 1e-9), MOST_SHOWN)
        out[row // 3] = max(out[row // 3], share)
    return out
