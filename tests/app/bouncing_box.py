"""A scene small enough to know by heart: one box bounces on the floor, and keys push it."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from game.drawables import Boxes, Label, Layer
from game.scenes.scene import CameraHint, Plot


@dataclass(frozen=True)
class Push:
    """Controls of the box."""

    along: float = 0.0
    jump: bool = False


def push_from_keys(pressed: object) -> Push:
    assert isinstance(pressed, (set, frozenset))
    return Push(float("w" in pressed) - float("s" in pressed), "space" in pressed)


def push_from_gamepad(axes: tuple[float, ...], buttons: tuple[bool, ...]) -> Push:
    return Push(-axes[1] if abs(axes[1]) > 0.2 else 0.0, buttons[0])


class Pusher:
    """What the loop steers."""

    def __init__(self) -> None:
        self.controls = Push()


class BouncingBox:
    """Meets the Scene contract; `history` is the state of every update, so that runs can be compared."""

    name = "mirror"

    def __init__(self, pusher: Pusher | None = None, length_s: float | None = None) -> None:
        self.pusher = pusher or Pusher()
        self.length_s = length_s
        self.entered = self.left = 0
        self.said: tuple[str, ...] = ("Keys and gamepad steer the box",)
        self.points: str | None = "You 2 : 1 Rival"
        self.history: list[tuple[float, float]] = []
        self._reset()

    def _reset(self) -> None:
        self.steps = 0
        self.height, self.speed, self.x = 1.0, 0.0, 0.0
        self._before = (self.x, self.height)

    @property
    def time_s(self) -> float:
        return self.steps / 60.0

    @property
    def finished(self) -> bool:
        return self.length_s is not None and self.time_s >= self.length_s

    def enter(self) -> None:
        self.entered += 1
        self._reset()

    def fixed_update(self) -> None:
        self._before = (self.x, self.height)
        self.steps += 1
        self.speed -= 9.81 / 60.0
        self.height += self.speed / 60.0
        if self.height < 0.2:
            self.height, self.speed = 0.2, 3.0
        self.x += self.pusher.controls.along / 60.0
        self.history.append((self.x, self.height))

    def drawables(self, blend: float) -> tuple[Layer, ...]:
        x, z = (a + blend * (b - a) for a, b in zip(self._before, (self.x, self.height)))
        box = Boxes(np.array([[x, 0.0, z]]), np.array([[1.0, 0, 0, 0]]), np.full((1, 3), 0.2), np.array([[0.8, 0.4, 0.2, 1.0]]))
        return (Layer("character", (box, Label(np.array([x, 0.0, z + 0.35]), "box"))),)

    def readouts(self) -> Mapping[str, float | str]:
        return {"upright_s": self.time_s, "input": self.said[0], "physics_ms": 0.31, "target_ms": 0.42}

    def plots(self) -> tuple[Plot, ...]:
        t = np.linspace(max(0.0, self.time_s - 10), self.time_s, 200)
        square = np.array([-0.12, 0.12, 0.12, -0.12]), np.array([-0.1, -0.1, 0.15, 0.15])
        plan = {"support polygon": square, "COM": (np.array([0.02]), np.array([0.03])), "COS": (np.array([0.0]), np.array([0.02]))}
        return (
            Plot("Balance from above", "m", plan, kind="plan"),
            Plot("Joint error", "rad", {"mean": (t, 0.08 + 0.03 * np.sin(t)), "worst": (t, 0.2 + 0.05 * np.cos(3 * t))}),
            Plot("Peak torque", "N m", {"torque": (t, 90 + 40 * np.sin(2 * t))}),
        )

    def messages(self) -> tuple[str, ...]:
        return self.said

    def score(self) -> str | None:
        return self.points

    def help_keys(self) -> tuple[tuple[str, str], ...]:
        return (
            ("W A S D", "lean"),
            ("Space", "jump"),
            ("Q E", "raise an arm"),
            ("J K", "thrust an arm"),
            ("C", "crouch"),
            ("F", "kick"),
            ("G", "guard"),
            ("Left Shift", "step instead of lean"),
            ("V", "wave"),
        )

    def cameras(self) -> Mapping[str, CameraHint]:
        return {"front": CameraHint((3.2, 1.0, 1.5), (0, 0, 0.9)), "side": CameraHint((0.0, 3.0, 1.2), (0, 0, 0.9))}

    def leave(self) -> None:
        self.left += 1
