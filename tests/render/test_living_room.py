"""A room one can play in: the middle is free, the television is in front, cameras stand in the air."""

import numpy as np

from game.drawables import Boxes, Capsules
from game.render.camera import Camera
from game.scenes.costume import dress, tint
from game.scenes.living_room import living_room, room_cameras
from game.scenes.wardrobe import COSTUMES
from tests.render.biped import dressed_biped


def solids() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Centre (N, 3), reach (N, 3) of a box that holds each solid whatever its turn, and whether it is the shell or a floor covering."""
    centre, reach, flat = [], [], []
    for layer in living_room():
        for item in layer.drawables:
            if isinstance(item, Boxes):
                w, x, y, z = item.orientation.T
                turn = np.abs(
                    np.stack(
                        [
                            np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], -1),
                            np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)], -1),
                            np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], -1),
                        ],
                        -2,
                    )
                )
                centre += list(item.position)
                reach += list((turn @ item.half_size[..., None])[..., 0])
                flat += [item.inside_out or item.material in ("planks", "rug")] * len(item.position)
            elif isinstance(item, Capsules):
                centre += list((item.start + item.end) / 2)
                reach += list(np.abs(item.end - item.start) / 2 + item.radius[:, None])
                flat += [False] * len(item.start)
    return np.array(centre), np.array(reach), np.array(flat)


def test_three_by_three_metres_are_free_to_fall_in() -> None:
    centre, reach, flat = solids()
    near = (np.abs(centre[:, :2]) - reach[:, :2] < 1.5).all(axis=1) & ~flat
    assert not near.any(), centre[near]


def test_nothing_covers_the_soles() -> None:
    centre, reach, flat = solids()
    top = (centre + reach)[:, 2]
    assert top[flat & (reach[:, 2] < 1.0)].max() <= 0.0025


def test_the_kinect_looks_at_the_character_from_in_front() -> None:
    centre, _, _ = solids()
    assert ((centre[:, 0] > 2.4) & (np.abs(centre[:, 1]) < 0.15) & (centre[:, 2] > 1.2) & (centre[:, 2] < 1.45)).sum() >= 8


def test_the_room_is_one_object_for_all_pictures() -> None:
    assert living_room() is living_room()


def test_cameras_stand_where_they_say() -> None:
    for name, hint in room_cameras().items():
        assert np.allclose(Camera(hint).eye, hint.eye, atol=1e-6), name


def test_the_whole_character_is_in_the_first_picture() -> None:
    camera = Camera(next(iter(room_cameras().values())))
    for point in ((0.0, 0.0, 0.0), (0.0, 0.0, 1.85), (0.0, 0.9, 1.4), (0.0, -0.9, 1.4)):
        at = camera.project(np.array(point), (1280, 720))
        assert at is not None
        assert 0 < at[0] < 1280
        assert 0 < at[1] < 720


def test_the_two_fighters_wear_different_colours() -> None:
    parts = ("trunk", "hand_left", "hand_right", "foot_left")
    player, opponent = dress(parts, 0), dress(parts, 1)
    assert (np.abs(player - opponent)[:, :3].sum(axis=1) > 0.1).all()
    assert np.array_equal(player[1], player[2])
    assert len(COSTUMES) == 2


def test_load_goes_from_blue_over_yellow_to_red() -> None:
    idle, half, full = tint(np.array([0.0, 0.5, 1.0]))
    assert idle[2] > idle[0]
    assert half[0] > half[2]
    assert half[1] > half[2]
    assert full[0] > 4 * full[1]


def test_trim_moves_with_its_part() -> None:
    here, there = dressed_biped(at=(0.0, 0.0)), dressed_biped(at=(0.5, -0.2))
    for a, b in zip(here.drawables, there.drawables, strict=True):
        if isinstance(a, Boxes) and isinstance(b, Boxes):
            assert np.allclose(b.position - a.position, (0.5, -0.2, 0.0))
        elif isinstance(a, Capsules) and isinstance(b, Capsules):
            assert np.allclose(b.start - a.start, (0.5, -0.2, 0.0))


def test_trim_stands_on_the_floor_and_not_in_it() -> None:
    for who in ("player", "opponent"):
        for item in dressed_biped(who).drawables:
            if isinstance(item, Boxes):
                assert (item.position[:, 2] - item.half_size[:, 2]).min() > -1e-9
