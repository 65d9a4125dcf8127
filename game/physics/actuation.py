"""Joint commands as torques: the PD law of Eq. 3.7, evaluated at the end of the step (stable PD, Tan, Liu & Turk 2011).

tau = kp (e_k - h v_{k+1}) + kd (v_target - v_{k+1}): the terms in v_{k+1} are joint damping D = kd + h kp, which MuJoCo's
integrator solves together with the contacts; the rest is an applied joint torque. Nothing acts on the root. Ligaments come on top of it
at the ends of the joints' ranges, but not in the explicit law: they are too stiff for it.
"""

from collections.abc import Sequence

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import DOF_COUNT
from game.characters.strength import joint_strength
from game.compiled import compiled
from game.control.joint_command import JointCommand
from game.physics.dynamics import BodyDynamics
from game.physics.ligaments import add_ligaments

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

PASSIVE_DAMPING = 2.0
"""Joint damping of a character without a command, N m s/rad."""


class Actuation:
    """Holds the commands of all characters between control ticks and applies them before each step."""

    def __init__(self, model: mj.MjModel, data: mj.MjData, bodies: Sequence[BodyDynamics], *, explicit: bool) -> None:
        self._model, self._bodies, self._explicit = model, bodies, explicit
        self._first_rows = np.array([b.dofs.start for b in bodies])
        self._first_places = np.array([b.coordinates.start for b in bodies])
        self._strength = np.array([joint_strength(b.plan) for b in bodies])
        self._goal = data.qpos.copy()
        self._held = np.zeros((4, model.nv))
        self._error = np.zeros(model.nv)
        self._stiff = [False] * len(bodies)
        self._step_s = float(model.opt.timestep)
        # views: MuJoCo steps in place
        self._position, self._velocity, self._applied, self._model_damping = data.qpos, data.qvel, data.qfrc_applied, model.dof_damping
        self.torque: Floats = np.zeros(model.nv)
        """(nv,) N m, the torque of each axis in the last step; root rows are zero."""
        self.peak_torque: Floats = np.zeros(model.nv)
        """(nv,) N m, the largest of each axis so far."""
        self.books = self._applied, self._model_damping, self.torque, self.peak_torque
        """What `settle_torque` takes besides the velocity."""
        for index in range(len(bodies)):
            self.relax(index)

    def set(self, index: int, command: JointCommand) -> None:
        """Character `index` follows `command` from the next step on."""
        body = self._bodies[index]
        goal, held = self._goal[body.coordinates][7:], self._held[:, body.joint_dofs]
        self._stiff[index] = take_command(
            command.rotation, command.velocity, command.kp, command.kd, command.feedforward, self._step_s, self._explicit, goal, held
        )

    def relax(self, index: int) -> None:
        """Character `index` goes limp: light joint damping and nothing else."""
        held = self._held[:, self._bodies[index].joint_dofs]
        held[:3], held[3] = 0.0, PASSIVE_DAMPING
        self._stiff[index] = False

    def apply(self) -> None:
        """Write the applied torques and the damping for the coming step."""
        if True in self._stiff:
            # without stiffness no error counts, and measuring it costs as much as all the rest
            mj.mj_differentiatePos(self._model, self._error, 1.0, self._position, self._goal)
        write_torque(
            self._first_rows, self._first_places, self._held, self._error, self._position, self._velocity, self._strength, self._step_s,
            self._explicit, self._applied, self._model_damping,
        )  # fmt: skip


@compiled
def take_command(
    rotation: Floats, velocity: Floats, kp: Floats, kd: Floats, feedforward: Floats, step_s: float, explicit: bool,
    goal: Floats, held: Floats,
) -> bool:  # fmt: skip
    """A command's rotations into `goal` (56,), its kp, kd, offset and joint damping into the rows of `held`, (4, 42).

    True where any axis has stiffness.
    """
    stiff = False
    for joint in range(len(rotation)):
        for part in range(4):
            goal[4 * joint + part] = rotation[joint, part]
    for row in range(len(kp)):
        held[0, row], held[1, row] = kp[row], kd[row]
        held[2, row] = feedforward[row] + kd[row] * velocity[row]
        held[3, row] = 0.0 if explicit else kd[row] + step_s * kp[row]
        stiff = stiff or kp[row] != 0.0
    return stiff


@compiled
def write_torque(
    first_rows: Indices, first_places: Indices, held: Floats, error: Floats, position: Floats, velocity: Floats, strength: Floats,
    step_s: float, explicit: bool, out: Floats, damping: Floats,
) -> None:  # fmt: skip
    """kp e + offset into the joint rows of `out`, less kd v where the whole law is explicit, else with ligaments; root rows are left alone.

    first_rows, first_places: where each character begins in the velocities and positions; held (4, nv): kp, kd, offset and damping, which
    goes into `damping`; strength (characters, 2, 42) N m of the muscles.
    """
    for row in range(len(damping)):
        damping[row] = held[3, row]
    for index, first in enumerate(first_rows):
        for row in range(first + 6, first + DOF_COUNT):
            out[row] = held[0, row] * error[row] + held[2, row]
            if explicit:
                out[row] -= held[1, row] * velocity[row]
        if not explicit:
            joints, start = slice(first + 6, first + DOF_COUNT), first_places[index] + 7
            places = position[start : start + 4 * (DOF_COUNT - 6) // 3]
            low, high = strength[index]
            add_ligaments(places, velocity[joints], low, high, step_s, out[joints], damping[joints])


@compiled
def settle_torque(applied: Floats, damping: Floats, velocity: Floats, torque: Floats, peak: Floats) -> None:
    """Write applied - damping v into `torque`, (nv,), and keep its largest size in `peak`, (nv,)."""
    for row in range(len(torque)):
        torque[row] = applied[row] - damping[row] * velocity[row]
        peak[row] = np.maximum(peak[row], abs(torque[row]))
