"""The puppet's centre of mass: a linear inverted pendulum whose ground force never leaves the feet.

c'' = (g / z) (c - p) with the zero moment point p kept inside the support. The capture point xi = c + c' / w, w = sqrt(g / z),
follows xi' = w (xi - p); p = xi + k (xi - xi_wanted) drives it to the wanted place (Englsberger et al. 2011).
"""

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from game.inputs.performance.balance import GRAVITY
from kinect.body import Floats

_GAIN: Final = 1.6
_SUBSTEPS: Final = 4


@dataclass(frozen=True)
class Support:
    """A rectangle on the floor that the zero moment point may reach, metres, world; None in flight."""

    low: Floats
    high: Floats


@dataclass
class Pendulum:
    """Horizontal motion of the centre of mass: position and velocity (2,), metres, world."""

    com: Floats = field(default_factory=lambda: np.zeros(2))
    velocity: Floats = field(default_factory=lambda: np.zeros(2))

    def capture_point(self, height: float) -> Floats:
        """(2,) where the person would have to step to come to rest."""
        return self.com + self.velocity / np.sqrt(GRAVITY / height)

    def step(self, wanted: Floats, support: Support | None, height: float, step_s: float) -> None:
        """Advance towards the wanted place (2,); in flight (no support) the velocity stays.

        A capture point outside the support could never come back: it is held at the edge, whatever led it there.
        """
        h = step_s / _SUBSTEPS
        w = float(np.sqrt(GRAVITY / height))
        for _ in range(_SUBSTEPS):
            if support is None:
                self.com = self.com + h * self.velocity
                continue
            xi = self.com + self.velocity / w
            p = np.clip(xi + _GAIN * (xi - wanted), support.low, support.high)
            off, cosh, sinh = self.com - p, np.cosh(w * h), np.sinh(w * h)
            self.com = p + off * cosh + self.velocity / w * sinh
            self.velocity = off * w * sinh + self.velocity * cosh
            held = np.clip(self.com + self.velocity / w, support.low, support.high)  # the strings hold what feet could not
            self.velocity = w * (held - self.com)
