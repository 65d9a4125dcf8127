"""Joint commands as torques: the PD law of Eq. 3.7, evaluated at the end of the step (stable PD, Tan, Liu & Turk 2011).

tau = kp (e_k - h v_{k+1}) + kd (v_target - v_{k+1}): the terms in v_{k+1} are joint damping D = kd + h kp, which MuJoCo's
integrator solves together with the contacts; the rest is an applied joint torque. Nothing acts on the root.
"""

from collections.abc import Sequence

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import DOF_COUNT
from game.compiled import compiled
from game.control.joint_command import JointCommand
from game.physics.dynamics import BodyDynamics

Floats = NDArray[np.float64]

PASSIVE_DAMPING = 2.0
"""Joint damping of a character without a command, N m s/rad."""


class Actuation:
    """Holds the commands of all characters between control ticks and applies them before each step."""

    def __init__(self, model: mj.MjModel, data: mj.MjData, bodies: Sequence[BodyDynamics], *, explicit: bool) -> None:
        self._model, self._data, self._bodies, self._explicit = model, data, bodies, explicit
        self._first_rows = np.array([b.dofs.start for b in bodies])
        self._goal = data.qpos.copy()
        self._kp = np.zeros(model.nv)
        self._kd = np.zeros(model.nv)
        self._offset = np.zeros(model.nv)
        self._damping = np.zeros(model.nv)
        self._error = np.empty(model.nv)
        self.torque: Floats = np.zeros(model.nv)
        """(nv,) N m, the torque of each axis in the last step; root rows are zero."""
        for index in range(len(bodies)):
            self.relax(index)

    def set(self, index: int, command: JointCommand) -> None:
        """Character `index` follows `command` from the next step on."""
        body = self._bodies[index]
        rows = body.joint_dofs
        self._goal[body.coordinates][7:] = command.rotation.reshape(-1)
        self._kp[rows] = command.kp
        self._kd[rows] = command.kd
        self._offset[rows] = command.feedforward + command.kd * command.velocity
        self._damping[rows] = 0.0 if self._explicit else command.kd + self._model.opt.timestep * command.kp

    def relax(self, index: int) -> None:
        """Character `index` goes limp: light joint damping and nothing else."""
        rows = self._bodies[index].joint_dofs
        for held in (self._kp, self._kd, self._offset):
            held[rows] = 0.0
        self._damping[rows] = PASSIVE_DAMPING

    def apply(self) -> None:
        """Write the applied torques and the damping for the coming step."""
        model, data = self._model, self._data
        mj.mj_differentiatePos(model, self._error, 1.0, data.qpos, self._goal)
        write_torque(self._first_rows, self._kp, self._error, self._offset, self._kd, data.qvel, self._explicit, data.qfrc_applied)
        model.dof_damping[:] = self._damping

    def settle(self) -> None:
        """After the step: the torque that acted, with the velocity the integrator evaluated it at."""
        self.torque = self._data.qfrc_applied - self._damping * self._data.qvel


@compiled
def write_torque(
    first_rows: NDArray[np.int64], kp: Floats, error: Floats, offset: Floats, kd: Floats, velocity: Floats, explicit: bool, out: Floats
) -> None:
    """kp e + offset into the joint rows of `out`, less kd v where the whole law is explicit; root rows are left alone."""
    for first in first_rows:
        for row in range(first + 6, first + DOF_COUNT):
            out[row] = kp[row] * error[row] + offset[row]
            if explicit:
                out[row] -= kd[row] * velocity[row]
