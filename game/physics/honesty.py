"""The honesty meter: does anything but contact, gravity and a stated push act on a character?

Each step, in the six rows of every root, M(q_k) (v_{k+1} - v_k) / h + c(q_k, v_k) minus the contact forces minus the stated
pushes must vanish, and the step must start from the state in which the last one ended.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import PART_COUNT
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
        self._root_bodies = np.array([b.root_body for b in bodies])
        # views: MuJoCo steps in place
        self._position, self._velocity = data.qpos, data.qvel
        self._end_position = data.qpos.copy()
        self._end_velocity = data.qvel.copy()
        self._momentum = np.empty(model.nv)
        self.contacts: ContactForces | None = None
        self.active = True
        """False while a scene states that roots are held: contacts are still read, nothing is recorded."""
        self.unexplained_force_n: Floats = np.zeros(len(self._bodies))
        self.unexplained_torque_nm: Floats = np.zeros(len(self._bodies))
        self._pairs: set[tuple[int, int]] = set()
        self.worst_cone_excess_n = 0.0
        self.accept_state()

    def accept_state(self) -> None:
        """The present state is where the last step ended (after a stated placement or a roll-back)."""
        np.copyto(self._end_position, self._position)
        np.copyto(self._end_velocity, self._velocity)

    def continues(self) -> bool:
        """True where the state is that in which the last step ended."""
        return bool((self._position == self._end_position).all() and (self._velocity == self._end_velocity).all())

    def take_back(self, body: BodyDynamics) -> None:
        """Put one character back to where the last step ended."""
        self._position[body.coordinates] = self._end_position[body.coordinates]
        self._velocity[body.dofs] = self._end_velocity[body.dofs]

    def record_written_state(self) -> None:
        """A state that somebody wrote counts as the force that would have caused it."""
        data, h = self._data, self._model.opt.timestep
        jump = np.empty(self._model.nv)
        mj.mj_differentiatePos(self._model, jump, h * h, self._end_position, self._position)
        jump += (self._velocity - self._end_velocity) / h
        mj.mj_forward(self._model, data)
        self._record(self._through_mass(jump))
        self.accept_state()

    def after_step(self, pushes: Sequence[Push]) -> None:
        """Take the step's balance. The data still holds M, c and contacts of its start."""
        data, h = self._data, self._model.opt.timestep
        self.contacts = found = contact_forces(self._model, data)
        if self.active:
            residual = self._through_mass((self._velocity - self._end_velocity) / h) + data.qfrc_bias[self._roots].reshape(-1, 6)
            if found is not None:
                residual -= self._root_forces(found.on_characters(len(self._bodies)), found.force, found.point)
                self.worst_cone_excess_n = max(self.worst_cone_excess_n, found.cone_excess_n())
                self._pairs.update(found.pairs())
            for push in pushes:
                on = (np.arange(len(self._bodies)) == push.character).astype(float)[:, None]
                residual -= self._root_forces(on, push.force[None], push.point[None])
            self._record(residual)
        self.accept_state()

    @property
    def partners(self) -> list[str]:
        """Between whom contact forces acted since `restart`: "floor - c0", "c0 - c1"."""
        pairs = {tuple(sorted((body - 1) // PART_COUNT for body in pair)) for pair in self._pairs}
        return sorted(" - ".join("floor" if c == FLOOR else f"c{c}" for c in pair) for pair in pairs)

    def _through_mass(self, acceleration: Floats) -> Floats:
        mj.mj_mulM(self._model, self._data, self._momentum, acceleration)
        return self._momentum[self._roots].reshape(-1, 6)

    def _root_forces(self, on: Floats, force: Floats, point: Floats) -> Floats:
        """(characters, 6) generalised forces on the roots: `on` (characters, n) says with which sign forces (n, 3) at points act.

        World force, and torque about the root in the root's frame, as in MuJoCo's free joint.
        """
        wrench = np.empty((len(force), 6))
        wrench[:, :3], wrench[:, 3:] = force, rotation.cross(point, force)
        out = on @ wrench
        about_root = out[:, 3:] - rotation.cross(self._data.xpos[self._root_bodies], out[:, :3])
        out[:, 3:] = rotation.turn_back(self._data.xmat[self._root_bodies].reshape(-1, 3, 3), about_root)
        return out

    def _record(self, residual: Floats) -> None:
        if not self.active:
            return
        for row, (x, y, z, a, b, c) in enumerate(residual.tolist()):
            self.unexplained_force_n[row] = max(self.unexplained_force_n[row], math.sqrt(x * x + y * y + z * z))
            self.unexplained_torque_nm[row] = max(self.unexplained_torque_nm[row], math.sqrt(a * a + b * b + c * c))
