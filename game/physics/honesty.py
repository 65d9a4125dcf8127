"""The honesty meter: does anything but contact, gravity and a stated push act on a character?

Each step, in the six rows of every root, M(q_k) (v_{k+1} - v_k) / h + c(q_k, v_k) minus the contact forces minus the stated
pushes must vanish, and the step must start from the state in which the last one ended.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import PART_COUNT
from game.compiled import compiled
from game.physics.actuation import Actuation
from game.physics.contacts import FLOOR, ContactForces, contact_forces
from game.physics.dynamics import BodyDynamics
from game.physics.root_balance import keep_largest
from game.physics.step_close import close_step, copy_state

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
        self._first_rows = np.array([b.dofs.start for b in bodies])
        roots = slice(bodies[0].root_body, None, PART_COUNT)
        # views: MuJoCo steps in place
        self._position, self._velocity, self._bias = data.qpos, data.qvel, data.qfrc_bias
        self._root_place, self._root_turn = data.xpos[roots], data.xmat[roots]
        self._end_position = data.qpos.copy()
        self._end_velocity = data.qvel.copy()
        self._change = np.empty(model.nv)
        self._residual = np.empty((len(bodies), 6))
        self._mass = data.M, model.M_rownnz, model.M_rowadr, model.M_colind
        self._step_s, self._owner = float(model.opt.timestep), model.geom_bodyid
        self._wrench = np.zeros((64, 6))
        self._wrench_rows = list(self._wrench)
        self.active = True
        """False while a scene states that roots are held: contacts are still read, nothing is recorded."""
        self.unexplained_force_n: Floats = np.zeros(len(self._bodies))
        self.unexplained_torque_nm: Floats = np.zeros(len(self._bodies))
        self._pairs = np.zeros((model.nbody, model.nbody), dtype=np.bool_)
        self.worst_cone_excess_n = 0.0
        self._contacts: ContactForces | None = None
        self.ends = 0
        """Counts the ends of steps and whatever else was taken for one."""
        self.accept_state()

    def accept_state(self) -> None:
        """The present state is where the last step ended (after a stated placement or a roll-back)."""
        copy_state(self._position, self._velocity, self._end_position, self._end_velocity)
        self.ends += 1
        self._contacts_read = self._wrenches_read = False

    def continues(self) -> bool:
        """True where the state is that in which the last step ended."""
        return same_state(self._position, self._velocity, self._end_position, self._end_velocity)

    def take_back(self, body: BodyDynamics) -> None:
        """Put one character back to where the last step ended."""
        self._position[body.coordinates] = self._end_position[body.coordinates]
        self._velocity[body.dofs] = self._end_velocity[body.dofs]

    def record_written_state(self) -> None:
        """A state that somebody wrote counts as the force that would have caused it."""
        data, h = self._data, self._step_s
        jump = np.empty(self._model.nv)
        mj.mj_differentiatePos(self._model, jump, h * h, self._end_position, self._position)
        jump += (self._velocity - self._end_velocity) / h
        mj.mj_forward(self._model, data)
        self._record(self._through_mass(jump))
        self.accept_state()

    def close_step(self, actuation: Actuation, pushes: Sequence[Push], trail: Floats, row: int, found_sound: bool = False) -> bool:
        """Take the step's balance, settle its torques and note its end in a row of `trail`; False, and none of it, where its end is no
        state of a body, unless somebody has looked closer and found it sound. The data still holds M, c and contacts of the step's start.
        """
        contacts, active = self._data.contact, self.active
        excess = close_step(
            self._position, self._velocity, self._end_position, self._end_velocity, trail, row, *actuation.books, *self._mass,
            self._bias, self._step_s, self._first_rows, self._root_place, self._root_turn, self._read_wrenches() if active else 0,
            contacts.pos, contacts.frame, contacts.friction, contacts.geom, self._owner, self._wrench,
            self._pairs, self._residual, active and not pushes, self.unexplained_force_n, self.unexplained_torque_nm, found_sound,
        )  # fmt: skip
        self._contacts_read, self._wrenches_read = False, active
        if excess != excess:
            return False
        self.ends += 1
        if active:
            self.worst_cone_excess_n = max(self.worst_cone_excess_n, excess)
            if pushes:
                for push in pushes:
                    self._residual[push.character] -= self._root_force_of(push)
                self._record(self._residual)
        return True

    def _read_wrenches(self) -> int:
        """Fill the first rows of `_wrench` with the step's contact forces, in the contacts' frames; how many there are."""
        model, data, count, read = self._model, self._data, self._data.ncon, mj.mj_contactForce
        while count > len(self._wrench_rows):
            self._wrench = np.zeros((2 * len(self._wrench), 6))
            self._wrench_rows = list(self._wrench)
        rows = self._wrench_rows
        for i in range(count):
            read(model, data, i, rows[i])
        return count

    @property
    def contacts(self) -> ContactForces | None:
        """The contacts of the last step, None where there were none; read once a step, however often it is asked for."""
        if not self._contacts_read:
            wrench = self._wrench[: self._data.ncon].copy() if self._wrenches_read else None
            self._contacts, self._contacts_read = contact_forces(self._model, self._data, wrench), True
        return self._contacts

    @property
    def partners(self) -> list[str]:
        """Between whom contact forces acted since `restart`: "floor - c0", "c0 - c1"."""
        found = {tuple(sorted((int(body) - 1) // PART_COUNT for body in pair)) for pair in np.argwhere(self._pairs)}
        return sorted(" - ".join("floor" if c == FLOOR else f"c{c}" for c in pair) for pair in found)

    def _through_mass(self, acceleration: Floats) -> Floats:
        """(characters, 6) root rows of M times an acceleration (nv,)."""
        mj.mj_mulM(self._model, self._data, self._change, acceleration)
        return np.array([self._change[first : first + 6] for first in self._first_rows])

    def _root_force_of(self, push: Push) -> Floats:
        """(6,) a push as a force on its character's root: world force, torque about the root in the root's frame."""
        arm = push.point - self._root_place[push.character]
        torque = rotation.cross(arm, push.force) @ self._root_turn[push.character].reshape(3, 3)
        return np.concatenate((push.force, torque))

    def _record(self, residual: Floats) -> None:
        if self.active:
            keep_largest(residual, self.unexplained_force_n, self.unexplained_torque_nm)


@compiled
def same_state(position: Floats, velocity: Floats, other_position: Floats, other_velocity: Floats) -> bool:
    """Equal number by number."""
    for i in range(len(position)):
        if position[i] != other_position[i]:
            return False
    for i in range(len(velocity)):  # noqa: SIM110 (a compiled loop)
        if velocity[i] != other_velocity[i]:
            return False
    return True
