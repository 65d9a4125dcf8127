"""A fall: arms reach for the floor, the head is kept off it, stiffness goes by degrees."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.joint_limits import HIGH, LOW
from game.compiled import compiled
from game.control.whole_body.key_poses import pose_of
from game.control.whole_body.support_polygon import distance_inside

Floats = NDArray[np.float64]

LOST_M = 0.36
"""A COM so far beyond the feet that stand is not caught by a step any more."""

THROWN_M = 0.35
"""Nor a capture point so far: the body would only struggle, and whirl its arms, before it falls."""

TOPPLED_M, TOPPLED_UP = 0.06, 0.45
"""Nor is one much nearer where the trunk has toppled to 63 degrees too; a bow as deep has its COM over the feet."""

LET_GO_S = 1.5
"""How long the stiffness takes from that of a body that braces itself to that of one that lies."""

BRACED_RATE, LIMP_RATE = 9.0, 2.0
"""1/s: the joints follow the protective pose as fast at first, and at last."""

DAMPING_RATE = 30.0
"""1/s at which a joint that nothing moves comes to rest against its own limb; against the whole body it is less."""

LEAST_DAMPING = 9.0
"""N m s/rad: a hand is so light that the floor would throw it about its wrist, and a bent arm about its own length."""


FORWARD = pose_of(neck=(0, -0.4, 0), shoulder=(0.2, -1.3, 0), elbow=(0, -0.5, 0), hip=(0.1, -0.3, 0), knee=(0, 0.5, 0))
BACKWARD = pose_of(neck=(0, 0.6, 0), spine=(0, 0.5, 0), shoulder=(0.5, 0.5, 0), elbow=(0, -0.4, 0), hip=(0.1, -1.0, 0), knee=(0, 1.0, 0))
SIDEWAYS = pose_of(neck=(0, 0.2, 0), shoulder=(1.0, -0.4, 0), elbow=(0, -0.6, 0), hip=(0.1, -0.5, 0), knee=(0, 0.7, 0))
"""Protective poses (14, 3) rad of a body that falls to its front, to its back, and to either side."""


@compiled
def is_lost(hull: Floats, com: Floats, xi: Floats, trunk_up: float) -> bool:
    """Whether balance is given up: hull (n, 2) of the feet that stand or are on a saving step, com (3,), capture point xi (2,), trunk_up
    the cosine of the trunk's tilt."""
    beyond, thrown = -distance_inside(hull, com[:2]), -distance_inside(hull, xi)
    return thrown > THROWN_M or beyond > LOST_M or (beyond > TOPPLED_M and trunk_up < TOPPLED_UP)


@compiled
def protective_pose(down: Floats) -> Floats:
    """(14, 3) rad; down (3,): where the floor is in the axes of the trunk. It matters as far as the trunk has tilted."""
    ahead, aside = down[0], abs(down[1])
    total = max(abs(ahead) + aside, 1e-6)
    front, back, side = max(ahead, 0.0) / total, max(-ahead, 0.0) / total, aside / total
    return front * FORWARD + back * BACKWARD + side * SIDEWAYS


@compiled
def fall(since_s: float, turn: Floats, joint_rotation: Floats, inertia: Floats, rotation: Floats, kp: Floats, kd: Floats) -> None:
    """Fill rotation (14, 4), kp and kd (42,) of a joint command, `since_s` after the fall began.

    turn (3, 3) of the trunk; joint_rotation (14, 4), inertia (42,) kg m^2 of the joints.
    """
    down = one.turn_back(turn, np.array([0.0, 0.0, -1.0]))
    pose = protective_pose(down)
    braced = max(1.0 - since_s / LET_GO_S, 0.0)
    rate = LIMP_RATE + braced * (BRACED_RATE - LIMP_RATE)
    off, wanted = np.empty(len(kp)), np.empty(3)
    for j in range(len(joint_rotation)):
        for axis in range(3):
            wanted[axis] = min(max(pose[j, axis], LOW[j, axis]), HIGH[j, axis])
        off[3 * j], off[3 * j + 1], off[3 * j + 2] = one.turn_to(joint_rotation[j], one.exp(wanted))
        for row in range(3 * j, 3 * j + 3):
            kp[row], kd[row] = rate * rate * inertia[row], max(DAMPING_RATE * inertia[row], LEAST_DAMPING)
    for j in range(len(joint_rotation)):
        rotation[j] = one.multiply(joint_rotation[j], one.exp(off[3 * j : 3 * j + 3]))
