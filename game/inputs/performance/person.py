"""The synthetic person: bone lengths of a man of 1.75 m and the mass distribution of one of 75 kg.

Segment masses, centres and radii of gyration: P. de Leva, "Adjustments to Zatsiorsky-Seluyanov's segment
inertia parameters", J. Biomechanics 29 (1996), table 4, males. Nothing here comes from the character's boxes.
Frames of the body parts: x forward, y left, z up, in the idle pose parallel to the world; metres, kilograms.
"""

from typing import Final

import numpy as np

from kinect.body import JOINT_COUNT, Floats, Joint

HEIGHT_M: Final = 1.75
MASS_KG: Final = 75.0

HIP_IN_PELVIS: Final = np.array([0.0, 0.088, -0.070])
"""Left hip joint from HIP_CENTER; the right one is its mirror image."""
SPINE_IN_PELVIS: Final = np.array([-0.010, 0.0, 0.075])
NECK_IN_TRUNK: Final = np.array([0.0, 0.0, 0.405])
"""SHOULDER_CENTER from SPINE."""
SHOULDER_IN_TRUNK: Final = np.array([0.0, 0.180, 0.355])
"""Left shoulder from SPINE."""
HEAD_ABOVE_NECK: Final = np.array([0.020, 0.0, 0.185])

UPPER_ARM_M: Final = 0.290
FOREARM_M: Final = 0.260
HAND_M: Final = 0.085
"""WRIST to HAND, the middle of the palm."""
THIGH_M: Final = 0.420
SHIN_M: Final = 0.410

ANKLE_HEIGHT_M: Final = 0.080
BALL_AHEAD_M: Final = 0.130
"""From below the ankle to the ball of the foot, about which the heel rises."""
TOE_AHEAD_M: Final = 0.200
HEEL_BEHIND_M: Final = 0.060
SOLE_WIDTH_M: Final = 0.100
FOOT_JOINT_HEIGHT_M: Final = 0.020
"""The sensor's FOOT joint lies above the ball of the foot."""

_Shares = list[tuple[float, dict[Joint, float]]]


def _rod(percent: float, centre: float, gyration: float, proximal: Joint, distal: Joint) -> _Shares:
    """Two half masses on a bone, with the segment's own centre and transverse moment of inertia."""
    return [(percent / 2, {proximal: 1 - at, distal: at}) for at in (centre - gyration, centre + gyration)]


def _side(hip: Joint, knee: Joint, ankle: Joint, foot: Joint, shoulder: Joint, elbow: Joint, wrist: Joint, hand: Joint) -> _Shares:
    return [
        *_rod(14.16, 0.4095, 0.329, hip, knee),
        *_rod(4.33, 0.4459, 0.255, knee, ankle),
        (1.37, {ankle: 0.58, foot: 0.42}),
        *_rod(2.71, 0.5772, 0.285, shoulder, elbow),
        *_rod(1.62, 0.4574, 0.276, elbow, wrist),
        (0.61, {hand: 0.8, wrist: 0.2}),
    ]


_SHARES: Final[_Shares] = [
    (6.94, {Joint.HEAD: 1.0}),
    *_rod(15.96, 0.72, 0.20, Joint.SPINE, Joint.SHOULDER_CENTER),
    *_rod(16.33, 0.20, 0.25, Joint.SPINE, Joint.SHOULDER_CENTER),
    (11.17, {Joint.HIP_CENTER: 0.4, Joint.HIP_LEFT: 0.3, Joint.HIP_RIGHT: 0.3}),
    *_side(
        Joint.HIP_LEFT, Joint.KNEE_LEFT, Joint.ANKLE_LEFT, Joint.FOOT_LEFT,
        Joint.SHOULDER_LEFT, Joint.ELBOW_LEFT, Joint.WRIST_LEFT, Joint.HAND_LEFT,
    ),
    *_side(
        Joint.HIP_RIGHT, Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT, Joint.FOOT_RIGHT,
        Joint.SHOULDER_RIGHT, Joint.ELBOW_RIGHT, Joint.WRIST_RIGHT, Joint.HAND_RIGHT,
    ),
]  # fmt: skip

POINT_MASSES_KG: Final[Floats] = np.array([percent for percent, _ in _SHARES]) * MASS_KG / 100.0
"""(P,) point masses that stand for the segments; they sum to MASS_KG."""


def _weights() -> Floats:
    table = np.zeros((len(_SHARES), JOINT_COUNT))
    for row, (_, mix) in enumerate(_SHARES):
        for joint, weight in mix.items():
            table[row, joint] = weight
    return table


POINT_WEIGHTS: Final[Floats] = _weights()
"""(P, 20) each point mass as a weighted mean of joints."""

_JOINT_SHARES: Final[Floats] = (POINT_MASSES_KG / MASS_KG) @ POINT_WEIGHTS
"""(20,) of the whole mass, by joint."""


def point_masses(joints: Floats) -> Floats:
    """(T, P, 3) positions of the point masses for (T, 20, 3) joints, metres, same frame."""
    return np.tensordot(joints, POINT_WEIGHTS, axes=(1, 1)).swapaxes(1, 2)


def centre_of_mass(joints: Floats) -> Floats:
    """(T, 3) whole-body centre of mass for (T, 20, 3) joints, metres, same frame."""
    return np.tensordot(joints, _JOINT_SHARES, axes=(1, 0))
