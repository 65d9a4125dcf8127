"""The convex polygon of the standing soles, seen from above: membership with a margin, and the nearest point inside."""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]


@compiled
def sole_corners(centre: Floats, yaw_rad: float, half_length: float, half_width: float) -> Floats:
    """(4, 2) m, corners of a sole whose centre (2,) is given, counter-clockwise."""
    c, s = math.cos(yaw_rad), math.sin(yaw_rad)
    out = np.empty((4, 2))
    signs = ((1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0))
    for k in range(4):
        x, y = signs[k][0] * half_length, signs[k][1] * half_width
        out[k, 0], out[k, 1] = centre[0] + c * x - s * y, centre[1] + s * x + c * y
    return out


@compiled
def hull_of_soles(
    left: Floats, left_yaw: float, right: Floats, right_yaw: float, use_left: bool, use_right: bool, half_length: float, half_width: float
) -> Floats:
    """(n, 2) m: the hull of one sole or of both; centres (2,) or (3,)."""
    if use_left and use_right:
        both = np.empty((8, 2))
        both[:4] = sole_corners(left, left_yaw, half_length, half_width)
        both[4:] = sole_corners(right, right_yaw, half_length, half_width)
        return convex_hull(both)
    if use_left:
        return sole_corners(left, left_yaw, half_length, half_width)
    return sole_corners(right, right_yaw, half_length, half_width)


@compiled
def _turns_left(a: Floats, b: Floats, c: Floats) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


@compiled
def convex_hull(points: Floats) -> Floats:
    """(n, 2) corners of the hull of points (m, 2), counter-clockwise (Andrew's monotone chain, 1979)."""
    count = len(points)
    order = _sorted_by_x(points)
    hull = np.empty((2 * count + 1, 2))
    size = 0
    for k in range(count):
        while size >= 2 and _turns_left(hull[size - 2], hull[size - 1], points[order[k]]) <= 0.0:
            size -= 1
        hull[size] = points[order[k]]
        size += 1
    least = size + 1
    for k in range(count - 2, -1, -1):
        while size >= least and _turns_left(hull[size - 2], hull[size - 1], points[order[k]]) <= 0.0:
            size -= 1
        hull[size] = points[order[k]]
        size += 1
    return hull[: max(size - 1, 1)].copy()


@compiled
def _sorted_by_x(points: Floats) -> NDArray[np.int64]:
    """Indices by x, then y: insertion sort, for at most eight corners."""
    order = np.arange(len(points))
    for k in range(1, len(points)):
        item = order[k]
        at = k
        while at > 0:
            before = order[at - 1]
            if points[before, 0] < points[item, 0] or (points[before, 0] == points[item, 0] and points[before, 1] <= points[item, 1]):
                break
            order[at] = before
            at -= 1
        order[at] = item
    return order


@compiled
def distance_inside(hull: Floats, point: Floats) -> float:
    """m from point (2,) to the nearest edge line of a counter-clockwise convex polygon: positive inside, negative outside."""
    least = np.inf
    for k in range(len(hull)):
        a, b = hull[k], hull[(k + 1) % len(hull)]
        length = math.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) + 1e-12
        least = min(least, _turns_left(a, b, point) / length)
    return least


@compiled
def nearest_inside(hull: Floats, point: Floats) -> Floats:
    """(2,) the point itself where it lies inside, else the nearest point of the polygon's edge."""
    if distance_inside(hull, point) >= 0.0:
        return point.copy()
    best = hull[0].copy()
    least = np.inf
    for k in range(len(hull)):
        a, b = hull[k], hull[(k + 1) % len(hull)]
        edge = b - a
        along = ((point[0] - a[0]) * edge[0] + (point[1] - a[1]) * edge[1]) / (edge[0] ** 2 + edge[1] ** 2 + 1e-18)
        candidate = a + min(max(along, 0.0), 1.0) * edge
        distance = (candidate[0] - point[0]) ** 2 + (candidate[1] - point[1]) ** 2
        if distance < least:
            least, best = distance, candidate
    return best


@compiled
def share_inside(hull: Floats, point: Floats, way: Floats) -> float:
    """The share, 1 at most, of a way (2,) from a point inside that stays inside."""
    share = 1.0
    for k in range(len(hull)):
        a, b = hull[k], hull[(k + 1) % len(hull)]
        inside, leaves = _turns_left(a, b, point), (b[1] - a[1]) * way[0] - (b[0] - a[0]) * way[1]
        if share * leaves > inside:
            share = inside / leaves
    return share
