"""Contact forces in world axes, from mj_contactForce alone, and between whom they act."""

from dataclasses import dataclass

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import PART_COUNT

Floats = NDArray[np.float64]

FLOOR = -1


@dataclass(frozen=True)
class ContactForces:
    """The n contacts of one step, world frame.

    point (n, 3) m; force (n, 3) N on the second partner; normal (n,) and tangential (n,) N; friction (n,);
    first, second (n,): character index of the partners, -1 for the floor; part_first, part_second (n,): index into `PARTS`.
    """

    point: Floats
    force: Floats
    normal: Floats
    tangential: Floats
    friction: Floats
    first: NDArray[np.int64]
    second: NDArray[np.int64]
    part_first: NDArray[np.int64]
    part_second: NDArray[np.int64]


def contact_forces(model: mj.MjModel, data: mj.MjData) -> ContactForces:
    """All contacts of the step just taken; positions are those of its start, where the forces were applied."""
    count = data.ncon
    contacts = data.contact
    wrench = np.zeros((count, 6))
    for i in range(count):
        mj.mj_contactForce(model, data, i, wrench[i])
    frame = contacts.frame.reshape(-1, 3, 3)
    force = (wrench[:, None, :3] @ frame)[:, 0, :] if count else np.zeros((0, 3))
    body = model.geom_bodyid[contacts.geom.reshape(-1, 2)]
    character = np.where(body > 0, (body - 1) // PART_COUNT, FLOOR)
    part = np.where(body > 0, (body - 1) % PART_COUNT, FLOOR)
    return ContactForces(
        contacts.pos.reshape(-1, 3),
        force,
        wrench[:, 0],
        np.sqrt(wrench[:, 1] ** 2 + wrench[:, 2] ** 2),
        contacts.friction.reshape(-1, 5)[:, 0],
        character[:, 0],
        character[:, 1],
        part[:, 0],
        part[:, 1],
    )
