"""The one shape everything solid is drawn from: a box with rounded edges, given its size and bevel per instance.

A vertex holds a corner sign s, a direction d on the unit sphere and the face it belongs to; the vertex shader places it at
s * (half_size - bevel) + bevel * d. A bevel equal to all half sizes is a sphere, equal to two of them a capsule.
"""

import numpy as np
from numpy.typing import NDArray

FLOATS_PER_VERTEX = 9


def rounded_box(segments: int) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Vertices (V, 9) = corner sign, direction, face normal; triangles (T, 3), counter-clockwise seen from outside.

    segments: facets from the middle of an edge's round to the face; 0 gives sharp edges.
    """
    angles = np.linspace(0.0, np.pi / 4.0, segments + 1)
    steps = [(-1.0, -a) for a in angles[::-1]] + [(1.0, a) for a in angles]
    vertices, triangles = [], []
    for axis in range(3):
        for side in (-1.0, 1.0):
            first = len(vertices)
            vertices += [_vertex(axis, side, u, v, segments) for v in steps for u in steps]
            triangles += _grid(first, len(steps), side > 0.0)
    return np.array(vertices, dtype=np.float32), np.array(triangles, dtype=np.int32)


def _vertex(axis: int, side: float, u: tuple[float, float], v: tuple[float, float], segments: int) -> list[float]:
    other = ((axis + 1) % 3, (axis + 2) % 3)
    sign, face, way = np.zeros(3), np.zeros(3), np.zeros(3)
    sign[[axis, *other]] = side, u[0], v[0]
    face[axis] = side
    way[[axis, *other]] = side, np.tan(u[1]), np.tan(v[1])
    if segments == 0:
        way = sign.copy()  # sharp: the bevel is filled up to the corner
    else:
        way /= np.linalg.norm(way)
    return [*sign, *way, *face]


def _grid(first: int, count: int, outward: bool) -> list[tuple[int, int, int]]:
    triangles = []
    for row in range(count - 1):
        for column in range(count - 1):
            a = first + row * count + column
            b, c, d = a + 1, a + count, a + count + 1
            triangles += [(a, b, d), (a, d, c)] if outward else [(a, d, b), (a, c, d)]
    return triangles
