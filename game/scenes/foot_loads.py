"""What the floor gives each foot, measured from the contact forces: the loads and the centre of pressure."""

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import FEET, PART_COUNT
from game.compiled import compiled
from game.physics.contacts import FLOOR, ContactForces

Floats = NDArray[np.float64]

_FLOOR_BODY = 0
_LEFT, _RIGHT = FEET
LEAST_LOAD_N = 5.0
"""Below this a centre of pressure says nothing."""

assert FLOOR == (_FLOOR_BODY - 1) // PART_COUNT


def ground_loads(found: ContactForces | None, first_body: int) -> Floats:
    """(5,): vertical force of the floor on the left and the right foot (N) and on the whole character, centre of pressure x, y (m).

    first_body: MuJoCo id of the character's root. The centre of pressure is NaN where the floor bears next to nothing: in flight.
    """
    if found is None:
        return np.array([0.0, 0.0, 0.0, np.nan, np.nan])
    return _ground_loads(found.point, found.force, found.body, first_body)


@compiled
def _ground_loads(point: Floats, force: Floats, body: NDArray[np.int64], first_body: int) -> Floats:
    out = np.zeros(5)
    for i in range(len(point)):
        # the force acts on the second partner, its reaction on the first
        if body[i, 0] == _FLOOR_BODY:
            part, lift = body[i, 1] - first_body, force[i, 2]
        elif body[i, 1] == _FLOOR_BODY:
            part, lift = body[i, 0] - first_body, -force[i, 2]
        else:
            continue
        if part < 0 or part >= PART_COUNT:
            continue
        if part == _LEFT:
            out[0] += lift
        elif part == _RIGHT:
            out[1] += lift
        out[2] += lift
        out[3] += lift * point[i, 0]
        out[4] += lift * point[i, 1]
    if out[2] < LEAST_LOAD_N:
        out[3] = out[4] = np.nan
    else:
        out[3] /= out[2]
        out[4] /= out[2]
    return out
