"""How a body that is thrown weighs its tasks: the trunk before all, the arms free to swing, until it has saved its balance."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import JOINT_COUNT, JOINTS
from game.control.whole_body.felt_push import FeltPush
from game.control.whole_body.footing import Footing

Floats = NDArray[np.float64]

PUSHED_M_S2, THROWN_S = 1.2, 1.0
"""A body braces itself while a push that accelerates it so much is felt, and in steps that begin so long after one at most, or that go
round the other leg."""

SOFT = 0.625
"""Share of the stiffness of its pose that it keeps: what the limbs give way they take out of the push."""


def _joints(trunk: float, shoulder: float, elbow: float, wrist: float) -> Floats:
    """(42,) of spine and neck, and of the arms; legs stay as they are."""
    factor = {"spine": trunk, "neck": trunk, "shoulder": shoulder, "elbow": elbow, "wrist": wrist}
    return np.repeat([factor.get(joint.partition("_")[0], 1.0) for joint in JOINTS], 3)


@dataclass(frozen=True, eq=False)
class Bracing:
    """Factors of weights: com (3,), joints (42,), pelvis, spin, of the foot that swings (6,); of the capture point's rate; and of the
    stiffness that holds the pose, the damping by its root.

    lasts_s: so long after a step.
    """

    com: Floats
    joints: Floats
    pelvis: float
    spin: float
    swing: Floats
    rate: float
    pose: float
    lasts_s: float


CALM = Bracing(np.ones(3), np.ones(3 * JOINT_COUNT), 1.0, 1.0, np.ones(6), 1.0, 1.0, 0.0)
STRAIGHT = Bracing(np.array([1.23, 1.23, 1.65]), _joints(5.68, 1.0, 1.0, 3.0), 2.52, 0.49, np.full(6, 1.92), 1.55, SOFT, 0.65)
ROUND = Bracing(
    np.array([0.216, 0.216, 2.08]), _joints(5.0, 2.46, 2.46, 3.0), 2.14, 0.54, np.array([1.24, 1.24, 1.24, 5.0, 5.0, 5.0]), 2.04, SOFT, 0.44
)
"""Of a body that nothing throws, of one that steps on the foot's own side, and of one that steps round the other leg; found by a search
over pushes from all sides."""

MENDING = replace(STRAIGHT, com=np.array([4.0, 4.0, 1.65]), swing=np.ones(6), rate=1.5)
"""Of one that puts a foot right meanwhile: over one foot the COM goes before all, or the capture point leaks out of it."""


def bracing(footing: Footing, felt: FeltPush) -> Bracing:
    """CALM but while a push is felt, and during the steps that save the balance from it, or go round the other leg, and a little longer,
    when a foot may be put right already."""
    way = ROUND if footing.rounds else STRAIGHT
    if any(foot.mends for foot in footing.feet):
        way = MENDING
    pushed = math.hypot(*felt.acceleration) > PUSHED_M_S2
    saves = footing.saved_s < way.lasts_s and (felt.thrown_s < THROWN_S or footing.rounds)
    return way if pushed or saves else CALM
