"""A puppet that plays by itself: a seeded, sensible, endless bout for duels without a second player."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

import numpy as np

from game.inputs.performer import FRAMES_PER_S
from game.inputs.puppet import Puppet
from game.inputs.puppet_controls import PuppetControls
from kinect.body import BodyFrame

Beat = tuple[float, PuppetControls]
"""(seconds, what the puppet is asked to do meanwhile)"""

FIRST_STILL_S: Final = 1.5  # long enough to be measured while it stands
_ARMS: Final = ("thrust_left", "thrust_right")


def bout(seed: int) -> Iterator[Beat]:
    """An endless bout: stand still, take guard, then attacks, evasions and breaths in seeded order and measure."""
    rng = np.random.default_rng(seed)
    yield FIRST_STILL_S, PuppetControls()
    yield float(rng.uniform(0.4, 0.9)), PuppetControls(guard=True)
    kinds = (_attack, _shove, _evade, _breathe, _shift)
    while True:
        yield from kinds[int(rng.choice(len(kinds), p=(0.42, 0.16, 0.16, 0.18, 0.08)))](rng)


class ScriptedPuppet:
    """A `BodySource`: a puppet steered by `bout(seed)`; its frames do not depend on how often it is polled."""

    def __init__(self, seed: int = 0, player: int = 0) -> None:
        self._seed = seed
        self._puppet = Puppet(player=player)
        self._beats = bout(seed)
        self._ends_s = 0.0
        self._next = 0

    @property
    def status(self) -> str:
        return f"A puppet boxes by itself (bout {self._seed})."

    @property
    def length_s(self) -> float | None:
        """None: the bout never ends."""
        return None

    def poll(self, until_s: float) -> list[BodyFrame]:
        """The frames up to until_s (finite)."""
        frames: list[BodyFrame] = []
        while self._next / FRAMES_PER_S <= until_s + 1e-9:
            time_s = self._next / FRAMES_PER_S
            while time_s >= self._ends_s:
                seconds, self._puppet.controls = next(self._beats)
                self._ends_s += seconds
            frames += self._puppet.poll(time_s)
            self._next += 1
        return frames

    def close(self) -> None:
        """Hand out no more frames."""
        self._puppet.close()


def _attack(rng: np.random.Generator) -> Iterator[Beat]:
    """Lean in behind the guard and throw one to three punches, mostly left and right in turn."""
    lean = PuppetControls(guard=True, lean_forward=float(rng.uniform(0.2, 0.7)), lean_left=float(rng.uniform(-0.3, 0.3)))
    yield float(rng.uniform(0.25, 0.5)), lean
    arm = int(rng.integers(2))
    for _ in range(int(rng.integers(1, 4))):
        yield float(rng.uniform(0.22, 0.38)), replace(lean, **{_ARMS[arm]: float(rng.uniform(0.7, 1.0))})
        yield float(rng.uniform(0.12, 0.3)), lean
        arm = 1 - arm if rng.random() < 0.8 else arm
    yield float(rng.uniform(0.3, 0.6)), PuppetControls(guard=True)


def _shove(rng: np.random.Generator) -> Iterator[Beat]:
    """Both hands forward with the weight behind them."""
    lean = float(rng.uniform(0.4, 0.9))
    yield float(rng.uniform(0.2, 0.4)), PuppetControls(guard=True, lean_forward=-0.3, crouch=0.2)
    yield float(rng.uniform(0.4, 0.8)), PuppetControls(thrust_left=1.0, thrust_right=1.0, lean_forward=lean)
    yield float(rng.uniform(0.4, 0.7)), PuppetControls(guard=True)


def _evade(rng: np.random.Generator) -> Iterator[Beat]:
    """Lean away or duck, then come back."""
    aside = float(rng.choice((-1.0, 1.0)) * rng.uniform(0.3, 0.8))
    duck = float(rng.uniform(0.0, 0.5))
    yield float(rng.uniform(0.4, 0.8)), PuppetControls(guard=True, lean_forward=float(rng.uniform(-0.6, 0.0)), lean_left=aside, crouch=duck)
    yield float(rng.uniform(0.3, 0.6)), PuppetControls(guard=True)


def _breathe(rng: np.random.Generator) -> Iterator[Beat]:
    """Guard and wait."""
    yield float(rng.uniform(0.4, 1.3)), PuppetControls(guard=True)


def _shift(rng: np.random.Generator) -> Iterator[Beat]:
    """One step on the spot."""
    left = bool(rng.random() < 0.5)
    yield 0.1, PuppetControls(guard=True, step_left=left, step_right=not left)
    yield 1.1, PuppetControls(guard=True)
