"""A motion carried out: its script, balanced, as a continuous function of time."""

from functools import cached_property

import numpy as np

from game.inputs.performance.balance import solve_pelvis_path
from game.inputs.performance.figure import pose_figure
from game.inputs.performance.script import SIDES, Script
from game.inputs.performance.tridiagonal import Spline
from kinect.body import Floats

GRID_HZ = 120.0


class Motion:
    """A script and the balanced pelvis path that goes with it; the path is solved once, on first use."""

    def __init__(self, script: Script) -> None:
        self.script = script

    @property
    def length_s(self) -> float:
        return self.script.length_s

    @cached_property
    def _pelvis(self) -> Spline:
        t = np.arange(int(np.ceil(self.length_s * GRID_HZ)) + 2) / GRID_HZ
        channels = self.script.sample(t)
        zmp = np.column_stack([channels["zmp.x"], channels["zmp.y"]])
        com_rise = None if self.script.com_rise is None else self.script.com_rise(t)
        airborne = ~(self.script.on_floor(t, SIDES[0]) | self.script.on_floor(t, SIDES[1]))
        return Spline(solve_pelvis_path(pose_figure(channels), zmp, com_rise, airborne, 1.0 / GRID_HZ), 1.0 / GRID_HZ)

    def joints(self, t: Floats) -> Floats:
        """(T, 20, 3) true joints at times t (T,), seconds; metres, world frame (x towards the sensor, y left, z up)."""
        t = np.clip(np.atleast_1d(np.asarray(t, float)), 0.0, self.length_s)
        return pose_figure(self.script.sample(t)).joints(self._pelvis(t))
