"""What the picture shows: light, shadow, ghosts, one-sided walls, and that every tunable of the picture is seen in it."""

import numpy as np
import pytest

from game.drawables import Boxes, Capsules, Layer, Lines, Points
from game.render.camera import Camera
from game.render.quality import QUALITIES
from game.scenes.living_room import living_room, room_cameras
from game.scenes.scene import CameraHint
from game.tunables import TUNABLES
from tests.render.biped import dressed_biped, plain_biped

_UPRIGHT = np.array([[1.0, 0.0, 0.0, 0.0]])
_WHITE = np.ones((1, 4))


def box(
    centre: tuple[float, float, float], half: tuple[float, float, float], colour: tuple[float, float, float] = (0.6, 0.6, 0.6), **more
) -> Boxes:
    return Boxes(np.array([centre]), _UPRIGHT, np.array([half]), np.array([[*colour, 1.0]]), **more)


FLOOR = Layer("floor", (box((0.0, 0.0, -0.05), (3.0, 3.0, 0.05), casts_shadow=False),))
FROM_ABOVE = Camera(CameraHint((0.01, 0.0, 5.0), (0.0, 0.0, 0.0), 40.0))


def brightness(picture: np.ndarray) -> np.ndarray:
    return picture.astype(float).mean(axis=2)


@pytest.mark.parametrize("quality", list(QUALITIES))
def test_every_quality_draws_the_room_without_an_opengl_error(shoot, quality: str) -> None:
    picture = shoot((*living_room(), dressed_biped()), quality)
    assert picture.std() > 30  # neither black nor white
    assert (picture.max(axis=2) > 250).mean() < 0.05  # little burns out
    assert (picture.max(axis=2) < 5).mean() < 0.05  # little drowns


def test_an_unknown_quality_names_the_valid_ones(window) -> None:
    from game.render.renderer import Renderer
    from game.tunables import Settings

    with pytest.raises(ValueError, match="valid: low, medium, high"):
        Renderer(window.ctx, "ultra", Settings())


@pytest.mark.parametrize("quality", list(QUALITIES))
def test_a_caster_darkens_the_floor_away_from_the_light(shoot, quality: str) -> None:
    def slab(casts: bool) -> Layer:
        return Layer("slab", (box((0.0, 0.0, 0.9), (0.3, 0.3, 0.05), casts_shadow=casts),))

    with_shadow = brightness(shoot((FLOOR, slab(True)), quality, FROM_ABOVE, light_azimuth_deg=90.0))
    without = brightness(shoot((FLOOR, slab(False)), quality, FROM_ABOVE, light_azimuth_deg=90.0))
    darker = without - with_shadow
    rows, columns = np.nonzero(darker > 25)
    assert len(rows) > 100
    # seen from above with the camera's right towards +y, light from +y throws the shadow to the left
    assert columns.mean() < 150


def test_the_same_layers_give_the_same_picture(shoot) -> None:
    layers = (*living_room(), dressed_biped())
    first = shoot(layers)
    for _ in range(10):  # the room settles into its own buffers meanwhile
        last = shoot((*living_room(), dressed_biped()))
    assert np.array_equal(first, last)


def test_standing_furniture_is_sent_to_the_graphics_card_once(shoot, renderers) -> None:
    for _ in range(10):
        shoot((*living_room(), dressed_biped()))
    before = renderers("low").fixed_uploads
    for i in range(5):
        shoot((*living_room(), dressed_biped(facing_deg=5.0 * i)))
    assert renderers("low").fixed_uploads == before


def test_furniture_that_leaves_is_gone(shoot) -> None:
    for _ in range(10):
        shoot((*living_room(), FLOOR))
    assert np.array_equal(shoot((FLOOR,), camera=FROM_ABOVE), shoot((FLOOR, Layer("empty")), camera=FROM_ABOVE))


def test_a_ghost_lets_the_room_through(shoot) -> None:
    room = shoot(living_room()).astype(float)
    solid = shoot((*living_room(), plain_biped((0.2, 0.5, 1.0, 1.0)))).astype(float)
    layer = plain_biped((0.2, 0.5, 1.0, 1.0))
    ghost = shoot((*living_room(), Layer("ghost", layer.drawables, opacity=0.35))).astype(float)
    body = np.abs(solid - room).max(axis=2) > 60
    assert 0.02 * body.sum() < np.abs(ghost - room)[body].mean() * body.sum() < 0.9 * np.abs(solid - room)[body].mean() * body.sum()
    assert np.abs(ghost - room)[body].mean() > 4.0


def test_a_ghost_hides_behind_what_is_in_front_of_it(shoot) -> None:
    wall = Layer("wall", (box((1.5, 0.0, 1.0), (0.02, 3.0, 3.0)),))
    ghost = Layer("ghost", plain_biped().drawables, opacity=0.5)
    assert np.array_equal(shoot((wall,)), shoot((wall, ghost)))


def test_a_ghost_stays_visible_on_the_body_it_coincides_with(shoot) -> None:
    body = plain_biped((0.5, 0.5, 0.5, 1.0))
    ghost = Layer("ghost", plain_biped((0.1, 0.4, 1.0, 1.0)).drawables, opacity=0.35)
    changed = np.abs(shoot((FLOOR, body, ghost)).astype(int) - shoot((FLOOR, body)).astype(int)).max(axis=2)
    assert (changed > 8).sum() > 1000


def test_walls_are_seen_only_from_within(shoot) -> None:
    room = Layer("shell", (box((0.0, 0.0, 1.0), (1.0, 1.0, 1.0), inside_out=True, casts_shadow=False),))
    ball = Capsules(np.array([[0.0, 0.0, 1.0]]), np.array([[0.0, 0.0, 1.0]]), np.array([0.3]), np.array([[1.0, 0.0, 0.0, 1.0]]))
    picture = shoot((room, Layer("ball", (ball,))), camera=Camera(CameraHint((3.0, 0.0, 1.0), (0.0, 0.0, 1.0))))
    red, green = picture[90, 160, 0], picture[90, 160, 1]
    assert red > 1.5 * green  # the near wall is not in the way
    assert picture[90, 190].mean() > 40  # the far one is there


def test_lines_and_points_are_as_wide_as_asked(shoot) -> None:
    lines = Lines(np.array([[[0.0, -1.0, 1.0], [0.0, 1.0, 1.0]]]), _WHITE, width_px=16.0)
    picture = shoot((Layer("lines", (lines,)),), camera=Camera(CameraHint((3.0, 0.0, 1.0), (0.0, 0.0, 1.0))))
    lit = brightness(picture)[:, 160] > 150
    assert lit.sum() == pytest.approx(16.0 * 180 / 720, abs=1.01)
    points = Points(np.array([[0.0, 0.0, 1.0]]), _WHITE, diameter_px=80.0)
    picture = shoot((Layer("points", (points,)),), camera=Camera(CameraHint((3.0, 0.0, 1.0), (0.0, 0.0, 1.0))))
    assert (brightness(picture) > 150).sum() == pytest.approx(np.pi * 10**2, rel=0.12)


def test_lines_on_top_show_through_walls(shoot) -> None:
    wall = Layer("wall", (box((1.5, 0.0, 1.0), (0.02, 3.0, 3.0)),))

    def marks(on_top: bool) -> Layer:
        return Layer("marks", (Lines(np.array([[[0.0, -1.0, 1.0], [0.0, 1.0, 1.0]]]), _WHITE, 8.0, on_top),))

    assert np.array_equal(shoot((wall, marks(False))), shoot((wall,)))
    assert not np.array_equal(shoot((wall, marks(True))), shoot((wall,)))


def test_a_layer_follows_its_switch(shoot, renderers) -> None:
    target = Layer("target", plain_biped().drawables, opacity=0.35)
    bare = shoot(living_room())
    assert np.array_equal(shoot((*living_room(), target)), bare)
    renderers("low").settings.set("layer.target", True)
    assert not np.array_equal(shoot((*living_room(), target)), bare)


@pytest.mark.parametrize("name", [name for name in TUNABLES if name.startswith("picture.")])
def test_every_tunable_of_the_picture_is_seen_in_it(shoot, name: str) -> None:
    layers = (*living_room(), dressed_biped())
    tunable = TUNABLES[name]
    default = float(tunable.default)  # type: ignore[arg-type]
    moved = default * 1.2 if default * 1.2 <= tunable.high else default * 0.8
    before = shoot(layers, "medium").astype(float)
    after = shoot(layers, "medium", **{name.split(".")[1]: moved}).astype(float)
    assert (np.abs(after - before).max(axis=2) >= 2).mean() > 0.01


def test_another_size_is_drawn_at_once_and_back(window, renderers) -> None:
    from game.render.capture import read_pixels

    target = window.ctx.simple_framebuffer((200, 260), components=4)
    camera = Camera(room_cameras()["mirror"])
    renderers("low").render((*living_room(), dressed_biped()), camera, target, (200, 260))
    assert window.ctx.error == "GL_NO_ERROR"
    assert read_pixels(target, (200, 260)).std() > 30
    renderers("low").render(living_room(), camera, target, (0, 0))  # a minimised window draws nothing
    window.screen.use()
    target.release()
