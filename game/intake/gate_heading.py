"""Where pelvis and shoulders face, and how the hips lie, as a body can: seen from the side, both lines are lost in the sensor's depth.

Hips and shoulders are two views of one heading. While they agree they are believed up to a person's fastest turn; where they do not,
the one that lies nearer to where the player faced is followed, slowly, and the other is brought back to it. A line that is much too
short for the player tells nothing: the heading stays, and the hips lie across the back.
"""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled
from game.intake.gate_legs import HIPS
from game.intake.smooth_step import smooth_step
from kinect.body import Joint

Floats = NDArray[np.float64]

DOUBTED_SHARE = 0.2
"""Of the fastest turn, while hips and shoulders disagree."""

FARTHEST_RAD = 1.9
"""A sensor takes everybody to face it; a line that points farther away has its ends mixed up."""

SHORT_SHARE = np.array(((0.08, 0.12), (0.17, 0.25)))
"""Of a leg's length: hips, and shoulders, closer together than the first are not seen, farther apart than the second they are."""

HIPS_SHARE = 0.18
"""Of a leg's length between hips that are not seen."""

MOST_SLANT_RAD = 0.4
"""Between the line of the hips and square across the lower back."""

LEAST_TAKEN = 0.02
"""A line that is not seen still tells in the long run: so much of the way to it is gone in each frame."""

_SHOULDERS = (Joint.SHOULDER_LEFT, Joint.SHOULDER_RIGHT)
_ELBOWS = (Joint.ELBOW_LEFT, Joint.ELBOW_RIGHT)
_LINES = np.array((HIPS, _SHOULDERS))
_ARMS = np.array((_SHOULDERS, _ELBOWS))
_SPINE = int(Joint.SPINE)


class BodyHeading:
    """Follows the headings of one player's pelvis and shoulders."""

    def __init__(self) -> None:
        self._last = np.full(2, np.nan)

    def apply(self, joints: Floats, dt: float, leg_m: float, fastest_rad_s: float, twist_rad: float) -> None:
        """Moves hips, shoulders and elbows of joints (20, 3), world frame, in place.

        leg_m: of the player; fastest_rad_s: of a turn; twist_rad: by how much shoulders and hips can differ.
        """
        if math.isfinite(leg_m) and leg_m > 0.0:
            place_lines(joints, self._last, leg_m, fastest_rad_s * dt, twist_rad)


@compiled
def place_lines(joints: Floats, last: Floats, leg_m: float, most_rad: float, twist_rad: float) -> None:
    """`BodyHeading.apply`; last (2,): the headings of pelvis and shoulders in the frame before, NaN in the first, brought up to date."""
    found, sure, taken = np.empty(2), np.empty(2), np.empty(2)
    for line in range(2):
        across = joints[_LINES[line, 0]] - joints[_LINES[line, 1]]
        found[line] = math.atan2(-across[0], across[1])
        low, high = SHORT_SHARE[line]
        sure[line] = smooth_step((math.hypot(across[0], across[1]) / leg_m - low) / (high - low))
        taken[line] = max(sure[line], LEAST_TAKEN)
        if abs(found[line]) > FARTHEST_RAD:
            sure[line] = taken[line] = 0.0
    if math.isnan(last[0]):
        best = found[0] if sure[0] >= sure[1] else found[1]
        last[:] = best if max(sure[0], sure[1]) > 0.0 else 0.0
        most_rad = math.pi
    _follow(found, taken, last, most_rad, twist_rad)
    _place_hips(joints, found[0], last[0], sure[0], leg_m)
    if last[1] != found[1]:
        _turn_shoulders(joints, last[1] - found[1])


@compiled
def _follow(found: Floats, taken: Floats, last: Floats, most_rad: float, twist_rad: float) -> None:
    """Bring the headings `last` (2,) on towards the ones `found` (2,), by the shares `taken` (2,)."""
    hips, shoulders = _between(last[0], found[0], taken[0]), _between(last[1], found[1], taken[1])
    believed = hips
    if abs(shoulders - hips) > twist_rad:
        most_rad *= DOUBTED_SHARE
        if abs(shoulders - last[1]) < abs(hips - last[0]):
            believed = shoulders - math.copysign(twist_rad, shoulders - hips)
    last[0] = min(max(believed, last[0] - most_rad), last[0] + most_rad)
    shoulders = min(max(shoulders, last[0] - twist_rad), last[0] + twist_rad)
    last[1] = min(max(shoulders, last[1] - most_rad), last[1] + most_rad)


@compiled
def _place_hips(joints: Floats, found: float, heading: float, sure: float, leg_m: float) -> None:
    """Turn the hips' line from the heading `found` to this one and lay it no more aslant than hips are.

    Hips that are not seen (sure 0) lie square across the back.
    """
    left, right = _LINES[0]
    across = joints[left] - joints[right]
    middle = 0.5 * (joints[left] + joints[right])
    up = one.normalise(joints[_SPINE] - middle)
    length = one.length(across)
    slant = math.asin(min(max(one.dot(across, up) / max(length, 1e-9), -1.0), 1.0))
    if sure == 1.0 and abs(slant) <= MOST_SLANT_RAD and heading == found:
        return
    slant = sure * min(max(slant, -MOST_SLANT_RAD), MOST_SLANT_RAD)
    length = sure * length + (1.0 - sure) * HIPS_SHARE * leg_m
    square = np.zeros(3)
    square[0], square[1] = -math.sin(heading), math.cos(heading)
    square = one.normalise(square - one.dot(square, up) * up)
    half = 0.5 * length * (math.cos(slant) * square + math.sin(slant) * up)
    joints[left], joints[right] = middle + half, middle - half


@compiled
def _turn_shoulders(joints: Floats, angle_rad: float) -> None:
    """Turn the shoulders about the vertical through their middle; an elbow comes half of its shoulder's way."""
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    left, right = _LINES[1]
    x, y = 0.5 * (joints[left, 0] - joints[right, 0]), 0.5 * (joints[left, 1] - joints[right, 1])
    move_x, move_y = c * x - s * y - x, s * x + c * y - y
    for side in range(2):
        sign = 1.0 if side == 0 else -1.0
        for k in range(2):
            joints[_ARMS[k, side], 0] += sign * move_x / (1.0 + k)
            joints[_ARMS[k, side], 1] += sign * move_y / (1.0 + k)


@compiled
def _between(before: float, after: float, share: float) -> float:
    """From the first at 0 to the second at 1, exactly."""
    return after if share == 1.0 else before + share * (after - before)
