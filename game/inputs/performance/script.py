"""What a motion prescribes: posture channels, which feet are on the floor, and where the weight rests."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

import numpy as np

from game.inputs.performance.curves import Curve, keys
from kinect.body import Floats

Side = Literal["left", "right"]
SIDES: Final[tuple[Side, Side]] = ("left", "right")

STANCE_Y_M: Final = 0.100
"""Half the distance between the ankles."""
ANKLE_X_M: Final = -0.055
"""The ankles lie behind the origin, above which the standing person's centre of mass rests."""
TOE_OUT_DEG: Final = 6.0

_ARM_IDLE: Final = {"flex": 3.0, "side": 6.0, "twist": 0.0, "elbow": 14.0}

STANDING: Final[Mapping[str, float]] = {
    "pelvis.height": 0.968,
    **{f"{part}.{turn}": 0.0 for part in ("pelvis", "trunk", "head") for turn in ("pitch", "roll", "yaw")},
    **{f"{side}.{turn}": value for side in SIDES for turn, value in _ARM_IDLE.items()},
    **{f"{side}.{move}": 0.0 for side in SIDES for move in ("forward", "out", "lift", "tilt")},
    "zmp.x": 0.0,
    "zmp.y": 0.0,
}
"""Every channel with its value in quiet standing: metres, angles in degrees.

pelvis.height is HIP_CENTER above the floor. pitch bows forward, roll leans to the person's right, yaw turns to the left, each
of pelvis, trunk and head against the world. Arm: flex raises it forward, side outward, twist turns the forearm outward, elbow bends.
Foot: forward, out and lift move the ball of the foot from its standing place, tilt raises the heel above it. zmp is where the
ground force acts.
"""

Lift = tuple[float, float]


@dataclass(frozen=True)
class Script:
    """One motion: curves for the channels that leave quiet standing.

    channels: name -> curve, names of STANDING. airborne: side -> (leaves, lands) times, s, when that foot is off the floor.
    com_rise: height of the centre of mass above its standing height, m; where given it replaces pelvis.height (a jump).
    """

    length_s: float
    channels: Mapping[str, Curve]
    airborne: Mapping[Side, tuple[Lift, ...]] = field(default_factory=dict)
    com_rise: Curve | None = None

    def __post_init__(self) -> None:
        unknown = set(self.channels) - set(STANDING)
        if unknown:
            raise ValueError(f"Unknown channels {sorted(unknown)}; valid: {', '.join(STANDING)}.")

    def sample(self, t: Floats) -> dict[str, Floats]:
        """Every channel at times t (T,), angles in radians."""
        values = {}
        for name, idle in STANDING.items():
            curve = self.channels.get(name)
            value = np.full(np.shape(t), idle) if curve is None else curve(t)
            turn = name.rsplit(".", 1)[1]
            values[name] = np.radians(value) if turn in _ANGLES else value
        return values

    def on_floor(self, t: Floats, side: Side) -> np.ndarray:
        """(T,) True where that foot bears on the floor."""
        up = np.zeros(np.shape(t), bool)
        for leaves, lands in self.airborne.get(side, ()):
            up |= (t > leaves) & (t < lands)
        return ~up


_ANGLES: Final = frozenset({"pitch", "roll", "yaw", "flex", "side", "twist", "elbow", "tilt"})


def from_idle(channel: str, *pairs: tuple[float, float]) -> Curve:
    """Keys that start and end with the channel's standing value: it leaves it at the first time and regains it at the last."""
    idle = STANDING[channel]
    return keys((pairs[0][0], idle), *pairs[1:-1], (pairs[-1][0], idle))


def both(turn: str, curve: Curve) -> dict[str, Curve]:
    """The same curve for the left and the right limb."""
    return {f"{side}.{turn}": curve for side in SIDES}
