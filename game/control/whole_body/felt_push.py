"""What the body feels of a push: how much faster the COM got than the planned floor forces explain."""

import math

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

MEMORY_S = 0.2
"""So long is added up, for what the floor does differently from the plan comes and goes."""

THROWN_M_S = 0.25
"""A push that is felt so much throws the body. Measured: 60 N s make it 0.4; a player's motions 0.2, hops and quick turns 0.3."""

NOW_S, UNFELT_M_S = 0.03, 0.04
"""A push that goes on is told from what it did in so long, less what a motion does."""

_Pair = tuple[float, float]


class FeltPush:
    """`speed` (m/s): of the last MEMORY_S, horizontally; an impulse of J N s on a body of m kg makes it J / m at once, then it fades.

    acceleration (2,) m/s^2: what pushes now, zero where a motion of the body's own may explain it.
    """

    def __init__(self) -> None:
        self.speed = 0.0
        self.thrown_s = 10.0
        """Since the body was thrown."""
        self.acceleration = np.zeros(2)
        self._sum: _Pair = 0.0, 0.0
        self._now: _Pair = 0.0, 0.0
        self._last: tuple[float, float] | None = None

    @property
    def thrown(self) -> bool:
        """It is more than a motion of the body's own, or a landing, would leave unexplained."""
        return self.speed > THROWN_M_S

    def feel(self, com_velocity: Floats, wrench: Floats, mass_kg: float, dt: float) -> None:
        """com_velocity (3,) m/s now; wrench (6 n,) that was planned for the floor since the last call, `dt` ago."""
        now = float(com_velocity[0]), float(com_velocity[1])
        if self._last is not None:
            pushed = (dt / mass_kg * wrench.reshape(-1, 6).sum(axis=0)[:2]).tolist()
            gained = now[0] - self._last[0] - pushed[0], now[1] - self._last[1] - pushed[1]
            self._sum, self._now = _faded(self._sum, gained, dt / MEMORY_S), _faded(self._now, gained, dt / NOW_S)
            self.speed, speed = math.hypot(*self._sum), math.hypot(*self._now)
            felt = max(1.0 - UNFELT_M_S / max(speed, 1e-9), 0.0) / NOW_S
            self.acceleration = felt * np.array(self._now)
        self._last = now
        self.thrown_s = 0.0 if self.thrown else self.thrown_s + dt


def _faded(total: _Pair, gained: _Pair, share: float) -> _Pair:
    keeps = math.exp(-share)
    return keeps * (total[0] + gained[0]), keeps * (total[1] + gained[1])
