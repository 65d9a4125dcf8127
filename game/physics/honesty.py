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
from game import rotation_compiled as one
from game.characters.skeleton import PART_COUNT
from game.compiled import compiled
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
        self._first_rows = np.array([b.dofs.start for b in bodies])
        roots = slice(bodies[0].root_body, None, PART_COUNT)
        # views: MuJoCo steps in place
        self._position, self._velocity, self._bias = data.qpos, data.qvel, data.qfrc_bias
        self._root_place, self._root_turn = data.xpos[roots], data.xmat[roots]
        self._end_position = data.qpos.copy()
        self._end_velocity = data.qvel.copy()
        self._momentum, self._change = np.empty(model.nv), np.empty(model.nv)
        self._wrench = np.zeros((64, 6))
        self._wrench_rows = list(self._wrench)
        self.active = True
        """False while a scene states that roots are held: contacts are still read, nothing is recorded."""
        self.unexplained_force_n: Floats = np.zeros(len(self._bodies))
        self.unexplained_torque_nm: Floats = np.zeros(len(self._bodies))
        self._pairs = np.zeros((model.nbody, model.nbody), dtype=np.bool_)
        self.worst_cone_excess_n = 0.0
        self.accept_state()

    def accept_state(self) -> None:
        """The present state is where the last step ended (after a stated placement or a roll-back)."""
        np.copyto(self._end_position, self._position)
        np.copyto(self._end_velocity, self._velocity)

    def continues(self) -> bool:
        """True where the state is that in which the last step ended."""
        return same(self._position, self._end_position) and same(self._velocity, self._end_velocity)

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
        if self.active:
            data, count = self._data, self._data.ncon
            while count > len(self._wrench_rows):
                self._grow()
            for i in range(count):
                mj.mj_contactForce(self._model, data, i, self._wrench_rows[i])
            np.subtract(self._velocity, self._end_velocity, out=self._momentum)
            mj.mj_mulM(self._model, data, self._change, self._momentum)
            contacts = data.contact
            residual = root_balance(
                self._change, self._model.opt.timestep, self._bias, self._first_rows, self._root_place, self._root_turn,
                contacts.pos, contacts.frame, self._wrench[:count], self._model.geom_bodyid[contacts.geom], self._pairs,
            )  # fmt: skip
            if count:
                self.worst_cone_excess_n = max(self.worst_cone_excess_n, cone_excess(self._wrench[:count], contacts.friction))
            for push in pushes:
                residual[push.character] -= self._root_force_of(push)
            self._record(residual)
        self.accept_state()

    @property
    def contacts(self) -> ContactForces | None:
        """The contacts of the last step, None where there were none."""
        return contact_forces(self._model, self._data)

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

    def _grow(self) -> None:
        self._wrench = np.zeros((2 * len(self._wrench), 6))
        self._wrench_rows = list(self._wrench)

    def _record(self, residual: Floats) -> None:
        if not self.active:
            return
        for row, (x, y, z, a, b, c) in enumerate(residual.tolist()):
            self.unexplained_force_n[row] = max(self.unexplained_force_n[row], math.sqrt(x * x + y * y + z * z))
            self.unexplained_torque_nm[row] = max(self.unexplained_torque_nm[row], math.sqrt(a * a + b * b + c * c))


@compiled
def root_balance(
    change: Floats, step_s: float, bias: Floats, first_rows: NDArray[np.int64], root_place: Floats, root_turn: Floats,
    point: Floats, frame: Floats, wrench: Floats, body: NDArray[np.int32], pairs: NDArray[np.bool_],
) -> Floats:  # fmt: skip
    """(characters, 6) what nothing explains in the root rows: M dv / h + c minus the contact forces; notes who touched whom.

    change (nv,): M dv; root_place (characters, 3), root_turn (characters, 9); point (n, 3), frame (n, 9), wrench (n, 6), body (n, 2).
    """
    residual = np.empty((len(first_rows), 6))
    for character in range(len(first_rows)):
        first = first_rows[character]
        for row in range(6):
            residual[character, row] = change[first + row] / step_s + bias[first + row]
    force = np.empty(3)
    for i in range(len(point)):
        pairs[body[i, 0], body[i, 1]] = True
        for axis in range(3):
            force[axis] = frame[i, axis] * wrench[i, 0] + frame[i, 3 + axis] * wrench[i, 1] + frame[i, 6 + axis] * wrench[i, 2]
        for side in range(2):
            if body[i, side] == 0:
                continue
            character = (body[i, side] - 1) // PART_COUNT
            sign = 1.0 if side == 1 else -1.0
            torque = one.cross(point[i] - root_place[character], force)
            turn = root_turn[character]
            for axis in range(3):
                residual[character, axis] -= sign * force[axis]
                in_root = turn[axis] * torque[0] + turn[3 + axis] * torque[1] + turn[6 + axis] * torque[2]
                residual[character, 3 + axis] -= sign * in_root
    return residual


@compiled
def cone_excess(wrench: Floats, friction: Floats) -> float:
    """N, how far the worst contact leaves the friction cone: negative normal force, or tangential force beyond mu N."""
    worst = -np.inf
    for i in range(len(wrench)):
        tangential = math.sqrt(wrench[i, 1] * wrench[i, 1] + wrench[i, 2] * wrench[i, 2])
        worst = max(worst, -wrench[i, 0], tangential - friction[i, 0] * wrench[i, 0])
    return worst


@compiled
def same(a: Floats, b: Floats) -> bool:
    """Equal number by number."""
    for i in range(len(a)):  # noqa: SIM110 (a compiled loop)
        if a[i] != b[i]:
            return False
    return True
