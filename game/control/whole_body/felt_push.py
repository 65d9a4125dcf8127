"""What the body feels of a push: how much faster the COM got than the planned floor forces explain."""

import math

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

MEMORY_S = 0.2
"""So long is added up, for what the floor does differently from the plan comes and goes."""

THROWN_M_S = 0.25
"""A push that is felt so much throws the body. Measured: 60 N s make it 0.4; a player's motions 0.2, hops and quick turns 0.3."""


class FeltPush:
    """`speed` (m/s): of the last MEMORY_S, horizontally; an impulse of J N s on a body of m kg makes it J / m at once, then it fades."""

    def __init__(self) -> None:
        self.speed = 0.0
        self._sum = 0.0, 0.0
        self._last: tuple[float, float] | None = None

    @property
    def thrown(self) -> bool:
        """It is more than a motion of the body's own, or a landing, would leave unexplained."""
        return self.speed > THROWN_M_S

    def feel(self, com_velocity: Floats, wrench: Floats, mass_kg: float, dt: float) -> None:
        """com_velocity (3,) m/s now; wrench (6 n,) that was planned for the floor since the last call, `dt` ago."""
        now = float(com_velocity[0]), float(com_velocity[1])
        if self._last is not None:
            keeps, pushed = math.exp(-dt / MEMORY_S), dt / mass_kg * wrench.reshape(-1, 6).sum(axis=0)[:2]
            self._sum = tuple(keeps * (s + n - b - float(p)) for s, n, b, p in zip(self._sum, now, self._last, pushed, strict=True))
            self.speed = math.hypot(*self._sum)
        self._last = now
