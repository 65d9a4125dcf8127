"""A jump: the pelvis rises fast over feet that bear, legs nearly stretched, then both feet leave together and soon land."""

from collections import deque
from typing import NamedTuple

MEMORY_S = 0.25
"""How long before the feet leave a push-off may lie."""

TOGETHER_S = 0.17
"""The second foot leaves at most this long after the first."""

STRETCHED_SHARE = 0.85
"""Share of its standing height that the pelvis must have when the feet leave."""

REST_TIME_S = 3.0


class Feet(NamedTuple):
    """What a frame shows of both feet: sensed up or down (left, right), and whether the legs can be seen."""

    up: tuple[bool, bool]
    known: bool


class JumpGate:
    """Decides frame by frame whether the player is in flight. Heights in metres over the floor, times in seconds."""

    def __init__(self) -> None:
        self._heights: deque[tuple[float, float]] = deque()
        self._pushed_at = -1e9
        self._one_up_at = -1e9
        self._left_at: float | None = None
        self._standing_m = 0.0
        self.flight = False

    def step(self, time_s: float, pelvis_m: float, feet: Feet, *, push_off_m_s: float, limit_s: float) -> bool:
        """Whether this frame is flight; pelvis_m: height of the hip centre over the feet's resting place."""
        speed = self._speed(time_s, pelvis_m)
        up = feet.up[0] + feet.up[1]
        if up < 2:
            self.flight = False
            self._left_at = None
            if up == 0:
                self._one_up_at = time_s
                self._stand(pelvis_m, speed, feet.known)
            if feet.known and speed >= push_off_m_s:
                self._pushed_at = time_s
            return False
        if self._left_at is None:
            self._left_at = time_s
            pushed = time_s - self._pushed_at <= MEMORY_S and time_s - self._one_up_at <= TOGETHER_S
            self.flight = pushed and feet.known and speed > 0.0 and pelvis_m >= STRETCHED_SHARE * self._standing_m
        if time_s - self._left_at >= limit_s:
            self.flight = False
        return self.flight

    def _speed(self, time_s: float, pelvis_m: float) -> float:
        """Upward speed over the last two frames, which no single bad frame can make."""
        self._heights.append((time_s, pelvis_m))
        while len(self._heights) > 3:
            self._heights.popleft()
        then, height = self._heights[0]
        return (pelvis_m - height) / (time_s - then) if time_s > then else 0.0

    def _stand(self, pelvis_m: float, speed: float, known: bool) -> None:
        """The standing height follows upward at once a little, downward slowly: a crouch is no new stature."""
        if self._standing_m == 0.0:
            self._standing_m = pelvis_m
        elif known and abs(speed) < 0.1:
            share = 0.1 if pelvis_m > self._standing_m else 1.0 / (30.0 * REST_TIME_S)
            self._standing_m += share * (pelvis_m - self._standing_m)
