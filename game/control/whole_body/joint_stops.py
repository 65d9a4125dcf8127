"""Stops at the ends of the joints' ranges: past them ligaments hold a joint, whatever its muscles are to do."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.joint_limits import HIGH, LOW, in_range_of
from game.compiled import compiled

Floats = NDArray[np.float64]

STOP_RAD, LIGAMENTS = 0.12, 2.0
"""So far past the end of its range a joint meets as much resistance as so many times its muscles: ligaments, not muscles, stop it."""

LEAST_STOP_NM = 15.0
"""No stop is weaker: a wrist has to bear what falls on the hand."""

STOP_S = 0.02
"""The stop damps as a spring that settles in this time."""

SLACK_RAD, STANDING_SOON_S = 0.03, 0.01
"""A body that keeps its balance keeps its ranges by itself: a stop waits so far past the end, and so much less ahead."""


@compiled
def add_stops(
    joint_rotation: Floats, velocity: Floats, low: Floats, high: Floats, slack_rad: float, soon_s: float, wanted: Floats,
    kp: Floats, kd: Floats,
) -> bool:  # fmt: skip
    """Edit wanted (42,) rad, kp and kd (42,) where a joint will be past its range by more than `slack_rad` in `soon_s`; whether any will.

    joint_rotation (14, 4), velocity (42,) rad/s; low, high (42,) N m, the strength of the muscles: back from where the joint is, that of
    those on the other side sets the measure.
    """
    stopped = False
    for j in range(len(joint_rotation)):
        angle = in_range_of(joint_rotation[j], LOW[j], HIGH[j])
        for axis in range(3):
            row = 3 * j + axis
            soon = angle[axis] + soon_s * velocity[row]
            over, under = soon > HIGH[j, axis] + slack_rad, soon < LOW[j, axis] - slack_rad
            if over or under:
                stop = max(LIGAMENTS * (-low[row] if over else high[row]), LEAST_STOP_NM) / STOP_RAD
                kp[row] += stop
                kd[row] += STOP_S * stop
                wanted[row] = HIGH[j, axis] + slack_rad if over else LOW[j, axis] - slack_rad
                stopped = True
    return stopped


def stopped(joint_rotation: Floats, velocity: Floats, strength: Floats, speed: Floats, damping: Floats) -> tuple[Floats, Floats]:
    """rotation (14, 4) and kp (42,) of a joint command for a body that keeps its balance; strength (2, 42) N m.

    Edits what holds the joints to its plan, speed (42,) rad/s and damping (42,): a joint that is stopped is held to rest.
    """
    kp = np.zeros(len(speed))
    rotation = _stop(joint_rotation, velocity, strength[0], strength[1], speed, damping, kp)
    return rotation, kp


@compiled
def _stop(joint_rotation: Floats, velocity: Floats, low: Floats, high: Floats, speed: Floats, damping: Floats, kp: Floats) -> Floats:
    wanted = np.empty(len(kp))
    for j in range(len(joint_rotation)):
        wanted[3 * j : 3 * j + 3] = in_range_of(joint_rotation[j], LOW[j], HIGH[j])
    if not add_stops(joint_rotation, velocity, low, high, SLACK_RAD, STANDING_SOON_S, wanted, kp, damping):
        return joint_rotation
    rotation = joint_rotation.copy()
    for j in range(len(joint_rotation)):
        held = False
        for axis in range(3):
            if kp[3 * j + axis] > 0.0:
                speed[3 * j + axis], held = 0.0, True
        if held:
            rotation[j] = one.exp(wanted[3 * j : 3 * j + 3])
    return rotation
