"""How much of its strength each joint uses, now and at most since the last sample."""

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]

MOST_SHOWN = 3.0
"""A share beyond this says no more than that a joint without strength left is loaded all the same."""


@compiled
def note_torques(torque: Floats, low: Floats, high: Floats, use: Floats, most: Floats) -> float:
    """Write into `use` (n,) the share of its limit that each ball joint uses, the largest of its three axes, and raise `most` (n,)
    to it; gives the largest torque. torque, low <= 0 <= high (3 n,) N m."""
    use[:] = 0.0
    largest = 0.0
    for row in range(len(torque)):
        size = abs(torque[row])
        limit = high[row] if torque[row] > 0.0 else -low[row]
        joint = row // 3
        use[joint] = max(use[joint], min(size / max(limit, 1e-9), MOST_SHOWN))
        most[joint] = max(most[joint], use[joint])
        largest = max(largest, size)
    return largest
