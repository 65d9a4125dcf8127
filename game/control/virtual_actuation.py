"""Balance strategy `virtual-actuation`: the ankle strategy, helped by the hips and knees of the legs that stand.

Virtual actuation (Zordan & Hodgins 2002; Geijtenbeek, Pronost & van der Stappen 2012): the standing legs act as if a force drew
the COM over the centre of support and a torque set the pelvis upright. Both are made by joint torques alone, through the
transposed Jacobian of the leg, and the floor gives what it can.
"""

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import JOINT_COUNT, JOINTS
from game.compiled import compiled
from game.control.ankle_strategy import AnkleStrategy
from game.control.gravity_feedforward import leg_torques
from game.control.joint_command import BodyState, JointCommand
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings

Floats = NDArray[np.float64]

_HIPS = np.array([JOINTS.index("hip_left"), JOINTS.index("hip_right")])


def leg_torque_of_force(state: BodyState, share: Floats, force: Floats) -> Floats:
    """(42,) torques, child frames, of hips and knees that push the body with `force` (3,) N, share (2,) on the left and right foot.

    The floor's reaction share * force at the foot turns the parts beyond each joint by (foot - joint) x force; the joint holds
    against it. Static: J^T F with the standing foot as the fixed end.
    """
    return leg_torques(state.joint, state.box_centre, state.turn, share[0] * force, share[1] * force)


def hip_torque_on_pelvis(state: BodyState, share: Floats, torque: Floats) -> Floats:
    """(42,) torques, child frames, of the hips that turn the pelvis with `torque` (3,) N m against the standing thighs."""
    return _hip_torques(state.turn, share, torque)


@compiled
def _hip_torques(turn: Floats, share: Floats, torque: Floats) -> Floats:
    out = np.zeros(3 * JOINT_COUNT)
    for side in range(2):
        hip = _HIPS[side]
        out[3 * hip : 3 * hip + 3] = -share[side] * one.turn_back(turn[hip + 1], torque)
    return out


@compiled
def _turn_from_to(orientation: Floats, wanted: Floats) -> Floats:
    """(3,) rad, world: the rotation vector from the root's orientation to the wanted one, turned to the root's own heading."""
    heading = one.about_z(one.yaw(orientation) - one.yaw(wanted))
    return one.log(one.multiply(one.multiply(heading, wanted), one.conjugate(orientation)))


class VirtualActuation(AnkleStrategy):
    """Adds a COM force and a pelvis torque, both of spring and damper, to what the ankle strategy commands."""

    def __init__(self, settings: Settings) -> None:
        super().__init__(settings)
        self.force = np.zeros(3)
        self.pelvis_torque = np.zeros(3)

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        command = super().command(target, dynamics, dt)
        share = np.array([self.left_share, 1.0 - self.left_share]) * dynamics.foot_contact
        self.force, self.pelvis_torque = self._com_force(dynamics), self._torque_on_pelvis(target, dynamics)
        legs = leg_torque_of_force(dynamics, share, self.force) + hip_torque_on_pelvis(dynamics, share, self.pelvis_torque)
        return JointCommand(command.rotation, command.velocity, command.kp, command.kd, command.feedforward + legs)

    def _com_force(self, dynamics: BodyState) -> Floats:
        """(3,) N, level: towards the place over the COS, against the COM's velocity."""
        settings = self._settings
        goal = self.cos + settings.number("balance.w_com") * self.target_offset - dynamics.com
        pull = settings.number("balance.com_stiffness") * goal - settings.number("balance.com_damping") * dynamics.com_velocity
        pull[2] = 0.0
        return dynamics.subtree_mass[0] * pull

    def _torque_on_pelvis(self, target: KinematicTarget, dynamics: BodyState) -> Floats:
        """(3,) N m, world: towards the target's pelvis, turned to the character's own heading."""
        settings = self._settings
        error = _turn_from_to(dynamics.orientation[0], target.root_orientation)
        stiffness, damping = settings.number("balance.pelvis_stiffness"), settings.number("balance.pelvis_damping")
        return stiffness * error - damping * dynamics.root_spin
