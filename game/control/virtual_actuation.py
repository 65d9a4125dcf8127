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


@compiled
def _com_force(
    com: Floats, com_velocity: Floats, cos: Floats, target_offset: Floats, w_com: float, stiffness: float, damping: float, mass: float
) -> Floats:
    """(3,) N, level: towards the place over the COS, against the COM's velocity."""
    force = np.zeros(3)
    for axis in range(2):
        goal = cos[axis] + w_com * target_offset[axis] - com[axis]
        force[axis] = mass * (stiffness * goal - damping * com_velocity[axis])
    return force


@compiled
def _pelvis_torque(orientation: Floats, wanted: Floats, spin: Floats, stiffness: float, damping: float) -> Floats:
    """(3,) N m, world: towards the target's pelvis, turned to the character's own heading."""
    return stiffness * _turn_from_to(orientation, wanted) - damping * spin


@compiled
def _add_leg_torques(
    feedforward: Floats, joint: Floats, box_centre: Floats, turn: Floats, share: Floats, force: Floats, torque: Floats
) -> Floats:
    legs = leg_torques(joint, box_centre, turn, share[0] * force, share[1] * force) + _hip_torques(turn, share, torque)
    return feedforward + legs


class VirtualActuation(AnkleStrategy):
    """Adds a COM force and a pelvis torque, both of spring and damper, to what the ankle strategy commands."""

    def __init__(self, settings: Settings) -> None:
        super().__init__(settings)
        self.force = np.zeros(3)
        self.pelvis_torque = np.zeros(3)

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        command = super().command(target, dynamics, dt)
        number = self._settings.number
        left, right = dynamics.foot_contact
        share = np.array([left * self.left_share, right * (1.0 - self.left_share)])
        self.force = _com_force(
            dynamics.com, dynamics.com_velocity, self.cos, self.target_offset, number("balance.w_com"),
            number("balance.com_stiffness"), number("balance.com_damping"), dynamics.subtree_mass[0],
        )  # fmt: skip
        self.pelvis_torque = _pelvis_torque(
            dynamics.orientation[0], target.root_orientation, dynamics.root_spin,
            number("balance.pelvis_stiffness"), number("balance.pelvis_damping"),
        )  # fmt: skip
        legs = dynamics.joint, dynamics.box_centre, dynamics.turn
        feedforward = _add_leg_torques(command.feedforward, *legs, share, self.force, self.pelvis_torque)
        return JointCommand(command.rotation, command.velocity, command.kp, command.kd, feedforward)
