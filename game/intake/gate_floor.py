"""Foot contact by height and speed, each foot over its own resting height, with hysteresis."""

import math
from typing import NamedTuple

from game.intake.gate_legs import FootSight

SUNK_M = 0.07
"""An ankle that sinks this far below its rest has gone through the floor: it was not seen."""

SUNK_TOES_M = 0.04
"""Toes farther below their rest than this were not seen either."""

EVEN_M = 0.05
"""At the start ankles that differ more than this do not both stand."""

GONE_M = 0.1
"""A foot that is fast and this far from where it stood is taking a step, however low."""

FORGOTTEN_S = 1.5
STILL_M_S = 0.05
"""A foot that hangs this long and this still less than twice the lifting height above its rest stands there."""


class FootSense(NamedTuple):
    """One foot in one frame, over its rest: ankle_m of the ankle, lift_m of the whole foot (the lower of ankle and toes).

    speed_m_s: of the ankle; away_m: how far it has gone from where it stood, over the floor.
    """

    ankle_m: float
    lift_m: float
    speed_m_s: float
    away_m: float

    @property
    def sunk(self) -> bool:
        return self.ankle_m < -SUNK_M


class RestingFoot:
    """Resting heights of one foot's ankle and toes, learnt while it stands, and whether it is down."""

    def __init__(self) -> None:
        self._rest = [math.nan, math.nan]
        self._last: tuple[float, float, float] | None = None
        self._place: tuple[float, float] | None = None
        self._still_s = 0.0
        self.down = True

    @property
    def rest_m(self) -> float:
        """Resting height of the ankle, world z."""
        return self._rest[0]

    def start(self, foot: FootSight, lowest_m: float) -> None:
        """Begin with the first frame; `lowest_m`: height of the lower of the two ankles."""
        ankle, toes = foot[2:]
        raised = max(0.0, ankle - lowest_m) if ankle - lowest_m > EVEN_M else 0.0
        self._rest = [ankle - raised, toes - raised]
        self.down = raised == 0.0

    def sense(self, foot: FootSight, dt: float) -> FootSense:
        """The foot as it is seen `dt` seconds after the last frame."""
        ankle, here = foot[:3], foot[:2]
        moved = 0.0 if self._last is None or dt <= 0.0 else math.dist(ankle, self._last) / dt
        self._last = ankle
        lift, heel = self.raised(foot)
        self._place = self._place or here
        return FootSense(lift + heel, lift, moved, math.dist(here, self._place))

    def raised(self, foot: FootSight) -> tuple[float, float]:
        """How far the whole foot is over its rest, and how much farther its ankle is: the heel, metres."""
        ankle, toes = foot[2] - self._rest[0], foot[3] - self._rest[1]
        # toes in the floor are the sensor's fault, and the ankle alone must tell
        lift = ankle if toes < -SUNK_TOES_M else min(ankle, toes)
        return lift, ankle - lift

    def decide(self, sense: FootSense, dt: float, *, up_m: float, down_m: float, speed_m_s: float) -> None:
        """Lifts above `up_m`, or sooner where it is fast, or where it is fast and gone; is down again below `down_m` once it is slow."""
        fast = sense.speed_m_s > speed_m_s
        if self.down:
            self.down = not (sense.lift_m > up_m or (fast and (sense.lift_m > down_m or sense.away_m > GONE_M)))
        elif sense.lift_m < down_m and not fast:
            self.down = True
            self._place = None
        resting = not self.down and sense.lift_m < 2.0 * up_m and sense.speed_m_s < STILL_M_S
        self._still_s = self._still_s + dt if resting else 0.0
        if self._still_s > FORGOTTEN_S:
            self.down = True
            self._rest = [height + sense.lift_m for height in self._rest]

    def settle(self, foot: FootSight, share: float) -> None:
        """A standing foot: its place and its rest follow by `share`; the rest stays where the foot is through the floor."""
        here = foot[:2]
        x, y = self._place or here
        self._place = (x + share * (here[0] - x), y + share * (here[1] - y))
        heights = foot[2:]
        if abs(heights[0] - self._rest[0]) < SUNK_M:
            self._rest = [rest + share * (height - rest) for rest, height in zip(self._rest, heights, strict=True)]
