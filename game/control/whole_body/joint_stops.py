"""Stops at the ends of the joints' ranges: past them ligaments hold a joint, whatever its muscles are to do."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.joint_limits import HIGH, LOW, in_range_of
from game.compiled import compiled

Floats = NDArray[np.float64]

STOP_RAD, LIGAMENTS = 0.12, 3.0
"""So far past the end of its range a joint meets as much resistance as so many times its muscles: ligaments, not muscles, stop it."""

LEAST_STOP_NM = 25.0
"""No stop is weaker: a wrist has to bear what falls on the hand."""

STOP_S = 0.02
"""The stop damps as a spring that settles in this time."""

SLACK_RAD, STANDING_SOON_S, STANDING_LIGAMENTS = 0.06, 0.01, 1.0
"""A body that keeps its balance keeps its ranges by itself: a stop waits so far past the end, looks so much less ahead, and is softer, for
it takes the plan by surprise."""


@compiled
def stop_of(
    rotation: Floats, velocity: Floats, least: Floats, most: Floats, low: Floats, high: Floats, ligaments: float, slack_rad: float,
    soon_s: float, back: Floats,
) -> tuple[float, float]:  # fmt: skip
    """N m/rad of the stop that a joint meets within `soon_s`, 0 where it meets none, and how far past it the joint is now, rad.

    Fills back (3,), the axis about which the stop turns the joint back. rotation (4,), velocity (3,) rad/s; least, most (3,) rad are its
    range, low, high (3,) N m the strength of its muscles: of those on the other side the ligaments have a multiple.
    """
    strength = _way_back(one.multiply(rotation, one.exp(soon_s * velocity)), least, most, low, high, slack_rad, back)
    far = one.length(back)
    if far == 0.0:
        return 0.0, 0.0
    back /= far
    now = np.empty(3)
    _way_back(rotation, least, most, low, high, slack_rad, now)
    return max(ligaments * strength, LEAST_STOP_NM) / STOP_RAD, max(one.dot(now, back), 0.0)


@compiled
def _way_back(rotation: Floats, least: Floats, most: Floats, low: Floats, high: Floats, slack_rad: float, way: Floats) -> float:
    """Fill way (3,) rad, child frame, from `rotation` to its range; the strength of the muscles on the other side, N m.

    Far from straight the axes of the range are not those of the joint, so that no axis of the way is left out.
    """
    angle, strength = in_range_of(rotation, least, most), 0.0
    for axis in range(3):
        if angle[axis] > most[axis] + slack_rad:
            angle[axis], strength = most[axis] + slack_rad, max(strength, -low[axis])
        elif angle[axis] < least[axis] - slack_rad:
            angle[axis], strength = least[axis] - slack_rad, max(strength, high[axis])
    way[:] = 0.0
    if strength > 0.0:
        way[0], way[1], way[2] = one.turn_to(rotation, one.exp(angle))
    return strength


@compiled
def add_stops(
    joint_rotation: Floats, velocity: Floats, low: Floats, high: Floats, ligaments: float, slack_rad: float, soon_s: float, off: Floats,
    kp: Floats, kd: Floats,
) -> bool:  # fmt: skip
    """Edit a joint command where a joint will be past its range by more than `slack_rad` in `soon_s`; whether any will.

    joint_rotation (14, 4), velocity (42,) rad/s; low, high (42,) N m, the strength of the muscles; off (42,) rad, child frames, from where
    the joints are to where they are wanted, with kp and kd (42,).
    """
    stopped, back = False, np.empty(3)
    for j in range(len(joint_rotation)):
        rows = slice(3 * j, 3 * j + 3)
        stop, past = stop_of(
            joint_rotation[j], velocity[rows], LOW[j], HIGH[j], low[rows], high[rows], ligaments, slack_rad, soon_s, back
        )  # fmt: skip
        if stop == 0.0:
            continue
        stopped = True
        for axis in range(3):
            row, share = 3 * j + axis, abs(back[axis])
            torque = kp[row] * off[row] + stop * past * back[axis]
            kp[row] += share * stop
            kd[row] += STOP_S * share * stop
            off[row] = torque / max(kp[row], 1e-9)
    return stopped


def stopped(joint_rotation: Floats, velocity: Floats, strength: Floats, speed: Floats, damping: Floats) -> tuple[Floats, Floats]:
    """rotation (14, 4) and kp (42,) of a joint command for a body that keeps its balance; strength (2, 42) N m.

    Edits what holds the joints to its plan, speed (42,) rad/s and damping (42,): along the way of its stop a joint is to rest.
    """
    kp = np.zeros(len(speed))
    rotation = _stop(joint_rotation, velocity, strength[0], strength[1], speed, damping, kp)
    return rotation, kp


@compiled
def _stop(joint_rotation: Floats, velocity: Floats, low: Floats, high: Floats, speed: Floats, damping: Floats, kp: Floats) -> Floats:
    off = np.zeros(len(kp))
    if not add_stops(joint_rotation, velocity, low, high, STANDING_LIGAMENTS, SLACK_RAD, STANDING_SOON_S, off, kp, damping):
        return joint_rotation
    rotation = joint_rotation.copy()
    for j in range(len(joint_rotation)):
        rows = slice(3 * j, 3 * j + 3)
        stop = one.length(kp[rows])
        if stop > 0.0:
            rotation[j] = one.multiply(joint_rotation[j], one.exp(off[rows]))
            speed[rows] *= 1.0 - kp[rows] / stop
    return rotation
