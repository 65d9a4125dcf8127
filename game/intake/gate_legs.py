"""The player's legs: how long they are, how far the sensor has shortened them, and whether it shows them at all.

When a player bows or touches the toes, a Kinect lets HipCenter sink by 0.13 to 0.52 m above nearly straight knees: thigh and shin
shrink. Bones do not, so a leg rebuilt with its own bone lengths along the sensed directions tells how high the hip really is.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled
from kinect.body import Joint

Floats = NDArray[np.float64]

HIPS = (Joint.HIP_LEFT, Joint.HIP_RIGHT)
KNEES = (Joint.KNEE_LEFT, Joint.KNEE_RIGHT)
ANKLES = (Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT)
FEET = (Joint.FOOT_LEFT, Joint.FOOT_RIGHT)
FOOT_JOINTS = np.array((ANKLES, FEET)).T
"""(2, 2) ankle and toes of the left and of the right foot."""

LEGS = np.array((HIPS, KNEES, ANKLES)).T
"""(2, 3) hip, knee and ankle of the left and of the right leg."""

_ROOT, _NECK = int(Joint.HIP_CENTER), int(Joint.SHOULDER_CENTER)

LENGTH_TIME_S = 2.0
"""How slowly the bone lengths follow what upright standing shows."""

STRANGE_SHARE, STRANGE_TIME_S = 0.05, 20.0
"""Legs that are off by more than this share of their length teach ten times more slowly: raised arms pull a sensor's hips up."""

UPRIGHT_RAD = 0.35
STRAIGHT_RAD = 0.45
"""Lengths are learnt while trunk and knees are straighter than this."""

STOOP_M = 0.08
"""Only a player whose shoulder centre is this much lower than in standing can have bowed."""

HIDDEN_SHARE = 0.12
"""Where both legs have lost this share of their height on straight knees, the sensor does not see them."""


Bone = tuple[float, float]
"""Length (m) of a thigh or shin and how far up it points: the z of its unit vector."""

FootSight = tuple[float, float, float, float]
"""x, y, z of an ankle and z of its toes, world m."""


class LegSight(NamedTuple):
    """What a frame shows of the legs: thigh, shin, bend of the knee (rad) on the left and on the right; lean of the trunk (rad), height
    of the shoulder centre (m)."""

    left: tuple[Bone, Bone, float]
    right: tuple[Bone, Bone, float]
    lean_rad: float
    neck_m: float


class Leg(NamedTuple):
    """One leg in one frame. rise_m: by how much its own bone lengths put the hip higher (negative: lower); bend_rad: of the knee."""

    rise_m: float
    bend_rad: float


class LegLengths:
    """Learns thigh and shin of both legs from upright frames and measures every frame against them.

    stoop_m: how much lower than in standing the shoulder centre is in the last frame.
    """

    def __init__(self) -> None:
        self._length: list[list[float]] = []
        self._learnt_s = 0.0
        self._neck_m = math.nan
        self.stoop_m = 0.0

    @property
    def leg_m(self) -> float:
        """Mean length of a leg, hip to ankle, stretched."""
        return 0.5 * (sum(self._length[0]) + sum(self._length[1]))

    def observe(self, sight: LegSight, dt: float, *, standing: bool) -> tuple[Leg, Leg]:
        """Left and right leg; `standing`: both feet are on the floor, so that lengths may be learnt."""
        bones, neck = sight[:2], sight.neck_m
        if not self._length:
            self._length = [[thigh[0], shin[0]] for thigh, shin, _ in bones]
            self._neck_m = neck
        left, right = self._leg(0, bones[0]), self._leg(1, bones[1])
        if standing and max(left.bend_rad, right.bend_rad) < STRAIGHT_RAD and sight.lean_rad < UPRIGHT_RAD:
            # a plain mean at first, then ever slower
            self._learnt_s = min(self._learnt_s + dt, LENGTH_TIME_S)
            off = 0.5 * (abs(left.rise_m) + abs(right.rise_m))
            time_s = self._learnt_s if off < STRANGE_SHARE * self.leg_m else STRANGE_TIME_S
            share = min(1.0, dt / time_s) if time_s > 0.0 else 0.0
            self._neck_m += share * (neck - self._neck_m)
            for length, (thigh, shin, _) in zip(self._length, bones, strict=True):
                length[0] += share * (thigh[0] - length[0])
                length[1] += share * (shin[0] - length[1])
            left, right = self._leg(0, bones[0]), self._leg(1, bones[1])
        self.stoop_m = max(0.0, self._neck_m - neck)
        return left, right

    def hidden(self, legs: tuple[Leg, Leg]) -> bool:
        """Whether both legs are so short, on straight knees, that they cannot have been seen."""
        return self.stoop_m > STOOP_M and all(leg.rise_m > HIDDEN_SHARE * self.leg_m and leg.bend_rad < 2.0 * STRAIGHT_RAD for leg in legs)

    def _leg(self, side: int, bones: tuple[Bone, Bone, float]) -> Leg:
        (thigh, thigh_up), (shin, shin_up), bend = bones
        own_thigh, own_shin = self._length[side]
        return Leg((own_thigh - thigh) * thigh_up + (own_shin - shin) * shin_up, bend)


@compiled
def feet_of(joints: Floats) -> tuple[FootSight, FootSight]:
    """Left and right foot of joints (20, 3), world frame."""
    return _foot(joints, 0), _foot(joints, 1)


@compiled
def _foot(joints: Floats, side: int) -> FootSight:
    ankle, toes = joints[FOOT_JOINTS[side, 0]], joints[FOOT_JOINTS[side, 1]]
    return ankle[0], ankle[1], ankle[2], toes[2]


@compiled
def legs_of(joints: Floats) -> tuple[tuple[Bone, Bone, float], tuple[Bone, Bone, float], float, float]:
    """The fields of a `LegSight`, of joints (20, 3), world frame."""
    return _bones(joints, 0), _bones(joints, 1), _lean(joints), joints[_NECK, 2]


@compiled
def _bones(joints: Floats, side: int) -> tuple[Bone, Bone, float]:
    """Thigh and shin, and the angle between them (rad)."""
    hip, knee, ankle = LEGS[side]
    thigh = joints[hip] - joints[knee]
    shin = joints[knee] - joints[ankle]
    a, b = max(one.length(thigh), 1e-6), max(one.length(shin), 1e-6)
    return (a, thigh[2] / a), (b, shin[2] / b), math.acos(min(1.0, max(-1.0, one.dot(thigh, shin) / (a * b))))


@compiled
def _lean(joints: Floats) -> float:
    """Angle of the trunk, hip centre to shoulder centre, from the vertical, rad."""
    trunk = joints[_NECK] - joints[_ROOT]
    return math.acos(min(1.0, max(-1.0, trunk[2] / max(one.length(trunk), 1e-6))))
