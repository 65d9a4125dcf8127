"""How far feet slide while they bear: their way over the floor for each second of contact."""

import math

from game.characters.skeleton import FEET
from game.physics.dynamics import BodyDynamics


class FootSlide:
    """Call `sample` at a fixed rate. A foot counts from one sample to the next if it touches the floor in both."""

    def __init__(self) -> None:
        self._last: dict[int, tuple[float, float]] = {}
        self._last_s = 0.0
        self._way_m = self._bearing_s = 0.0

    def sample(self, time_s: float, body: BodyDynamics) -> None:
        """One instant of the character, seconds."""
        now: dict[int, tuple[float, float]] = {}
        for side, touches in enumerate(body.foot_contact):
            if not touches:
                continue
            now[side] = (float(body.box_centre[FEET[side], 0]), float(body.box_centre[FEET[side], 1]))
            if side in self._last:
                self._way_m += math.dist(now[side], self._last[side])
                self._bearing_s += time_s - self._last_s
        self._last, self._last_s = now, time_s

    @property
    def speed_m_s(self) -> float | None:
        """Mean way of a bearing foot in a second; None where no foot bore."""
        return self._way_m / self._bearing_s if self._bearing_s > 0.0 else None
