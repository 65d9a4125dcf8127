"""A foot as the planner sees it: a flat rectangle somewhere on or above the floor."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET
from game.compiled import compiled
from game.control.joint_command import BodyState
from game.control.whole_body.leg_kinematics import LEG_PARTS
from game.control.whole_body.support_polygon import hull_of_soles, sole_corners

Floats = NDArray[np.float64]

PRESSURE_MARGIN_M = 0.01
"""The centre of pressure is kept this far inside the soles."""


class Sole(NamedTuple):
    """A foot as it is: centre of its sole (3,) and yaw, ankle (3,), whether its lowest corner touches; half extents (m)."""

    centre: Floats
    yaw: float
    ankle: Floats
    touches: bool
    half_length: float
    half_width: float

    def corners(self, margin_m: float, ends_m: float = 0.0) -> Floats:
        """(4, 2) less a margin all round, and `ends_m` more at heel and toes."""
        return sole_corners(self.centre, self.yaw, max(self.half_length - margin_m - ends_m, 0.005), max(self.half_width - margin_m, 0.005))


def polygon(soles: tuple[Sole, Sole], left: bool, right: bool, margin_m: float, ends_m: float = 0.0) -> Floats:
    """(n, 2) the hull of one sole or of both, less a margin all round each, and `ends_m` more at heels and toes."""
    a, b = soles
    length, width = max(a.half_length - margin_m - ends_m, 0.005), max(a.half_width - margin_m, 0.005)
    return hull_of_soles(a.centre, a.yaw, b.centre, b.yaw, left, right, length, width)


def soles_of(body: BodyState) -> tuple[Sole, Sole]:
    """The left and the right one."""
    length, width, height = body.plan.foot_half
    centre = np.empty((2, 3))
    left_yaw, right_yaw = _place(body.box_centre, body.turn, height, centre)
    left_touches, right_touches = body.foot_contact
    left, right = FEET
    return (
        Sole(centre[0], left_yaw, body.joint[left], left_touches, length, width),
        Sole(centre[1], right_yaw, body.joint[right], right_touches, length, width),
    )


@compiled
def _place(box_centre: Floats, turn: Floats, height: float, centre: Floats) -> tuple[float, float]:
    """Write the centres (2, 3) of the soles of feet so high; gives their yaws."""
    for side in range(2):
        part = FEET[side]
        for axis in range(3):
            centre[side, axis] = box_centre[part, axis] - height * turn[part, axis, 2]
    left, right = FEET
    return math.atan2(turn[left, 1, 0], turn[left, 0, 0]), math.atan2(turn[right, 1, 0], turn[right, 0, 0])


def ahead_of_ankle(body: BodyState) -> float:
    """m from the ankle to the centre of the sole of a flat foot, forward."""
    return float(body.plan.centre_offset[FEET[0], 0])


def leg_reach(body: BodyState, side: int) -> float:
    """Distance from hip to ankle over the length of the straight leg."""
    x, y, z, length = _leg(body.joint, body.plan.joint_offset, *LEG_PARTS[side])
    return math.sqrt(x * x + y * y + z * z) / length


def rise_left(body: BodyState, side: int) -> float:
    """m that the hip can still rise over the ankle where that stands, until the leg is as good as straight; negative where it is."""
    x, y, z, length = _leg(body.joint, body.plan.joint_offset, *LEG_PARTS[side])
    length *= 0.995
    return math.sqrt(max(length * length - x * x - y * y, 0.0)) - z


@compiled
def _leg(joint: Floats, offset: Floats, thigh: int, shank: int, foot: int) -> tuple[float, float, float, float]:
    """m from ankle to hip, and the length of the straight leg, m; joint and joint_offset (15, 3) of the body and of its plan."""
    way = joint[thigh] - joint[foot]
    return way[0], way[1], way[2], one.length(offset[shank]) + one.length(offset[foot])
