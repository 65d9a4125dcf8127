"""Getting up from the floor: from key pose to key pose, by joint torques within their strength, until the feet can take over."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.joint_limits import joint_angles
from game.characters.skeleton import FEET, PARTS
from game.compiled import compiled
from game.control.joint_command import BodyState
from game.control.whole_body.capture_point import capture_point, natural_frequency
from game.control.whole_body.key_poses import KeyPose, in_mirror, key_poses
from game.control.whole_body.sole import polygon, soles_of
from game.control.whole_body.support_polygon import distance_inside
from game.control.whole_body.torque_limits import limits_at

Floats = NDArray[np.float64]

FULL_RAD, SETTLE_S = 0.25, 0.06
"""So far off the way to its key pose a joint uses all its strength; the time over which its damping works."""

HELD_S = 0.4
"""The last key pose is held so long for the body to come over its feet; after that the try has ended."""

FLAT_UP, ON_FLOOR_M = 0.94, 0.04
"""Feet that can take over are flat to 20 degrees and on the floor."""

INSIDE_M, BESIDE_M, SLOW_M_S = 0.0, 0.05, 1.0
"""They can with the capture point so far within them, the COM no farther beyond them than the second, and no faster."""

ON_SIDE, ROLLS_ON_S = 0.7, 0.4
"""Whose shoulder points up by more than this, the sine of 44 degrees, lies on the other side; one who is rolling over to the front may
still do so for so long."""

_TRUNK = PARTS.index("trunk")


def is_ready(body: BodyState) -> bool:
    """Whether the body could stand up from here: both soles on the floor, the COM over them and not on its way elsewhere."""
    soles = soles_of(body)
    if not all(sole.touches and sole.centre[2] < ON_FLOOR_M for sole in soles) or float(body.turn[list(FEET), 2, 2].min()) < FLAT_UP:
        return False
    hull, frequency = polygon(soles, True, True, 0.0), natural_frequency(body.gravity, float(body.com[2]))
    comes_to = distance_inside(hull, capture_point(body.com, body.com_velocity, frequency))
    slow = float(np.linalg.norm(body.com_velocity)) < SLOW_M_S
    return bool(slow and comes_to > INSIDE_M and distance_inside(hull, body.com[:2]) > -BESIDE_M)


def route_of(body: BodyState) -> str:
    """How it lies: on its side, its back or its front."""
    return "side" if abs(body.turn[_TRUNK, 2, 1]) > ON_SIDE else nearer_route_of(body)


def nearer_route_of(body: BodyState) -> str:
    """Whether the back or the front is nearer to the floor."""
    return "supine" if body.turn[_TRUNK, 2, 0] >= 0.0 else "prone"


class GettingUp:
    """One try: `drive` a tick at a time until it `has_ended`, or from the front `is_ready`; on other routes it comes to lie otherwise."""

    def __init__(self, body: BodyState, route: str, poses: Sequence[KeyPose] | None = None) -> None:
        """poses: other ones than those of the data file; they are mirrored where the body lies on its left side."""
        self.route = route
        self._poses = tuple(poses or key_poses()[route])
        if route == "side" and body.turn[_TRUNK, 2, 1] < 0.0:
            self._poses = tuple(KeyPose(in_mirror(pose.joints), pose.seconds) for pose in self._poses)
        self._number, self._since_s, self._start = 0, 0.0, joint_angles(body.joint_rotation)
        self._lasts_s = 0.0
        self._lay_flat = route_of(body) != "side"

    def tips_over(self, body: BodyState) -> bool:
        """Who pushes himself up from the front lies on the side, again or still: the rest of the try is lost."""
        rolled_on = self._lay_flat or self._lasts_s > ROLLS_ON_S
        return self.route == "prone" and rolled_on and route_of(body) == "side"

    @property
    def comes_to_stand(self) -> bool:
        """In its last key pose the feet may take over."""
        return self.route == "prone" and self._in_last_pose

    @property
    def _in_last_pose(self) -> bool:
        return self._number == len(self._poses) - 1

    @property
    def has_ended(self) -> bool:
        """The time of the last key pose is over."""
        held_s = HELD_S if self.route == "prone" else 0.0
        return self._in_last_pose and self._since_s > self._poses[-1].seconds + held_s

    def drive(self, body: BodyState, low: Floats, high: Floats, dt: float, rotation: Floats, kp: Floats, kd: Floats) -> None:
        """Fill rotation (14, 4), kp and kd (42,) of a joint command for the next `dt`; low, high (42,) N m: the joints' strength."""
        if not self._in_last_pose and self._since_s >= self._poses[self._number].seconds - 0.5 * dt:
            self._number, self._since_s, self._start = self._number + 1, 0.0, joint_angles(body.joint_rotation)
        self._since_s += dt
        self._lasts_s += dt
        pose = self._poses[self._number]
        drive(self._start, pose.joints, pose.seconds, self._since_s, body.joint_rotation, body.velocity[6:], low, high, rotation, kp, kd)


@compiled
def drive(
    start: Floats, goal: Floats, span_s: float, since_s: float, joint_rotation: Floats, velocity: Floats, low: Floats, high: Floats,
    rotation: Floats, kp: Floats, kd: Floats,
) -> None:  # fmt: skip
    """Fill rotation (14, 4), kp and kd (42,): joints on a way of minimum jerk from `start` to `goal` (14, 3) rad, `since_s` of `span_s`.

    The spring is as stiff as the joint is strong, and the goal no farther off than its strength reaches: low, high (42,) N m.
    """
    s = min(since_s / span_s, 1.0)
    along, speed = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s), 30.0 * s * s * (1.0 - s) ** 2 / span_s
    least, most = limits_at(low, high, velocity)
    off = np.empty(3)
    for j in range(len(joint_rotation)):
        away = one.turn_to(joint_rotation[j], one.exp(start[j] + along * (goal[j] - start[j])))
        for axis in range(3):
            row = 3 * j + axis
            kp[row] = min(-low[row], high[row]) / FULL_RAD
            kd[row] = SETTLE_S * kp[row]
            torque = kp[row] * away[axis] + kd[row] * (speed * (goal[j, axis] - start[j, axis]) - velocity[row])
            off[axis] = (min(max(torque, least[row]), most[row]) + kd[row] * velocity[row]) / kp[row]
        rotation[j] = one.multiply(joint_rotation[j], one.exp(off))
