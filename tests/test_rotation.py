"""Rotations obey the identities of their group, also where formulas are weakest: at no turn, half a turn, opposite directions."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game import rotation
from game.rotation import Floats

FEW = settings(max_examples=30)
NUMBER = st.floats(-1.0, 1.0)
DIRECTION = st.tuples(NUMBER, NUMBER, NUMBER).map(np.array).filter(lambda v: np.linalg.norm(v) > 0.05).map(lambda v: v / np.linalg.norm(v))
ANGLE = st.one_of(st.floats(0.0, math.pi), st.sampled_from([0.0, 1e-300, 1e-12, 1e-5, math.pi - 1e-9, math.pi]))
TURN = st.builds(lambda axis, angle: rotation.exp(axis * angle), DIRECTION, ANGLE)
VECTOR = st.tuples(NUMBER, NUMBER, NUMBER).map(np.array)


def same_turn(a: Floats, b: Floats, atol: float = 1e-12) -> None:
    """q and -q are the same rotation."""
    np.testing.assert_allclose(rotation.matrix(a), rotation.matrix(b), atol=atol)


def rodrigues(axis: Floats, angle: float) -> Floats:
    """The rotation matrix from axis and angle, by Rodrigues' formula."""
    k = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    return np.eye(3) + math.sin(angle) * k + (1.0 - math.cos(angle)) * k @ k


@FEW
@given(DIRECTION, ANGLE)
def test_the_exponential_turns_about_its_axis_by_its_length(axis, angle):
    np.testing.assert_allclose(rotation.matrix(rotation.exp(axis * angle)), rodrigues(axis, angle), atol=1e-12)


@FEW
@given(DIRECTION, ANGLE)
def test_the_logarithm_undoes_the_exponential_up_to_half_a_turn(axis, angle):
    vector = rotation.log(rotation.exp(axis * angle))
    if angle < math.pi - 1e-6:
        np.testing.assert_allclose(vector, axis * angle, atol=1e-9)
    else:  # at half a turn both ways round are as short
        assert np.linalg.norm(vector) == pytest.approx(angle, abs=1e-9)
        np.testing.assert_allclose(np.abs(vector @ axis), angle, atol=1e-6)


@FEW
@given(TURN)
def test_a_quaternion_and_its_negative_have_the_same_shortest_rotation_vector(q):
    vector = rotation.log(q)
    assert np.linalg.norm(vector) <= math.pi + 1e-12
    if np.linalg.norm(vector) < math.pi - 1e-6:
        np.testing.assert_allclose(rotation.log(-q), vector, atol=1e-9)


def test_no_turn_has_no_rotation_vector_and_no_rotation_vector_is_no_turn():
    np.testing.assert_array_equal(rotation.exp(np.zeros(3)), rotation.IDENTITY)
    np.testing.assert_array_equal(rotation.log(rotation.IDENTITY), np.zeros(3))
    np.testing.assert_array_equal(rotation.log(-rotation.IDENTITY), np.zeros(3))


@FEW
@given(TURN, TURN, TURN)
def test_products_are_associative_and_compose_like_matrices(a, b, c):
    left = rotation.multiply(rotation.multiply(a, b), c)
    np.testing.assert_allclose(left, rotation.multiply(a, rotation.multiply(b, c)), atol=1e-12)
    np.testing.assert_allclose(rotation.matrix(rotation.multiply(a, b)), rotation.matrix(a) @ rotation.matrix(b), atol=1e-12)


@FEW
@given(TURN)
def test_the_conjugate_is_the_inverse(q):
    np.testing.assert_allclose(rotation.multiply(q, rotation.conjugate(q)), rotation.IDENTITY, atol=1e-12)
    np.testing.assert_allclose(rotation.matrix(rotation.conjugate(q)), rotation.matrix(q).T, atol=1e-12)


@FEW
@given(TURN)
def test_a_matrix_is_a_proper_rotation_and_gives_its_quaternion_back(q):
    m = rotation.matrix(q)
    np.testing.assert_allclose(m @ m.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(m) == pytest.approx(1.0)
    back = rotation.from_matrix(m)
    assert np.linalg.norm(back) == pytest.approx(1.0)
    same_turn(back, q)


@pytest.mark.parametrize("axis", np.vstack((np.eye(3), np.ones((1, 3)) / math.sqrt(3.0))))
def test_half_a_turn_survives_its_matrix(axis):
    q = rotation.exp(math.pi * axis)
    same_turn(rotation.from_matrix(rotation.matrix(q)), q)


@FEW
@given(TURN, VECTOR)
def test_rotating_is_conjugation_and_unrotating_undoes_it(q, v):
    turned = rotation.rotate(q, v)
    sandwich = rotation.multiply(rotation.multiply(q, np.array([0.0, *v])), rotation.conjugate(q))
    np.testing.assert_allclose(np.array([0.0, *turned]), sandwich, atol=1e-12)
    np.testing.assert_allclose(rotation.unrotate(q, turned), v, atol=1e-12)
    m = rotation.matrix(q)
    np.testing.assert_allclose(rotation.turn_back(m, rotation.turn(m, v)), v, atol=1e-12)


@FEW
@given(VECTOR, VECTOR)
def test_the_cross_product_is_numpys(a, b):
    np.testing.assert_allclose(rotation.cross(a, b), np.cross(a, b), atol=1e-15)


@FEW
@given(DIRECTION, DIRECTION)
def test_between_turns_one_direction_into_the_other_without_twist(a, b):
    q = rotation.between(a, b)
    assert np.linalg.norm(q) == pytest.approx(1.0)
    np.testing.assert_allclose(rotation.rotate(q, a), b, atol=1e-7)
    vector = rotation.log(q)
    # the smallest rotation turns about a common normal, by the angle between the two
    assert abs(vector @ a) < 1e-7 and abs(vector @ b) < 1e-7
    assert np.linalg.norm(vector) == pytest.approx(math.atan2(np.linalg.norm(np.cross(a, b)), a @ b), abs=1e-7)


@FEW
@given(DIRECTION, DIRECTION, st.sampled_from([0.0, 1e-12, 1e-8, 1e-6, 3e-5, 1e-4, 1e-3]))
def test_between_reaches_nearly_opposite_directions(a, aside, off):
    b = rotation.normalise(-a + off * aside)
    q = rotation.between(a, b)
    assert np.linalg.norm(q) == pytest.approx(1.0)
    np.testing.assert_allclose(rotation.rotate(q, a), b, atol=1e-7)


def test_between_takes_many_pairs_at_once_opposites_among_them():
    a = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.8, 0.0]])
    b = np.array([[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [-0.6, -0.8, 0.0]])
    np.testing.assert_allclose(rotation.rotate(rotation.between(a, b), a), b, atol=1e-12)
    np.testing.assert_allclose(rotation.between(a[1], b[1]), rotation.IDENTITY)


@FEW
@given(DIRECTION, DIRECTION)
def test_from_axes_keeps_up_exactly_and_comes_as_near_to_y_as_it_can(y, up):
    if np.linalg.norm(np.cross(y, up)) < 1e-3:
        return
    m = rotation.matrix(rotation.from_axes(2.0 * y, 3.0 * up))
    np.testing.assert_allclose(m[:, 2], up, atol=1e-9)
    nearest = y - (y @ up) * up
    np.testing.assert_allclose(m[:, 1], nearest / np.linalg.norm(nearest), atol=1e-9)


@FEW
@given(st.floats(-math.pi + 1e-9, math.pi), st.floats(-1.5, 1.5), st.floats(-math.pi, math.pi))
def test_yaw_is_where_the_x_axis_points_seen_from_above(heading, pitch, roll):
    q = rotation.about_z(heading)
    for vector in (np.array([0.0, pitch, 0.0]), np.array([roll, 0.0, 0.0])):
        q = rotation.multiply(q, rotation.exp(vector))
    forward = rotation.matrix(q)[:, 0]
    assert rotation.yaw(q) == pytest.approx(math.atan2(forward[1], forward[0]), abs=1e-9)
    assert math.cos(rotation.yaw(q) - heading) == pytest.approx(1.0)


@FEW
@given(st.lists(st.tuples(DIRECTION, ANGLE, VECTOR), min_size=4, max_size=4))
def test_a_stack_of_rotations_is_treated_row_by_row(rows):
    vectors = np.array([axis * angle for axis, angle, _ in rows]).reshape(2, 2, 3)
    points = np.array([v for _, _, v in rows]).reshape(2, 2, 3)
    q = rotation.exp(vectors)
    for i in range(2):
        for j in range(2):
            np.testing.assert_array_equal(rotation.exp(vectors[i, j]), q[i, j])
            np.testing.assert_allclose(rotation.log(q)[i, j], rotation.log(q[i, j]), atol=1e-14)
            np.testing.assert_allclose(rotation.rotate(q, points)[i, j], rotation.rotate(q[i, j], points[i, j]), atol=1e-14)
            np.testing.assert_allclose(rotation.multiply(q, q[::-1])[i, j], rotation.multiply(q[i, j], q[1 - i, j]), atol=1e-14)
