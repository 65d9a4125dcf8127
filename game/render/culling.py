"""Which solids a camera can see at all: a ball around each is held against the six sides of the view."""

import numpy as np
from numpy.typing import NDArray

from game.render.instances import Packed, Rows
from game.render.matrices import Matrix


def in_view(rows: Rows, matrix: Matrix) -> NDArray[np.bool_]:
    """(N,) True where a solid of rows (N, 18) may show under the world-to-clip matrix. Never False for one that does."""
    columns = np.array(matrix).reshape(4, 4).T
    planes = np.concatenate((columns[3] + columns[:3], columns[3] - columns[:3]))
    planes /= np.linalg.norm(planes[:, :3], axis=1, keepdims=True)
    radius = np.linalg.norm(rows[:, 8:11], axis=1)
    inside = rows[:, :3] @ planes[:, :3].T + planes[:, 3] > -radius[:, None]
    return inside.all(axis=1)


class View:
    """Of solids that stand still, those in view; says when their choice changed."""

    def __init__(self) -> None:
        self._matrix: Matrix = ()
        self._masks: tuple[bytes, bytes] | None = None

    def forget(self) -> None:
        """The solids changed: choose anew at the next `choose`."""
        self._matrix, self._masks = (), None

    def choose(self, packed: Packed, matrix: Matrix) -> Packed | None:
        """The solids in view, or None where the choice is the same as last time."""
        if matrix == self._matrix:
            return None
        self._matrix = matrix
        edged, round_ = in_view(packed.edged, matrix), in_view(packed.round, matrix)
        masks = (edged.tobytes(), round_.tobytes())
        if masks == self._masks:
            return None
        self._masks = masks
        return Packed(packed.edged[edged], 0, packed.round[round_], 0)
