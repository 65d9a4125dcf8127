"""The honesty meter: does anything but contact, gravity and a stated push act on a character?

Each step, in the six rows of every root, M(q_k) (v_{k+1} - v_k) / h + c(q_k, v_k) minus the contact forces minus the stated
pushes must vanish, and the step must start from the state in which the last one ended.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.physics.contacts import FLOOR, ContactForces, contact_forces
from game.physics.dynamics import BodyDynamics

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Push:
    """A force that a scene states: on the part `body` (MuJoCo id) of a character, (3,) N at `point` (3,) m, world frame."""

    character: int
    body: int
    force: Floats
    point: Floats


class HonestyMeter:
    """Measures one world step by step; `unexplained_*` hold the largest residual since `restart`."""

    def __init__(self, model: mj.MjModel, data: mj.MjData, bodies: Sequence[BodyDynamics]) -> None:
        self._model, self._data, self._bodies = model, data, bodies
        self._roots = np.concatenate([np.arange(b.dofs.start, b.dofs.start + 6) for b in bodies])
        self._end_position = data.qpos.copy()
        self._end_velocity = data.qvel.copy()
        self._momentum = np.empty(model.nv)
        self.contacts: ContactForces = contact_forces(model, data)
        self.restart()

    def restart(self) -> None:
        """Forget what was measured; the present state becomes the one to go on from."""
        self.unexplained_force_n: Floats = np.zeros(len(self._bodies))
        self.unexplained_torque_nm: Floats = np.zeros(len(self._bodies))
        self.partners: set[str] = set()
        self.worst_cone_excess_n = 0.0
        self.accept_state()

    def accept_state(self) -> None:
        """The present state is where the last step ended (after a stated placement or a roll-back)."""
        np.copyto(self._end_position, self._data.qpos)
        np.copyto(self._end_velocity, self._data.qvel)

    def before_step(self) -> None:
        """Compare the state with the end of the last step; a written state counts as the force that would have caused it."""
        data = self._data
        if np.array_equal(data.qpos, self._end_position) and np.array_equal(data.qvel, self._end_velocity):
            return
        h = self._model.opt.timestep
        jump = np.empty(self._model.nv)
        mj.mj_differentiatePos(self._model, jump, h * h, self._end_position, data.qpos)
        jump += (data.qvel - self._end_velocity) / h
        mj.mj_forward(self._model, data)
        self._record(self._through_mass(jump))
        self.accept_state()

    def after_step(self, pushes: Sequence[Push]) -> None:
        """Take the step's balance. The data still holds M, c and contacts of its start."""
        data, h = self._data, self._model.opt.timestep
        residual = self._through_mass((data.qvel - self._end_velocity) / h) + data.qfrc_bias[self._roots].reshape(-1, 6)
        self.contacts = found = contact_forces(self._model, data)
        for row, body in enumerate(self._bodies):
            for side, sign in ((found.first, -1.0), (found.second, 1.0)):
                mine = side == row
                if mine.any():
                    residual[row] -= self._root_force(body, sign * found.force[mine], found.point[mine])
            for push in pushes:
                if push.character == row:
                    residual[row] -= self._root_force(body, push.force[None], push.point[None])
        self._record(residual)
        self._note_partners(found)
        self.accept_state()

    def _through_mass(self, acceleration: Floats) -> Floats:
        mj.mj_mulM(self._model, self._data, self._momentum, acceleration)
        return self._momentum[self._roots].reshape(-1, 6)

    def _root_force(self, body: BodyDynamics, force: Floats, point: Floats) -> Floats:
        """(6,) generalised force on the root of forces (n, 3) at points (n, 3): world force, torque in the root's frame."""
        origin = self._data.xpos[body.root_body]
        arm = point - origin
        out = np.empty(6)
        out[:3] = force.sum(axis=0)
        torque = np.array(
            [
                (arm[:, 1] * force[:, 2] - arm[:, 2] * force[:, 1]).sum(),
                (arm[:, 2] * force[:, 0] - arm[:, 0] * force[:, 2]).sum(),
                (arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]).sum(),
            ]
        )
        out[3:] = torque @ self._data.xmat[body.root_body].reshape(3, 3)
        return out

    def _record(self, residual: Floats) -> None:
        squared = residual * residual
        np.maximum(self.unexplained_force_n, np.sqrt(squared[:, :3].sum(axis=1)), out=self.unexplained_force_n)
        np.maximum(self.unexplained_torque_nm, np.sqrt(squared[:, 3:].sum(axis=1)), out=self.unexplained_torque_nm)

    def _note_partners(self, found: ContactForces) -> None:
        if len(found.normal) == 0:
            return
        excess = np.maximum(-found.normal, found.tangential - found.friction * found.normal)
        self.worst_cone_excess_n = max(self.worst_cone_excess_n, float(excess.max()))
        for a, b in set(zip(found.first.tolist(), found.second.tolist(), strict=True)):
            self.partners.add(" - ".join("floor" if c == FLOOR else f"c{c}" for c in sorted((a, b))))
