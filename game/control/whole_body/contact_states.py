"""What each foot is doing: it stands, swings after the player's foot, or takes a step of its own."""

import math
from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from game.control.whole_body.bow import NO_BOW, Bow
from game.control.whole_body.saving_step import SavingStep

Floats = NDArray[np.float64]


class Phase(Enum):
    """Of one foot."""

    STANCE = "stands"
    SWING = "follows the player's foot"
    STEP = "steps on its own"


@dataclass
class FootState:
    """phase and how long it lasts; start, goal (3,) and yaw of a step of its own, over `duration_s`."""

    phase: Phase = Phase.STANCE
    time_s: float = 0.0
    start: Floats = field(default_factory=lambda: np.zeros(3))
    goal: Floats = field(default_factory=lambda: np.zeros(3))
    start_yaw: float = 0.0
    goal_yaw: float = 0.0
    duration_s: float = 0.3
    behind: Floats = field(default_factory=lambda: np.zeros(3))
    """Of a swing: how far the foot was from the player's when it began."""
    fresh: bool = True
    bow: Bow = NO_BOW
    """Of a step."""
    saving: SavingStep | None = None
    """The step that saves the balance, if the foot is on one."""

    @property
    def stands(self) -> bool:
        return self.phase is Phase.STANCE

    @property
    def mends(self) -> bool:
        """It is on its way to where the stance wants it, not to where the balance does."""
        return self.phase is Phase.STEP and self.saving is None

    def enter(self, phase: Phase) -> None:
        self.phase, self.time_s, self.fresh, self.saving = phase, 0.0, True, None

    def step_to(
        self, start: Floats, goal: Floats, start_yaw: float, goal_yaw: float, duration_s: float, bow: Bow = NO_BOW
    ) -> None:  # fmt: skip
        self.enter(Phase.STEP)
        self.bow = bow
        self.start, self.goal, self.duration_s = start.copy(), goal.copy(), duration_s
        self.start_yaw, self.goal_yaw = start_yaw, start_yaw + math.remainder(goal_yaw - start_yaw, math.tau)

    def step_motion(self, clearance_m: float) -> tuple[Floats, Floats, Floats, float, float]:
        """Place, velocity, acceleration (3,), yaw and its rate of the sole on its way: minimum jerk and its bow over the floor, a parabola
        above it."""
        span = self.duration_s
        s = min(self.time_s / span, 1.0)
        along = s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
        speed = 30.0 * s * s * (1.0 - s) ** 2 / span
        surge = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / span**2
        way = self.goal - self.start
        place, velocity, acceleration = self.start + along * way, speed * way, surge * way
        out, out_rate, out_surge = self.bow.motion(s)
        place += out
        velocity += out_rate / span
        acceleration += out_surge / span**2
        place[2] += 4.0 * clearance_m * s * (1.0 - s)
        velocity[2] += 4.0 * clearance_m * (1.0 - 2.0 * s) / span
        acceleration[2] -= 8.0 * clearance_m / span**2
        if self.time_s > span:
            # late: reach down for the floor
            place[2] -= 0.4 * (self.time_s - span)
            velocity[2] = -0.4
            acceleration[:] = 0.0
        turn = self.goal_yaw - self.start_yaw
        return place, velocity, acceleration, self.start_yaw + along * turn, speed * turn
