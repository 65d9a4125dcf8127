"""Balance strategy `none`: every joint tracks its target, the ankles too, and nothing looks after the balance."""

import numpy as np

from game.characters.skeleton import FEET
from game.control.ankle_strategy import left_share
from game.control.gains import gains
from game.control.gravity_feedforward import gravity_torque
from game.control.joint_command import BodyState, JointCommand
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings


class PoseOnly:
    """PD tracking alone."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings

    def reset(self, dynamics: BodyState) -> None:
        """Nothing is kept."""

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        kp, kd = gains(dynamics, self._settings.number("pd.kp_hat"), self._settings.choice("pd.ratio"))
        feedforward = np.zeros_like(kp)
        if self._settings.switch("pd.gravity_feedforward"):
            feet = target.pose.joint[list(FEET)]
            feedforward = gravity_torque(dynamics, left_share(target.com, feet[0], feet[1], dynamics.foot_contact))
        return JointCommand(target.joint_rotation, target.joint_velocity, kp, kd, feedforward)
