"""From smoothed wishes to posture channels: how far the trunk bends, where the arms go, how low the hips are."""

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from game.inputs.performance.script import SIDES, STANDING
from game.inputs.puppet_controls import PuppetControls
from kinect.body import Floats

# wish: (time constant of its critically damped filter, s; channels it moves at 1, degrees and metres)
_WISHES: Final[dict[str, tuple[float, dict[str, float]]]] = {
    "lean_forward": (0.20, {"trunk.pitch": 34.0, "pelvis.pitch": 16.0, "head.pitch": 24.0, "pelvis.height": -0.02, "zmp.x": 0.030}),
    "lean_back": (0.20, {"trunk.pitch": -13.0, "pelvis.pitch": -5.0, "head.pitch": -4.0, "pelvis.height": -0.02, "zmp.x": -0.030}),
    "lean_left": (0.22, {"trunk.roll": -26.0, "pelvis.roll": -6.0, "head.roll": -18.0, "zmp.y": 0.045}),
    "lean_right": (0.22, {"trunk.roll": 26.0, "pelvis.roll": 6.0, "head.roll": 18.0, "zmp.y": -0.045}),
    "crouch": (0.18, {"pelvis.height": -0.26, "pelvis.pitch": 24.0, "trunk.pitch": 38.0, "head.pitch": 14.0}),
    "guard": (0.11, {"pelvis.height": -0.03, "trunk.pitch": 6.0, "zmp.x": 0.010}),
    "wave": (0.15, {"trunk.roll": -3.0, "head.yaw": -6.0}),
    "raise_left": (0.20, {}),
    "raise_right": (0.20, {}),
    "thrust_left": (0.075, {"trunk.yaw": -12.0, "pelvis.yaw": -5.0, "trunk.pitch": 4.0}),
    "thrust_right": (0.075, {"trunk.yaw": 12.0, "pelvis.yaw": 5.0, "trunk.pitch": 4.0}),
}
_NAMES: Final = tuple(_WISHES)
_RATES: Final[Floats] = np.array([1.0 / _WISHES[name][0] for name in _NAMES])
_BUSY: Final = {"lean_forward": 0.3, "lean_back": 0.3, "lean_left": 0.0, "lean_right": 0.0, "crouch": 0.3}
_OFF_BALANCE: Final[Floats] = np.array([_BUSY.get(name, 1.0) for name in _NAMES])  # share of a wish that counts on one foot or none

_HANGS: Final = {"lean_forward": 26.0, "crouch": 34.0, "lean_back": -8.0}  # degrees of flex that let the arms hang beside a bent trunk
_GUARD: Final = {"flex": 38.0, "side": 12.0, "twist": -12.0, "elbow": 122.0}
_RAISE: Final = {"flex": 158.0, "side": 10.0, "twist": 0.0, "elbow": 12.0}
_WAVE: Final = {"flex": 14.0, "side": 88.0, "twist": 84.0, "elbow": 78.0}
_THRUST: Final = {"flex": 86.0, "side": -2.0, "twist": -40.0, "elbow": 16.0}
_WAVES_HZ: Final = 1.15
_WAVES_DEG: Final = 38.0


@dataclass
class Posture:
    """The wishes after their filters, advancing frame by frame."""

    value: Floats = field(default_factory=lambda: np.zeros(len(_NAMES)))
    rate: Floats = field(default_factory=lambda: np.zeros(len(_NAMES)))

    def step(self, controls: PuppetControls, step_s: float, on_both_feet: bool) -> None:
        """Move every wish towards the controls; in a step, a kick or a jump leaning and crouching count little."""
        wanted = np.array([_wish(controls, name) for name in _NAMES])
        if not on_both_feet:
            wanted *= _OFF_BALANCE
        off = self.value - wanted
        slope = (self.rate + _RATES * off) * step_s
        decay = np.exp(-_RATES * step_s)
        self.value = wanted + (off + slope) * decay
        self.rate = (self.rate - _RATES * slope) * decay

    def channels(self, time_s: float) -> dict[str, float]:
        """Every channel of `STANDING`, metres and degrees."""
        wish = dict(zip(_NAMES, (float(v) for v in self.value), strict=True))
        channels = dict(STANDING)
        for name, (_, moves) in _WISHES.items():
            for channel, size in moves.items():
                channels[channel] += size * wish[name]
        for side in SIDES:
            for joint, angle in _arm(side, wish, time_s).items():
                channels[f"{side}.{joint}"] = angle
        return channels


def _wish(controls: PuppetControls, name: str) -> float:
    opposite = {"lean_back": "lean_forward", "lean_right": "lean_left"}
    value = -float(getattr(controls, opposite[name])) if name in opposite else float(getattr(controls, name))
    return min(1.0, max(0.0, value))  # max() also turns NaN into 0


def _arm(side: str, wish: dict[str, float], time_s: float) -> dict[str, float]:
    arm = {joint: STANDING[f"{side}.{joint}"] for joint in _GUARD}
    level = sum(size * wish[name] for name, size in _HANGS.items())
    arm["flex"] += level
    thrust = _THRUST | {"flex": _THRUST["flex"] + level}  # straight ahead however the trunk bends
    waving = _WAVE | {"elbow": _WAVE["elbow"] - _WAVES_DEG * float(np.sin(2.0 * np.pi * _WAVES_HZ * time_s))}
    poses = [(wish["guard"], _GUARD), (wish[f"raise_{side}"], _RAISE)]
    poses += [(wish["wave"], waving)] if side == "right" else []
    for share, pose in (*poses, (wish[f"thrust_{side}"], thrust)):
        arm = {joint: (1.0 - share) * angle + share * pose[joint] for joint, angle in arm.items()}
    return arm
