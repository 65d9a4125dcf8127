"""What comes down fast is caught before it is in the floor; what stands or lies feels nothing of that."""

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import FEET, PARTS
from game.physics.dynamics import lowest_corner
from game.physics.floor_skin import MOST_M, SLOW_M_S, FloorSkin
from game.physics.model import SKIN_M, skin_name
from tests.physics.standing import hold, idle_joints, limp, run, world_of

LYING = {
    "back": rotation.exp(np.array([0.0, -0.5 * np.pi, 0.0])),
    "front": rotation.exp(np.array([0.0, 0.5 * np.pi, 0.0])),
    "side": rotation.exp(np.array([0.5 * np.pi, 0.2, 0.0])),
}


def thrown_down(turn, speed_m_s):
    """How deep (m) the deepest part gets into the floor, feet left out."""
    world = world_of((0.0, 0.0, 0.0))
    world.place(0, np.array([0.0, 0.0, 0.7]), turn, idle_joints())
    world.data.qvel[2] = -speed_m_s
    body, deep = world.characters[0], np.zeros(len(PARTS))

    def see(body, _):
        world.refresh()
        low = [lowest_corner(body.turn[part], body.box_centre[part], body.plan.size[part] / 2.0) for part in range(len(PARTS))]
        np.maximum(deep, -np.array(low), out=deep)
        return limp(body, _)

    run(world, 120, see)
    assert body.com[2] < 0.4, "it was to fall"
    return np.delete(deep, list(FEET)).max()


@pytest.mark.parametrize("turn", LYING.values(), ids=LYING)
def test_a_body_thrown_to_the_floor_goes_less_than_a_centimetre_into_it(turn, monkeypatch):
    assert thrown_down(turn, 10.0) < 0.01
    monkeypatch.setattr(FloorSkin, "thicken", lambda self: None)
    assert thrown_down(turn, 10.0) > 0.01, "the skin alone is too thin for that"


def margins(world):
    """m, of all parts but the feet, by name"""
    return {part: world.model.pair(skin_name(0, part)).margin[0] for part in PARTS if PARTS.index(part) not in FEET}


def test_the_skin_of_who_stands_is_thin():
    world = world_of((0.0, 0.0, 0.0))
    run(world, 240, lambda body, _: hold(body))
    assert set(margins(world).values()) == {SKIN_M}


def test_the_skin_is_as_much_thicker_as_the_lowest_corner_comes_down_faster_and_no_thicker_than_most():
    thick = {}
    for speed in (0.5 * SLOW_M_S, SLOW_M_S + 1.0, SLOW_M_S + 2.0, 50.0):
        world = world_of((0.0, 0.0, 3.0))
        world.data.qvel[2] = -speed
        run(world, 2, lambda body, _: hold(body))
        thick[speed] = margins(world)["pelvis"] - SKIN_M
    once, twice = thick[SLOW_M_S + 1.0], thick[SLOW_M_S + 2.0]
    assert thick[0.5 * SLOW_M_S] == 0.0 and thick[50.0] == pytest.approx(MOST_M)
    assert twice == pytest.approx(2.0 * once, rel=0.02)


def test_a_corner_that_turns_down_counts_though_its_box_stays_where_it_is():
    world = world_of((0.0, 0.0, 3.0))
    world.data.qvel[3:6] = 25.0, 0.0, 0.0
    run(world, 2, limp)
    assert abs(world.data.qvel[2]) < 0.5
    assert margins(world)["hand_right"] > SKIN_M + 0.01


def test_looking_on_changes_nothing():
    def end(watched):
        world = world_of((0.0, 0.0, 0.6))
        world.data.qvel[4] = 2.0

        def see(body, _):
            if watched:
                world.refresh()
            return limp(body, _)

        run(world, 300, see)
        return world.state_sha256

    assert end(True) == end(False)
