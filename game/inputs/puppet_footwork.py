"""Steps, kicks and jumps: first the weight, then the foot, then both feet again."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np

from game.inputs.performance.balance import GRAVITY
from game.inputs.performance.curves import Curve, bump, keys, through
from game.inputs.performance.script import Side
from game.inputs.puppet_balance import Support
from game.inputs.puppet_controls import PuppetControls

Move = Literal["step", "kick", "jump"]

_STANCE_ZMP_M: Final = 0.094  # over the inner half of the sole, as people stand on one leg
_FOOT_X_M: Final = (-0.09, 0.12)
_INNER_M, _OUTER_M = 0.040, 0.026  # how far the ground force may leave the middle of the standing foot
_READY_M: Final = 0.037  # the foot lifts once the capture point is this near to the standing foot's middle
_RETURN_S: Final = 0.20  # before it lands the weight begins to fall back towards it
_LONGEST_SHIFT_S: Final = 1.0

STEP_S: Final = 0.48
KICK_S: Final = 1.10
CROUCHED_S, LEAVES_S, LANDS_S, ABSORBED_S, JUMP_S = 0.50, 0.84, 1.075, 1.385, 2.10
_FLIGHT_S: Final = LANDS_S - LEAVES_S
_LEAVES_M, _LANDS_M, _LOW_M = 0.015, -0.005, -0.150
_LEAVES_M_S: Final = (_LANDS_M - _LEAVES_M) / _FLIGHT_S + GRAVITY * _FLIGHT_S / 2.0


def _jump(crouched: float, aloft: float, absorbed: float) -> Curve:
    return keys((0.0, 0.0), (CROUCHED_S, crouched), (LEAVES_S, aloft), (LANDS_S, aloft), (ABSORBED_S, absorbed), (JUMP_S, 0.0))


# what each move adds to the channels, over its own time; "foot." stands for the moving foot, "stance." for the other
_SWINGS: Final[Mapping[Move, Mapping[str, Curve]]] = {
    "step": {
        "foot.lift": bump(0.0, STEP_S, 0.125),
        "foot.tilt": bump(0.0, STEP_S, 9.0),
        "stance.flex": bump(0.0, STEP_S, 14.0),
        "foot.flex": bump(0.0, STEP_S, -10.0),
    },
    "kick": {
        "foot.lift": keys((0.0, 0.0), (0.34, 0.30), (0.56, 0.40), (0.64, 0.40), (KICK_S, 0.0)),
        "foot.forward": keys((0.0, 0.0), (0.28, -0.02), (0.58, 0.55), (0.64, 0.55), (KICK_S - 0.03, 0.0)),
        "foot.tilt": keys((0.0, 0.0), (0.28, 24.0), (0.56, -42.0), (0.66, -36.0), (KICK_S - 0.06, 0.0)),
        "trunk.pitch": keys((0.0, 0.0), (0.56, -9.0), (KICK_S, 0.0)),
        "stance.flex": keys((0.0, 0.0), (0.56, 26.0), (KICK_S, 0.0)),
        "foot.flex": keys((0.0, 0.0), (0.56, -14.0), (KICK_S, 0.0)),
    },
    "jump": {
        "trunk.pitch": _jump(32.0, 6.0, 24.0),
        "pelvis.pitch": _jump(16.0, 2.0, 12.0),
        "head.pitch": _jump(12.0, 2.0, 8.0),
        **{f"{side}.flex": _jump(-22.0, 30.0, 16.0) for side in ("left", "right")},
        **{f"{side}.elbow": _jump(10.0, 26.0, 18.0) for side in ("left", "right")},
        **{f"{side}.lift": bump(LEAVES_S, LANDS_S, 0.077) for side in ("left", "right")},
        **{
            f"{side}.tilt": keys((0.69, 0.0), (0.88, 26.0), (0.96, 14.0), (LANDS_S - 0.01, 20.0), (LANDS_S + 0.14, 0.0))
            for side in ("left", "right")
        },
        "zmp.x": keys((0.2, 0.0), (0.69, 0.06), (LANDS_S + 0.14, 0.06), (1.685, 0.0)),
    },
}
_RISE: Final[Curve] = through(
    (0.0, 0.0, 0.0, 0.0),
    (CROUCHED_S, _LOW_M, 0.0, 2.0),
    (LEAVES_S, _LEAVES_M, _LEAVES_M_S, -GRAVITY),
    (LANDS_S, _LANDS_M, _LEAVES_M_S - GRAVITY * _FLIGHT_S, -GRAVITY),
    (ABSORBED_S, _LOW_M, 0.0, 1.6),
    (JUMP_S, 0.0, 0.0, 0.0),
)
_BALLISTIC: Final[Curve] = keys((0.1, 0.0), (CROUCHED_S, 1.0), (ABSORBED_S, 1.0), (JUMP_S - 0.1, 0.0))
_LASTS: Final[Mapping[Move, float]] = {"step": STEP_S, "kick": KICK_S, "jump": JUMP_S}


@dataclass
class Footwork:
    """Which foot does what. `step` once a frame, then read the rest."""

    move: Move | None = None
    side: Side = "left"
    shifting: bool = False
    clock_s: float = 0.0
    last_side: Side = "right"

    @property
    def on_both_feet(self) -> bool:
        """Neither a move nor the shift of weight before it is under way."""
        return self.move is None

    def step(self, controls: PuppetControls, capture_y: float, step_s: float) -> None:
        """Advance a move, or begin the one asked for; capture_y is the capture point's y, metres."""
        self.clock_s += step_s
        if self.move is not None and not self.shifting and self.clock_s >= _LASTS[self.move]:
            self.last_side, self.move = self.side, None
        if self.move is None:
            self._begin(controls)
        if self.shifting and (abs(capture_y - self._stance_y()) < _READY_M or self.clock_s > _LONGEST_SHIFT_S):
            self.shifting, self.clock_s = False, 0.0

    def add_to(self, channels: dict[str, float]) -> None:
        """Add the move to posture channels, metres and degrees."""
        if self.move is None:
            return
        if self.move != "jump":
            channels["zmp.x"] = 0.0
            landing = not self.shifting and self.clock_s > _LASTS[self.move] - _RETURN_S
            channels["zmp.y"] = 0.0 if landing else self._stance_y()
        if self.shifting:
            return
        stance: Side = "right" if self.side == "left" else "left"
        for name, curve in _SWINGS[self.move].items():
            channel = name.replace("foot.", f"{self.side}.").replace("stance.", f"{stance}.")
            channels[channel] += float(curve(np.asarray(self.clock_s)))

    def support(self) -> Support | None:
        """Where the ground can push."""
        swinging = self.move is not None and not self.shifting
        if swinging and self.move == "jump":
            return None if LEAVES_S < self.clock_s < LANDS_S else _BOTH
        if swinging:
            edges = sorted(np.sign(self._stance_y()) * np.array([_STANCE_ZMP_M - _INNER_M, _STANCE_ZMP_M + _OUTER_M]))
            return Support(np.array([_FOOT_X_M[0], edges[0]]), np.array([_FOOT_X_M[1], edges[1]]))
        return _BOTH

    def rise(self) -> tuple[float, float]:
        """(height of the centre of mass against standing, m; how strictly it counts, 0..1)."""
        if self.move != "jump" or self.shifting:
            return 0.0, 0.0
        return float(_RISE(np.asarray(self.clock_s))), float(_BALLISTIC(np.asarray(self.clock_s)))

    def _stance_y(self) -> float:
        return -_STANCE_ZMP_M if self.side == "left" else _STANCE_ZMP_M

    def _begin(self, controls: PuppetControls) -> None:
        if controls.jump:
            self.move, self.shifting, self.clock_s = "jump", False, 0.0
            return
        for move, left, right in (("kick", controls.kick_left, controls.kick_right), ("step", controls.step_left, controls.step_right)):
            if left or right:
                other: Side = "left" if self.last_side == "right" else "right"
                self.side = other if left and right else "left" if left else "right"
                self.move, self.shifting, self.clock_s = ("kick" if move == "kick" else "step"), True, 0.0
                return


_BOTH: Final = Support(np.array([_FOOT_X_M[0], -_STANCE_ZMP_M - _OUTER_M]), np.array([_FOOT_X_M[1], _STANCE_ZMP_M + _OUTER_M]))
