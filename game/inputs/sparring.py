"""The opponent's mind: a puppet that keeps its guard, watches the distance and shoves when the other is near."""

from dataclasses import replace

import numpy as np

from game.inputs.puppet import Puppet
from game.inputs.puppet_controls import PuppetControls
from kinect.body import BodyFrame

NEAR_M = 1.2
"""Pelvis to pelvis: from here on a lunge can land."""

GUARD = PuppetControls(guard=True)
STILL_S = 2.0
"""It stands still through the hang and a breath longer, so that nobody is struck before they have landed."""


class SparringPartner:
    """A `BodySource` for a duel. The scene calls `see` once a frame; the choices are seeded.

    vigour 0..1: how soon it attacks again and how much weight it puts into it.
    """

    def __init__(self, seed: int) -> None:
        self._puppet = Puppet(player=1, greeting="The opponent thinks for itself.")
        self._rng = np.random.default_rng(seed)
        self._plan: list[tuple[float, PuppetControls]] = [(STILL_S, PuppetControls())]
        self._until_s = 0.0
        self._time_s = 0.0

    @property
    def status(self) -> str:
        return self._puppet.status

    @property
    def length_s(self) -> float | None:
        return None

    def new_round(self) -> None:
        """Drop whatever was under way and stand up straight again."""
        self._plan = [(STILL_S, PuppetControls())]
        self._until_s = self._time_s

    def see(self, distance_m: float, vigour: float) -> None:
        """What it knows of the other before the next frame; new intentions form when the last are carried out."""
        if self._plan or self._time_s < self._until_s:
            return
        if distance_m > NEAR_M:
            self._plan = [(0.4, GUARD)]
        elif self._rng.random() < 0.45 + 0.5 * vigour:
            self._plan = self._attack(vigour)
        else:
            self._plan = self._wait()

    def poll(self, until_s: float) -> list[BodyFrame]:
        frames: list[BodyFrame] = []
        while self._time_s <= until_s + 1e-9:
            while self._time_s >= self._until_s and self._plan:
                seconds, self._puppet.controls = self._plan.pop(0)
                self._until_s = max(self._until_s, self._time_s) + seconds
            frames += self._puppet.poll(self._time_s)
            self._time_s += 1.0 / 30.0
        return frames

    def close(self) -> None:
        self._puppet.close()

    def _attack(self, vigour: float) -> list[tuple[float, PuppetControls]]:
        """A two-handed shove or a jab, with a short draw-back before it."""
        rng = self._rng
        lean = min(1.0, float(rng.uniform(0.3, 0.6) + 0.4 * vigour))
        drawn = replace(GUARD, lean_forward=-0.25)
        if rng.random() < 0.6:
            blow = PuppetControls(thrust_left=1.0, thrust_right=1.0, lean_forward=lean)
        else:
            arm = "thrust_left" if rng.random() < 0.5 else "thrust_right"
            blow = replace(GUARD, lean_forward=lean, **{arm: 1.0})
        return [(float(rng.uniform(0.15, 0.35)), drawn), (float(rng.uniform(0.35, 0.6)), blow), (float(rng.uniform(0.3, 0.8)), GUARD)]

    def _wait(self) -> list[tuple[float, PuppetControls]]:
        """Guard, sometimes swaying out of the line."""
        rng = self._rng
        sway = float(rng.uniform(-0.6, 0.6)) if rng.random() < 0.4 else 0.0
        return [(float(rng.uniform(0.4, 1.0)), replace(GUARD, lean_left=sway, lean_forward=float(rng.uniform(-0.4, 0.1))))]
