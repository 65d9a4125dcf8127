"""The floor's skin: what comes down fast is caught before it is in, for in one step of 1/480 s a hand at 5 m/s goes 1 cm."""

from collections.abc import Sequence

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import FEET, PART_COUNT, PARTS
from game.compiled import compiled
from game.physics.dynamics import BodyDynamics
from game.physics.model import skin_name

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

SLOW_M_S, AHEAD_S, MOST_M = 2.0, 0.014, 0.06
"""A corner that comes down faster than the first is caught farther off the floor: by what it goes beyond that speed in so long, at most
the third. Feet are not: one that comes down from a quick step would land on air."""


class FloorSkin:
    """How near to the floor each part but the feet is caught: the margins of its contacts, brought up to date by `thicken` after each
    step."""

    def __init__(self, model: mj.MjModel, data: mj.MjData, characters: Sequence[BodyDynamics]) -> None:
        skinned = [part for part in range(PART_COUNT) if part not in FEET]
        bodies = [(index, body.root_body, part) for index, body in enumerate(characters) for part in skinned]
        self._body = np.array([root + part for _, root, part in bodies])
        self._root = np.array([root for _, root, _ in bodies])
        self._pair = np.array([model.pair(skin_name(index, PARTS[part])).id for index, _, part in bodies])
        self._geom = model.body_geomadr[self._body].astype(np.int64)
        self._half = model.geom_size[self._geom]
        self._at_rest, self._margin = model.pair_margin.copy(), model.pair_margin
        # views: MuJoCo steps in place
        self._seen = data.geom_xpos, data.geom_xmat, data.cvel, data.subtree_com

    def thicken(self) -> None:
        """To what the step that has just been taken began with: never to what someone looked at since, which must change nothing."""
        _thicken(self._body, self._root, self._geom, self._half, self._pair, *self._seen, self._at_rest, self._margin)


@compiled
def _thicken(
    body: Indices, root: Indices, geom: Indices, half: Floats, pair: Indices, place: Floats, turn: Floats, twist: Floats, com: Floats,
    at_rest: Floats, margin: Floats,
) -> None:  # fmt: skip
    """Fill margin (n,) m of boxes of half extents `half` (n, 3); twist (bodies, 6): rotation first, of the point `com` of the root."""
    for k in range(len(body)):
        g, spin = geom[k], twist[body[k], :3]
        x, y = place[g, 0] - com[root[k], 0], place[g, 1] - com[root[k], 1]
        for axis in range(3):
            # the lowest corner lies to this side along the box's axis
            out = -half[k, axis] if turn[g, 6 + axis] > 0.0 else half[k, axis]
            x += out * turn[g, axis]
            y += out * turn[g, 3 + axis]
        down = spin[1] * x - spin[0] * y - twist[body[k], 5]
        # asked this way round, a speed that is not a number counts as slow
        ahead_m = AHEAD_S * (down - SLOW_M_S) if down > SLOW_M_S else 0.0
        margin[pair[k]] = at_rest[pair[k]] + min(ahead_m, MOST_M)
