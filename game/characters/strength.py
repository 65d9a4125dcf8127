"""How strong a human's joints are: peak isometric torques of grown men per kilogram of body mass, with where each number is from.

The legs' flexion and extension: Anderson, Madigan & Nussbaum 2007, J Biomech 40:3105, Table 3, men of 18 to 25: share c1 of body
weight times height. All else is in N m per kg; where a source gives N m only, the mass it was divided by is a guess and said so.

- hip abduction: Sugimoto et al. 2014 (Clin J Sport Med 24:422), 1.29 at 60 deg/s, taken a fifth higher at rest (estimate);
  adduction and rotation estimated into the order of Cahalan et al. 1989: extension, flexion, adduction, abduction, rotation.
- ankle inversion and eversion: da Fonseca et al. 2025 (World J Orthop 16:108858), 35 and 30 N m over an assumed 75 kg, a fifth
  higher at rest as above (estimate).
- trunk extension: 200 ft lb at 24 degrees of flexion, 70 men (J Korean Acad Rehabil Med 21:1, 1997), over an assumed 70 kg;
  flexion half of it, side bending as flexion, axial rotation half as much again less: estimates.
- neck: Fice, Siegmund & Blouin 2014 (Ann Biomed Eng), 30 flexion, 51 extension, 32 to the side, 13 axial N m, assumed 80 kg.
- shoulder flexion: 89.9 N m, static at 0 degrees, 26 men (dynamic shoulder flexion strength study, Clin Biomech), assumed 77 kg;
  extension 5 to 4, inward to outward rotation 3 to 2 (Ivey et al. 1985); adduction 67.9 N m of men and women together (Holzbaur
  et al. 2007), taken as 1.2 per kg for men; abduction half of it (Ivey); rotation itself an estimate.
- elbow: Lategan & Kruger 2003, 0.78 flexion and 0.67 extension, isokinetic, taken a fifth higher at rest (estimate).
- forearm: O'Sullivan & Gallwey 2002, 16.2 supination and 13.1 pronation N m, assumed 75 kg.
- wrist: Delp, Grierson & Buchanan 1996, 12.2 flexion, 7.1 extension, 11.0 radial, 9.5 ulnar N m, assumed 75 kg.
- what no muscle turns (a knee sideways, a foot on the shank's axis) is held by ligaments and bone: estimates.

The mapping leaves out how limbs twist about their length, so an elbow or wrist may bend about any axis across it: those axes get the
same strength both ways. Strength at other angles, and that it falls with speed from the first radian per second on, is left out.
"""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from game.characters.body_plan import BodyPlan
from game.characters.skeleton import JOINTS

Floats = NDArray[np.float64]

_GRAVITY = 9.81
_C1 = {"hip extension": 0.161, "hip flexion": 0.113, "knee extension": 0.163, "knee flexion": 0.087, "plantar": 0.095, "dorsal": 0.033}
"""Anderson et al. 2007: torque over body weight and height."""

_HEIGHT_M = 1.80
"""For which the shares are brought to N m per kg, so that boxes of any proportions are as strong as their mass."""

_LEG = {name: share * _GRAVITY * _HEIGHT_M for name, share in _C1.items()}

PER_KG: dict[str, tuple[tuple[float, float], ...]] = {
    "spine": ((2.0, 2.0), (3.9, 2.0), (1.0, 1.0)),
    "neck": ((0.40, 0.40), (0.64, 0.38), (0.16, 0.16)),
    "shoulder": ((1.20, 0.60), (1.17, 1.46), (0.65, 0.43)),
    "elbow": ((0.94, 0.94), (0.94, 0.94), (0.18, 0.22)),
    "wrist": ((0.16, 0.16), (0.16, 0.16), (0.10, 0.10)),
    "hip": ((1.70, 1.55), (_LEG["hip flexion"], _LEG["hip extension"]), (0.90, 0.90)),
    "knee": ((1.50, 1.50), (_LEG["knee extension"], _LEG["knee flexion"]), (0.60, 0.60)),
    "ankle": ((0.56, 0.48), (_LEG["dorsal"], _LEG["plantar"]), (0.40, 0.40)),
}
"""N m per kg of body mass about the axes x (forward), y (left), z (up) of the child, for a limb of the left side: (minus, plus)."""


@cache
def _per_kg() -> tuple[Floats, Floats]:
    low, high = np.empty((len(JOINTS), 3)), np.empty((len(JOINTS), 3))
    for row, joint in enumerate(JOINTS):
        name, _, side = joint.partition("_")
        for axis, (minus, plus) in enumerate(PER_KG[name]):
            # a mirror swaps the two ways to turn about the axes that lie in it
            swapped = side == "right" and axis != 1
            low[row, axis], high[row, axis] = (-plus, minus) if swapped else (-minus, plus)
    return low.reshape(-1), high.reshape(-1)


def joint_strength(plan: BodyPlan) -> tuple[Floats, Floats]:
    """(low, high), (42,) N m each: the largest torques at rest about the negative and positive axes of the children's frames."""
    low, high = _per_kg()
    return plan.total_mass * low, plan.total_mass * high
