"""The support polygon: every statement checked corner by corner or edge by edge, on polygons that hypothesis makes up."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from game.control.whole_body.support_polygon import convex_hull, distance_inside, nearest_inside, share_inside, sole_corners

metres = st.integers(-1000, 1000).map(lambda k: k / 1000.0)
clouds = st.integers(3, 8).flatmap(lambda n: arrays(np.float64, (n, 2), elements=metres))
places = arrays(np.float64, (2,), elements=metres)


def soles(left_x=0.0, left_yaw=0.0, right_x=0.0, right_yaw=0.0):
    """Corners of two soles, 0.3 m by 0.08 m, 0.2 m apart."""
    left = sole_corners(np.array([left_x, 0.1]), left_yaw, 0.15, 0.04)
    return np.concatenate((left, sole_corners(np.array([right_x, -0.1]), right_yaw, 0.15, 0.04)))


def flat(points):
    """True where all points lie on one line, and no polygon can be."""
    return np.linalg.matrix_rank(points - points[0], tol=1e-7) < 2


def edge_distances(hull, point):
    """Signed distance of point to each edge line, positive on the left."""
    edges = np.roll(hull, -1, axis=0) - hull
    away = point - hull
    return (edges[:, 0] * away[:, 1] - edges[:, 1] * away[:, 0]) / np.hypot(*edges.T)


def is_extreme(points, k):
    """By brute force: some direction finds point k strictly farthest of all other places."""
    others = points[np.any(points != points[k], axis=1)]
    normals = []
    for other in others:
        edge = other - points[k]
        normals += [np.array([edge[1], -edge[0]]), np.array([-edge[1], edge[0]])]
    return any(np.all((others - points[k]) @ n <= 1e-12) for n in normals)


@given(clouds)
def test_all_points_lie_inside_their_hull_and_its_corners_are_among_them(points):
    hull = convex_hull(points)
    for corner in hull:
        assert np.any(np.all(points == corner, axis=1))
    if not flat(points):
        for point in points:
            assert edge_distances(hull, point).min() >= -1e-9


@given(clouds)
def test_a_hull_turns_left_at_every_corner(points):
    hull = convex_hull(points)
    if flat(points):
        return
    ahead, behind = np.roll(hull, -1, axis=0) - hull, hull - np.roll(hull, 1, axis=0)
    assert np.all(behind[:, 0] * ahead[:, 1] - behind[:, 1] * ahead[:, 0] > 0.0)


@given(clouds)
def test_every_corner_of_a_hull_is_extreme_and_no_extreme_point_is_left_out(points):
    if flat(points):
        return
    hull = {tuple(corner) for corner in convex_hull(points)}
    for k in range(len(points)):
        if tuple(points[k]) in hull:
            assert is_extreme(points, k)
    # no direction finds a point beyond the hull's own farthest; which one, a tie leaves open
    directions = np.stack((np.cos(np.arange(64)), np.sin(np.arange(64))))
    reach = (np.array(sorted(hull)) @ directions).max(axis=0)
    np.testing.assert_array_equal((points @ directions).max(axis=0), reach)


@given(clouds, places)
def test_the_distance_inside_is_that_to_the_nearest_edge_line(points, place):
    if flat(points):
        return
    hull = convex_hull(points)
    assert distance_inside(hull, place) == pytest.approx(edge_distances(hull, place).min(), abs=1e-9)


@given(clouds, places)
def test_the_nearest_point_inside_is_inside_and_none_sampled_is_nearer(points, place):
    if flat(points):
        return
    hull = convex_hull(points)
    nearest = nearest_inside(hull, place)
    assert distance_inside(hull, nearest) >= -1e-9
    along = np.linspace(0.0, 1.0, 101)[:, None, None]
    outline = ((1.0 - along) * hull + along * np.roll(hull, -1, axis=0)).reshape(-1, 2)
    gap = np.hypot(*(outline - place).T).min()
    if distance_inside(hull, place) >= 0.0:
        np.testing.assert_array_equal(nearest, place)
    else:
        assert np.hypot(*(nearest - place)) <= gap + 1e-9
        assert np.hypot(*(nearest - place)) >= gap - 0.03


def test_the_corners_of_a_turned_sole_are_its_turned_corners():
    corners = sole_corners(np.array([1.0, 2.0]), np.pi / 2, 0.15, 0.04)
    np.testing.assert_allclose(corners, [[0.96, 2.15], [0.96, 1.85], [1.04, 1.85], [1.04, 2.15]], atol=1e-12)
    assert edge_distances(corners, np.array([1.0, 2.0])).min() == pytest.approx(0.04)


def test_two_soles_side_by_side_make_one_rectangle():
    hull = convex_hull(soles())
    assert {tuple(np.round(c, 9)) for c in hull} == {(0.15, 0.14), (-0.15, 0.14), (-0.15, -0.14), (0.15, -0.14)}
    assert distance_inside(hull, np.zeros(2)) == pytest.approx(0.14)
    assert distance_inside(hull, np.array([0.2, 0.0])) == pytest.approx(-0.05)


def test_a_lunge_makes_a_longer_polygon_than_either_sole():
    hull = convex_hull(soles(left_x=0.4, left_yaw=0.3))
    assert distance_inside(hull, np.array([0.2, 0.0])) > 0.0
    assert distance_inside(hull, np.array([0.2, 0.12])) < 0.0


def test_what_is_handed_in_is_left_as_it_was():
    points, place = soles(), np.array([0.5, 0.5])
    copies = points.copy(), place.copy()
    nearest_inside(convex_hull(points), place)
    np.testing.assert_array_equal(points, copies[0])
    np.testing.assert_array_equal(place, copies[1])


@given(clouds.filter(lambda points: not flat(points)), places, places)
def test_so_much_of_a_way_stays_inside_and_no_more(points, place, way):
    hull = convex_hull(points)
    start = nearest_inside(hull, place)
    start += 1e-3 * (hull.mean(axis=0) - start)
    share = share_inside(hull, start, way)
    assert 0.0 <= share <= 1.0
    assert distance_inside(hull, start + share * way) > -1e-9
    assert share == 1.0 or distance_inside(hull, start + 1.001 * share * way) < 1e-9
