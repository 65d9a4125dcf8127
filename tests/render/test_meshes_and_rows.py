"""The rounded box is closed and faces outwards; drawables become the rows they say."""

import numpy as np
import pytest

from game.drawables import Boxes, Capsules, Label, Layer, Lines, Points
from game.render.culling import in_view
from game.render.instances import box_rows, capsule_rows, pack
from game.render.matrices import look_at, multiply, perspective
from game.render.meshes import rounded_box

_UPRIGHT = np.array([[1.0, 0.0, 0.0, 0.0]])


def placed(segments: int, half: np.ndarray, bevel: float) -> tuple[np.ndarray, np.ndarray]:
    vertices, triangles = rounded_box(segments)
    return vertices[:, :3] * (half - bevel) + bevel * vertices[:, 3:6], triangles


@pytest.mark.parametrize("segments", [0, 1, 3])
def test_the_rounded_box_encloses_its_volume(segments: int) -> None:
    points, triangles = placed(segments, np.array([0.5, 0.3, 0.2]), 0.0)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0  # positive only where every face looks outwards
    assert volume == pytest.approx(8 * 0.5 * 0.3 * 0.2)


def test_a_box_all_bevel_is_a_ball() -> None:
    points, _ = placed(4, np.array([0.1, 0.1, 0.1]), 0.1)
    assert np.allclose(np.linalg.norm(points, axis=1), 0.1, atol=1e-7)


def test_no_vertex_leaves_the_box() -> None:
    half = np.array([0.2, 0.1, 0.05])
    points, _ = placed(3, half, 0.03)
    assert (np.abs(points) <= half + 1e-7).all()


@pytest.mark.parametrize("end", [(0.3, 0.0, 0.4), (0.0, 0.0, -1.0), (0.0, 0.0, 1.0), (-0.2, 0.5, -0.1)])
def test_a_capsule_points_from_start_to_end(end: tuple[float, float, float]) -> None:
    row = capsule_rows(Capsules(np.zeros((1, 3)), np.array([end]), np.array([0.05]), np.ones((1, 4))))[0]
    w, x, y, z = row[4:8]
    axis = np.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
    assert np.allclose(axis, np.array(end) / np.linalg.norm(end), atol=1e-5)
    assert row[10] == pytest.approx(0.05 + np.linalg.norm(end) / 2)


def test_a_ball_is_a_capsule_of_no_length() -> None:
    row = capsule_rows(Capsules(np.ones((1, 3)), np.ones((1, 3)), np.array([0.2]), np.ones((1, 4))))[0]
    assert np.allclose(row[8:11], 0.2)
    assert np.isfinite(row).all()


def test_an_unknown_material_names_the_valid_ones() -> None:
    with pytest.raises(ValueError, match=r"no material 'gold'; valid: plain, planks"):
        box_rows(Boxes(np.zeros((1, 3)), _UPRIGHT, np.ones((1, 3)), np.ones((1, 4)), material="gold"))


def test_everything_listed_is_packed_once() -> None:
    box = Boxes(np.zeros((2, 3)), np.tile(_UPRIGHT, (2, 1)), np.ones((2, 3)), np.ones((2, 4)), casts_shadow=False)
    ball = Capsules(np.zeros((1, 3)), np.zeros((1, 3)), np.array([0.2]), np.ones((1, 4)))
    lines = Lines(np.zeros((3, 2, 3)), np.ones((3, 4)))
    points = Points(np.zeros((4, 3)), np.ones((4, 4)))
    packed = pack((Layer("a", (box, ball, lines, points, Label(np.zeros(3), "x"))), Layer("b", (box,), opacity=0.5)))
    assert (len(packed.edged), packed.edged_casters, len(packed.round), packed.round_casters) == (2, 0, 1, 1)
    assert (len(packed.ghosts), len(packed.strokes)) == (2, 7)
    assert packed.ghosts[0, 15] == pytest.approx(0.5)


def test_what_is_behind_the_camera_is_left_out() -> None:
    matrix = multiply(perspective(0.7, 1.5, 0.1, 40.0), look_at((3.0, 0.0, 1.0), (0.0, 0.0, 1.0)))
    places = np.array([(0.0, 0.0, 1.0), (6.0, 0.0, 1.0), (0.0, 9.0, 1.0)])
    rows = box_rows(Boxes(places, np.tile(_UPRIGHT, (3, 1)), np.full((3, 3), 0.1), np.ones((3, 4))))
    assert in_view(rows, matrix).tolist() == [True, False, False]
