"""The thesis's balance strategy: the ankles turn so that the COM comes to stand over the centre of support (3.4.3)."""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import ANKLES, FEET, JOINT_COUNT, PARTS
from game.compiled import compiled
from game.control.gains import gains
from game.control.gravity_feedforward import gravity_torque
from game.control.joint_command import BodyState, JointCommand
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings

Floats = NDArray[np.float64]

_SHANKS = np.array([PARTS.index("lower_leg_left"), PARTS.index("lower_leg_right")])
_FEET, _ANKLES = np.array(FEET), np.array(ANKLES)

_NO_TORQUE = np.zeros(3 * JOINT_COUNT)

LEAST_COM_HEIGHT_M = 0.1
"""Below this above the COS nothing is left to balance."""


@compiled
def left_share(target_com: Floats, left_foot: Floats, right_foot: Floats, contact: tuple[bool, bool]) -> float:
    """Share of the support that the left foot is to bear: where the target's COM lies between its feet, 1 or 0 on one foot."""
    if contact[0] != contact[1]:
        return 1.0 if contact[0] else 0.0
    x, y = right_foot[0] - left_foot[0], right_foot[1] - left_foot[1]
    along = ((target_com[0] - left_foot[0]) * x + (target_com[1] - left_foot[1]) * y) / max(x * x + y * y, 1e-9)
    return 1.0 - min(max(along, 0.0), 1.0)


@compiled
def com_target(com: Floats, com_velocity: Floats, target_offset: Floats, w_com: float, w_vel: float) -> Floats:
    """Where the COM shall come to lie relative to the COS, Eq. 3.9 to 3.11; com (3,) is relative to the COS too.

    The velocity term enters with a minus: with the plus sign of Eq. 3.11 as printed the body falls within a second.
    """
    p_com = w_com * target_offset
    p_com[2] += (1.0 - w_com) * com[2]
    length = max(one.length(p_com), 1e-9)
    direction = p_com / length
    across = com_velocity - one.dot(com_velocity, direction) * direction
    speed = one.length(across)
    if speed > length:
        across = across * (length / speed)
    return p_com - w_vel * across


@compiled
def _rise(com: Floats, goal: Floats) -> Floats:
    """The turn (4,) that brings the COM, relative to the COS, into the goal's direction; none where either is on the floor."""
    if com[2] < LEAST_COM_HEIGHT_M or goal[2] < LEAST_COM_HEIGHT_M:
        return one.about_z(0.0)
    return one.between(one.normalise(com), one.normalise(goal))


@compiled
def _turned_to_heading(offset: Floats, root: Floats, target_root: Floats) -> Floats:
    """(3,) a horizontal offset of the target as seen with the character's own heading."""
    return one.turn(one.matrix(one.about_z(one.yaw(root) - one.yaw(target_root))), offset)


@compiled
def ankle_rotations(correction: Floats, contact: tuple[bool, bool], orientation: Floats, clamp_rad: float) -> Floats:
    """(2, 4) ankle rotations, foot in shank: flat feet under shanks turned by `correction` (4,), no farther than the clamp from now.

    A foot in the air is only kept flat. orientation (15, 4): the parts in the world.
    """
    out = np.empty((2, 4))
    for side in range(2):
        shank, foot = orientation[_SHANKS[side]], orientation[_FEET[side]]
        turned = one.multiply(correction, shank) if contact[side] else shank
        flat = one.about_z(one.yaw(turned))
        current = one.multiply(one.conjugate(shank), foot)
        error = one.log(one.multiply(one.conjugate(current), one.multiply(one.conjugate(turned), flat)))
        error *= min(1.0, clamp_rad / max(one.length(error), 1e-12))
        out[side] = one.multiply(current, one.exp(error))
    return out


@compiled
def _stance(
    target_com: Floats, target_joint: Floats, target_root: Floats, com: Floats, com_velocity: Floats, box_centre: Floats, root: Floats,
    contact: tuple[bool, bool], w_com: float, w_vel: float,
) -> tuple[float, Floats, Floats, Floats, Floats]:  # fmt: skip
    """Left share, COS (3,), the target's COM offset (3,), the goal of the COM (3,), both from the COS, and the turn (4,) towards it."""
    left, right = target_joint[_FEET[0]], target_joint[_FEET[1]]
    w = left_share(target_com, left, right, contact)
    cos = w * box_centre[_FEET[0]] + (1.0 - w) * box_centre[_FEET[1]]
    offset = _turned_to_heading(target_com - (w * left + (1.0 - w) * right), root, target_root)
    above = com - cos
    goal = com_target(above, com_velocity, offset, w_com, w_vel)
    return w, cos, offset, goal, _rise(above, goal)


@compiled
def _set_ankles(rotations: Floats, velocity: Floats, ankle: Floats) -> None:
    """Write the ankles' rotations (2, 4) into (14, 4) of all joints, and rest into their velocity (42,)."""
    for side in range(2):
        joint = _ANKLES[side]
        rotations[joint] = ankle[side]
        velocity[3 * joint : 3 * joint + 3] = 0.0


class AnkleStrategy:
    """Balance strategy `ankle`; keeps nothing between ticks. Its readable fields are for the overlay's balance layer."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self.cos = np.zeros(3)
        self.com_target = np.zeros(3)
        self.target_offset = np.zeros(3)
        self.left_share = 0.5

    def reset(self, dynamics: BodyState) -> None:
        self.cos = 0.5 * (dynamics.box_centre[FEET[0]] + dynamics.box_centre[FEET[1]])
        self.com_target = dynamics.com.copy()
        self.left_share = 0.5

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        settings = self._settings
        kp, kd = gains(dynamics, settings.number("pd.kp_hat"), settings.choice("pd.ratio"))
        rotations = target.joint_rotation.copy()
        velocity = target.joint_velocity.copy()
        clamp = settings.number("balance.ankle_clamp_rad")
        ankle = ankle_rotations(self._correction(target, dynamics), dynamics.foot_contact, dynamics.orientation, clamp)
        _set_ankles(rotations, velocity, ankle)
        feedforward = _NO_TORQUE
        if settings.switch("pd.gravity_feedforward"):
            feedforward = gravity_torque(dynamics, self.left_share)
        return JointCommand(rotations, velocity, kp, kd, feedforward)

    def _correction(self, target: KinematicTarget, dynamics: BodyState) -> Floats:
        """The turn (4,) of the whole body about the COS that brings the COM to its target."""
        settings = self._settings
        self.left_share, self.cos, self.target_offset, goal, correction = _stance(
            target.com, target.pose.joint, target.root_orientation, dynamics.com, dynamics.com_velocity, dynamics.box_centre,
            dynamics.orientation[0], dynamics.foot_contact, settings.number("balance.w_com"), settings.number("balance.w_vel"),
        )  # fmt: skip
        self.com_target = self.cos + goal
        return correction
