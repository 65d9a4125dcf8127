"""Soft joint limits: a joint that nears the end of its range, or will soon, is asked to stop there, with more weight the nearer it is."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.joint_limits import HIGH, LOW
from game.characters.skeleton import JOINTS
from game.compiled import compiled

Floats = NDArray[np.float64]

EXTRA_WEIGHT = 8.0
"""Of a joint at the end of its range, added to that of its task."""

STIFFNESS, DAMPING = 250.0, 32.0
"""1/s^2 and 1/s, critically damped: a joint that obeys comes to rest at the end of its range and never passes it."""

AHEAD_S = 0.05
"""The range is watched for where the joint will be so much later."""

NEAR_RAD, NEAR_STRAIGHT_RAD = 0.1, 0.22
"""Where the weight begins to grow; a knee, which must never bend backwards, feels it earlier before it is straight."""


def _margins() -> tuple[Floats, Floats]:
    low, high = np.full((len(JOINTS), 3), NEAR_RAD), np.full((len(JOINTS), 3), NEAR_RAD)
    for row, joint in enumerate(JOINTS):
        if joint.startswith("knee"):
            low[row, 1] = NEAR_STRAIGHT_RAD
    return low, high


NEAR_LOW, NEAR_HIGH = _margins()


@compiled
def soft_limits(joint_rotation: Floats, velocity: Floats, weight: Floats, goal: Floats) -> None:
    """Edit the joint tasks in place: weight (42,) and goal (42,) rad/s^2, of joint_rotation (14, 4) and velocity (42,).

    No goal is left that would carry a joint past its range: it may grow towards the end by STIFFNESS times the way left, less DAMPING
    times the speed. That much of it counts by the extra weight; a joint well inside its range is left alone.
    """
    for j in range(len(joint_rotation)):
        angle = one.log(joint_rotation[j])
        for axis in range(3):
            row = 3 * j + axis
            soon = angle[axis] + AHEAD_S * velocity[row]
            over = (soon - HIGH[j, axis]) / NEAR_HIGH[j, axis] + 1.0
            under = (LOW[j, axis] - soon) / NEAR_LOW[j, axis] + 1.0
            if over <= 0.0 and under <= 0.0:
                continue
            end = HIGH[j, axis] if over > under else LOW[j, axis]
            stop = STIFFNESS * (end - angle[axis]) - DAMPING * velocity[row]
            wanted = min(goal[row], stop) if over > under else max(goal[row], stop)
            extra = EXTRA_WEIGHT * min(max(over, under), 1.0)
            goal[row] = (weight[row] * goal[row] + extra * wanted) / (weight[row] + extra)
            weight[row] += extra
