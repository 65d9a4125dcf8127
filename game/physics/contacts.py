"""Contact forces in world axes, from mj_contactForce alone, and between whom they act."""

from dataclasses import dataclass
from functools import lru_cache

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import PART_COUNT
from game.compiled import compiled

Floats = NDArray[np.float64]
Indices = NDArray[np.int32]

FLOOR = -1


@dataclass(frozen=True)
class ContactForces:
    """The n contacts of one step, world frame.

    point (n, 3) m; force (n, 3) N on the second partner; wrench (n, 6) in the contact's frame, normal first;
    friction (n,); body (n, 2): MuJoCo body ids of the partners, 0 for the floor.
    """

    point: Floats
    force: Floats
    wrench: Floats
    friction: Floats
    body: NDArray[np.int64]

    @property
    def character(self) -> NDArray[np.int64]:
        """(n, 2) character index of the partners, -1 for the floor."""
        return (self.body - 1) // PART_COUNT

    @property
    def part(self) -> NDArray[np.int64]:
        """(n, 2) index into `PARTS` of the partners; of no meaning for the floor."""
        return (self.body - 1) % PART_COUNT

    @property
    def tangential(self) -> Floats:
        """(n,) N, size of the friction force."""
        return np.hypot(self.wrench[:, 1], self.wrench[:, 2])

    def parts_on_floor(self, character: int) -> list[int]:
        """Indices into `PARTS` of what the character has on the floor, once for each contact."""
        owners, parts = self.character, self.part
        hits = (owners == character) & (owners[:, ::-1] == FLOOR)
        return [int(part) for part in parts[hits]]

    def on_characters(self, count: int) -> Floats:
        """(count, n) +1 where the contact's force acts on the character, -1 where its reaction does, else 0."""
        rows = _owner_rows(count)
        return (rows[self.body[:, 1]] - rows[self.body[:, 0]]).T


@lru_cache
def _owner_rows(count: int) -> Floats:
    """(bodies, count): 1 in the column of the character that a body belongs to; the floor's row is zero."""
    return np.vstack((np.zeros((1, count)), np.repeat(np.eye(count), PART_COUNT, axis=0)))


def contact_forces(model: mj.MjModel, data: mj.MjData, wrench: Floats | None = None) -> ContactForces | None:
    """All contacts of the step just taken, None where there are none; points are those of its start, where the forces acted.

    wrench (n, 6): what mj_contactForce gives of them, where somebody has asked it already.
    """
    count = data.ncon
    if count == 0:
        return None
    if wrench is None:
        wrench = np.empty((count, 6))
        for i in range(count):
            mj.mj_contactForce(model, data, i, wrench[i])
    contacts = data.contact
    point, force, friction, body = np.empty((count, 3)), np.empty((count, 3)), np.empty(count), np.empty((count, 2), np.int64)
    _in_world(
        contacts.pos, contacts.frame, contacts.friction, contacts.geom, model.geom_bodyid, wrench, point, force, friction, body
    )  # fmt: skip
    return ContactForces(point, force, wrench, friction, body)


@compiled
def _in_world(
    place: Floats, frame: Floats, coefficients: Floats, geom: Indices, owner: Indices, wrench: Floats, point: Floats, force: Floats,
    friction: Floats, body: NDArray[np.int64],
) -> None:  # fmt: skip
    """Fill the fields of `ContactForces` from MuJoCo's contacts: place (n, 3), frame (n, 9), coefficients (n, 5), geom (n, 2); owner of
    each geom; wrench (n, 6)."""
    for i in range(len(point)):
        friction[i] = coefficients[i, 0]
        body[i, 0], body[i, 1] = owner[geom[i, 0]], owner[geom[i, 1]]
        for axis in range(3):
            point[i, axis] = place[i, axis]
            force[i, axis] = wrench[i, 0] * frame[i, axis] + wrench[i, 1] * frame[i, 3 + axis] + wrench[i, 2] * frame[i, 6 + axis]
