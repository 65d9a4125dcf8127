"""How the balance stands: what the planning of the feet goes by."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Sway:
    """xi (2,) m: the capture point; frequency 1/s of the pendulum; away_m from the COM to xi; thrown: a push was felt, push (2,) m/s^2:
    what it accelerates the body by now; load: shares of the weight on the left and the right foot."""

    xi: Floats
    frequency: float
    away_m: float
    thrown: bool
    push: Floats
    load: tuple[float, float]
