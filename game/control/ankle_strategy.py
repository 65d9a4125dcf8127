"""The thesis's balance strategy: the ankles turn so that the COM comes to stand over the centre of support (3.4.3)."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import ANKLES, FEET, PARTS
from game.control.gains import gains
from game.control.gravity_feedforward import gravity_torque
from game.control.joint_command import BodyState, JointCommand
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings

Floats = NDArray[np.float64]

_SHANKS = [PARTS.index("lower_leg_left"), PARTS.index("lower_leg_right")]
_FEET, _ANKLES = list(FEET), list(ANKLES)


def left_share(target_com: Floats, left_foot: Floats, right_foot: Floats, contact: tuple[bool, bool]) -> float:
    """Share of the support that the left foot is to bear: where the target's COM lies between its feet, 1 or 0 on one foot."""
    if contact[0] != contact[1]:
        return 1.0 if contact[0] else 0.0
    across = (right_foot - left_foot)[:2]
    along = float((target_com - left_foot)[:2] @ across) / max(float(across @ across), 1e-9)
    return 1.0 - min(max(along, 0.0), 1.0)


def com_target(com: Floats, com_velocity: Floats, target_offset: Floats, w_com: float, w_vel: float) -> Floats:
    """Where the COM shall come to lie relative to the COS, Eq. 3.9 to 3.11; com (3,) is relative to the COS too.

    The velocity term enters with a minus: with the plus sign of Eq. 3.11 as printed the body falls within a second.
    """
    above = np.array([0.0, 0.0, com[2]])
    p_com = w_com * target_offset + (1.0 - w_com) * above
    length = max(float(np.sqrt(p_com @ p_com)), 1e-9)
    direction = p_com / length
    across = com_velocity - (com_velocity @ direction) * direction
    speed = float(np.sqrt(across @ across))
    if speed > length:
        across = across * (length / speed)
    return p_com - w_vel * across


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
        rotations[_ANKLES] = self._ankle_targets(self._correction(target, dynamics), dynamics)
        velocity.reshape(-1, 3)[_ANKLES] = 0.0
        feedforward = np.zeros_like(kp)
        if settings.switch("pd.gravity_feedforward"):
            feedforward = gravity_torque(dynamics, self.left_share)
        return JointCommand(rotations, velocity, kp, kd, feedforward)

    def _ankle_targets(self, correction: Floats, dynamics: BodyState) -> Floats:
        """(2, 4) ankle rotations, foot in shank: flat feet under shanks turned by `correction`, no farther than the clamp from now.

        A foot in the air is only kept flat.
        """
        shank = dynamics.orientation[_SHANKS]
        turn = np.array([correction if touches else rotation.IDENTITY for touches in dynamics.foot_contact])
        turned = rotation.multiply(turn, shank)
        flat = np.array([rotation.about_z(rotation.yaw(q)) for q in turned])
        current = rotation.multiply(rotation.conjugate(shank), dynamics.orientation[_FEET])
        wanted = rotation.multiply(rotation.conjugate(turned), flat)
        error = rotation.log(rotation.multiply(rotation.conjugate(current), wanted))
        size = np.sqrt((error * error).sum(axis=1, keepdims=True))
        clamp = self._settings.number("balance.ankle_clamp_rad")
        return rotation.multiply(current, rotation.exp(error * np.minimum(1.0, clamp / np.maximum(size, 1e-12))))

    def _correction(self, target: KinematicTarget, dynamics: BodyState) -> Floats:
        """The turn (4,) of the whole body about the COS that brings the COM to its target."""
        feet = target.pose.joint[_FEET]
        self.left_share = left_share(target.com, feet[0], feet[1], dynamics.foot_contact)
        w = self.left_share
        cos = w * dynamics.box_centre[FEET[0]] + (1.0 - w) * dynamics.box_centre[FEET[1]]
        target_cos = w * feet[0] + (1.0 - w) * feet[1]
        heading = rotation.yaw(dynamics.orientation[0]) - rotation.yaw(target.root_orientation)
        offset = rotation.rotate(rotation.about_z(heading), target.com - target_cos)
        com = dynamics.com - cos
        settings = self._settings
        goal = com_target(com, dynamics.com_velocity, offset, settings.number("balance.w_com"), settings.number("balance.w_vel"))
        self.cos, self.com_target, self.target_offset = cos, cos + goal, offset
        if com[2] < 0.1 or goal[2] < 0.1:
            return rotation.IDENTITY
        return rotation.between(rotation.normalise(com), rotation.normalise(goal))
