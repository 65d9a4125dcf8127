"""Ligaments: past the end of its range something other than muscles holds a joint, whatever its command is, or where there is none."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.joint_limits import HIGH, LOW, in_range_of
from game.compiled import compiled

Floats = NDArray[np.float64]

FIRM_RAD, MUSCLES, LEAST_NM = 0.12, 6.0, 40.0
"""So far past its range a joint is held by so many times its muscles at rest, and by no less than the last: a wrist has to bear what falls
on the hand."""

BRAKE_S = 0.02
"""Ligaments damp as a spring that settles in this time."""

SOON_S = 0.004
"""A joint that will be past its range so much later is braked already: within one step it would be far beyond."""


@compiled
def add_ligaments(position: Floats, velocity: Floats, low: Floats, high: Floats, step_s: float, torque: Floats, damping: Floats) -> None:
    """Add to the applied torque and the joint damping (42,) of the coming step, N m and N m s/rad, of joints at the ends of their ranges.

    position (56,): the joints' rotations; velocity (42,) rad/s; low, high (42,) N m: the strength of their muscles, of which those on the
    other side tell how strong the ligaments are.
    """
    back, now = np.empty(3), np.empty(3)
    for j in range(len(velocity) // 3):
        rows, turn = slice(3 * j, 3 * j + 3), position[4 * j : 4 * j + 4]
        ahead = one.multiply(turn, one.exp(SOON_S * velocity[rows]))
        strength = way_back(ahead, LOW[j], HIGH[j], low[rows], high[rows], back)
        far = one.length(back)
        if far == 0.0:
            continue
        back /= far
        way_back(turn, LOW[j], HIGH[j], low[rows], high[rows], now)
        stiffness, past = max(MUSCLES * strength, LEAST_NM) / FIRM_RAD, max(one.dot(now, back), 0.0)
        for axis in range(3):
            torque[3 * j + axis] += stiffness * past * back[axis]
            # the spring too is taken at the end of the step, as in stable PD
            damping[3 * j + axis] += (BRAKE_S + step_s) * stiffness * abs(back[axis])


@compiled
def way_back(turn: Floats, least: Floats, most: Floats, low: Floats, high: Floats, way: Floats) -> float:
    """Fill way (3,) rad, child frame, from `turn` (4,) to its range; the strength of the muscles on the other side, N m.

    Far from straight the axes of the range are not those of the joint, so that no axis of the way is left out. least, most (3,) rad: the
    range; low, high (3,) N m: the muscles.
    """
    angle, strength = in_range_of(turn, least, most), 0.0
    for axis in range(3):
        if angle[axis] > most[axis]:
            angle[axis], strength = most[axis], max(strength, -low[axis])
        elif angle[axis] < least[axis]:
            angle[axis], strength = least[axis], max(strength, high[axis])
    way[:] = 0.0
    if strength > 0.0:
        way[0], way[1], way[2] = one.turn_to(turn, one.exp(angle))
    return strength
