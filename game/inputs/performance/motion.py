"""A motion carried out: its script, balanced, as a continuous function of time."""

from functools import cached_property

import numpy as np

from game.inputs.performance.balance import solve_pelvis_path
from game.inputs.performance.figure import pose_figure
from game.inputs.performance.flight import counter_pitch
from game.inputs.performance.script import SIDES, Script
from game.inputs.performance.tridiagonal import Spline
from kinect.body import Floats

GRID_HZ = 120.0
"""How finely the path is solved; between grid times it is a cubic spline."""
FLIGHT_ROUNDS = 4
"""How often path and counter-rotation of a jump are solved in turn: the angular momentum in flight then holds within 5 %."""


class Motion:
    """A script and the balanced pelvis path that goes with it; the path is solved once, on first use."""

    def __init__(self, script: Script) -> None:
        self.script = script

    @property
    def length_s(self) -> float:
        return self.script.length_s

    @cached_property
    def _path(self) -> Spline:
        """HIP_CENTER (x, y, z) and the upper body's pitch offset against time."""
        step_s = 1.0 / GRID_HZ
        t = np.arange(int(np.ceil(self.length_s * GRID_HZ)) + 2, dtype=np.float64) * step_s
        channels = self.script.sample(t)
        zmp = np.column_stack([channels["zmp.x"], channels["zmp.y"]])
        rise = None if self.script.com_rise is None else self.script.com_rise(t)
        airborne = ~(self.script.on_floor(t, SIDES[0]) | self.script.on_floor(t, SIDES[1]))
        figure, pitch = pose_figure(channels), np.zeros(len(t))
        turns = FLIGHT_ROUNDS if np.any(airborne) else 0
        pelvis = solve_pelvis_path(figure, zmp, rise, airborne, step_s, rounds=3 if turns else 7)
        for _ in range(turns):
            pitch = counter_pitch(figure.joints(pelvis), pitch, step_s)
            figure = pose_figure(_pitched(channels, pitch))
            pelvis = solve_pelvis_path(figure, zmp, rise, airborne, step_s, rounds=2, start=pelvis)
        return Spline(np.column_stack([pelvis, pitch]), step_s)

    def joints(self, t: Floats) -> Floats:
        """(T, 20, 3) true joints at times t (T,), seconds; metres, world frame (x towards the sensor, y left, z up)."""
        t = np.clip(np.atleast_1d(np.asarray(t, float)), 0.0, self.length_s)
        path = self._path(t)
        return pose_figure(_pitched(self.script.sample(t), path[:, 3])).joints(path[:, :3])


def _pitched(channels: dict[str, Floats], offset: Floats) -> dict[str, Floats]:
    return channels | {f"{part}.pitch": channels[f"{part}.pitch"] + offset for part in ("pelvis", "trunk", "head")}
