"""The camera goes where it is asked to, and never through floor or wall."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.render.camera import Camera, Room
from game.scenes.scene import CameraHint

_HINT = CameraHint((3.0, 0.0, 1.4), (0.0, 0.0, 1.0), 40.0)


def test_a_preset_stands_where_it_says() -> None:
    assert Camera(_HINT).eye == pytest.approx((3.0, 0.0, 1.4))


def test_the_target_is_in_the_middle_of_the_picture() -> None:
    assert Camera(_HINT).project(np.array([0.0, 0.0, 1.0]), (640, 360)) == pytest.approx((320.0, 180.0))


def test_up_is_up_and_the_characters_left_is_on_the_right() -> None:
    x, y = Camera(_HINT).project(np.array([0.0, 0.5, 1.5]), (640, 360)) or (0.0, 0.0)
    assert x > 320.0
    assert y < 180.0


def test_nothing_is_projected_from_behind() -> None:
    assert Camera(_HINT).project(np.array([5.0, 0.0, 1.0]), (640, 360)) is None


def test_the_field_of_view_spans_the_height() -> None:
    camera = Camera(CameraHint((3.0, 0.0, 1.0), (0.0, 0.0, 1.0), 40.0))
    top = 1.0 + 3.0 * math.tan(math.radians(20.0))
    assert camera.project(np.array([0.0, 0.0, top]), (640, 360)) == pytest.approx((320.0, 0.0), abs=1e-6)


def test_a_quarter_round_ends_at_the_side() -> None:
    camera = Camera(CameraHint((2.0, 0.0, 1.0), (0.0, 0.0, 1.0)))
    camera.orbit(math.pi / 2, 0.0)
    assert camera.eye == pytest.approx((0.0, 2.0, 1.0), abs=1e-9)


def test_a_glide_is_smooth_and_arrives() -> None:
    camera = Camera(_HINT)
    goal = CameraHint((0.0, 2.5, 1.2), (0.2, 0.0, 0.9), 50.0)
    camera.go_to(goal, 1.0)
    eyes = [camera.eye]
    for _ in range(60):
        camera.advance(1 / 60)
        eyes.append(camera.eye)
    steps = np.linalg.norm(np.diff(eyes, axis=0), axis=1)
    assert camera.eye == pytest.approx(goal.eye)
    assert steps.max() < 0.15
    assert steps[0] < 0.3 * steps.max()


def test_taking_the_mouse_ends_a_glide() -> None:
    camera = Camera(_HINT)
    camera.go_to(CameraHint((0.0, 2.5, 1.2), (0.2, 0.0, 0.9)), 1.0)
    camera.advance(0.3)
    camera.orbit(0.1, 0.0)
    eye = camera.eye
    camera.advance(0.3)
    assert camera.eye == eye


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.sampled_from("opz"), st.floats(-3, 3), st.floats(-3, 3)), max_size=12))
def test_no_way_of_moving_leaves_the_room(moves: list[tuple[str, float, float]]) -> None:
    room = Room()
    camera = Camera(_HINT, room)
    for kind, a, b in moves:
        if kind == "o":
            camera.orbit(a, b)
        elif kind == "p":
            camera.pan(a, b)
        else:
            camera.zoom(math.exp(a))
    slack = 0.31  # the camera keeps this far from a target that itself stands at the wall
    for value, low, high in zip(camera.eye, room.low, room.high, strict=True):
        assert low - slack <= value <= high + slack
    assert camera.eye[2] > 0.05
    assert np.isfinite(camera.view_projection(16 / 9)).all()
