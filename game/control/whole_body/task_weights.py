"""What the tasks of a tick weigh: by the tunables, by the feet that stand, and by how the body braces itself."""

import math

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import JOINT_COUNT
from game.control.whole_body.bracing import Bracing
from game.control.whole_body.posed_tick import Numbers
from game.tunables import Settings

Floats = NDArray[np.float64]

SPIN_RATE, BACK_RATE, LARGEST_BACK = 4.0, 10.0, 2.0
"""1/s of angular momentum; 1/s and rad/s of the way back to the target's pose that it may be used for."""

PLANNED = 0.9
"""Share of a joint's strength that is planned with; the rest holds it to its plan between two ticks."""

HELD_BY_RAD_S = 8.0
"""A limb that loses what it pushed against between two ticks is held at least as if it took its whole strength this far off its speed."""

HOLD_IN_THE_AIR = 0.5
"""Share of the hold that a flying body has: its landing throws a knee by 7 rad/s, which a firmer hold would answer with more than a joint
has."""

COM_WEIGHT = np.array([15000.0, 15000.0, 500.0])


def _joint_weight(standing: tuple[int, ...]) -> Floats:
    """(42,) arms, spine and neck, legs that stand, legs that swing."""
    out = np.full(JOINT_COUNT, 0.6)
    out[:2] = 2.0
    out[8:11] = 0.25 if 0 in standing else 0.3
    out[11:14] = 0.25 if 1 in standing else 0.3
    return np.repeat(out, 3)


JOINT_WEIGHT: dict[tuple[int, ...], Floats] = {standing: _joint_weight(standing) for standing in ((), (0,), (1,), (0, 1))}


class TaskWeights:
    """Reads the tunables anew where one was turned or another tick is asked for. strength (2, 42) N m: scaled; full_strength: a man's."""

    def __init__(self, settings: Settings, full_strength: Floats) -> None:
        self._settings, self.full_strength = settings, full_strength
        self._read = -1, 0.0

    def numbers(self, turns: bool, flies: bool, braced: Bracing, dt: float) -> Numbers:
        """turns: False for a body that leaves the floor or meets it and must not; flies: nothing of it stands."""
        number, key = self._settings.number, (self._settings.version, dt)
        if self._read != key:
            self._read = key
            self.strength = number("whole_body.strength") * self.full_strength
            self._numbers = Numbers(
                number("whole_body.pose_stiffness"), number("whole_body.pose_damping"), number("whole_body.pelvis_weight"),
                number("whole_body.spin_weight"), SPIN_RATE, BACK_RATE, LARGEST_BACK, number("whole_body.hold"), PLANNED,
                HELD_BY_RAD_S, dt,
            )  # fmt: skip
        own = self._numbers._replace(hold=HOLD_IN_THE_AIR * self._numbers.hold) if flies else self._numbers
        if turns:
            return own._replace(
                pose_stiffness=own.pose_stiffness * braced.pose, pose_damping=own.pose_damping * math.sqrt(braced.pose),
                pelvis_weight=own.pelvis_weight * braced.pelvis, spin_weight=own.spin_weight * braced.spin,
            )  # fmt: skip
        return own._replace(back_rate=0.0)
