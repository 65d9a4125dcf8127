"""Contact forces obey Coulomb (Eq. 3.6): never pulling, never rubbing harder than friction allows."""

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import FEET, PARTS
from game.physics.contacts import contact_forces
from game.physics.dynamics import lowest_corner
from game.physics.model import LIMB_SHARE, SKIN_M
from game.physics.root_balance import cone_excess
from game.physics.world import World
from game.tunables import Settings
from tests.physics.standing import hold, idle_joints, limp, original, run, swing, thrash, world_of

WEIGHT_N = 9.81 * 94.536


@pytest.mark.parametrize("friction", [0.05, 0.4, 1.0])
@pytest.mark.parametrize("motion", [swing, thrash, limp])
def test_every_contact_stays_in_its_friction_cone(friction, motion):
    world = world_of((0, 0, 0), (0.35, 0, 0), physics__friction=friction)
    run(world, 300, motion)
    assert world.meter.partners, "something was to touch"
    assert world.meter.worst_cone_excess_n <= 1e-9


def test_standing_feet_bear_the_weight_and_half_each():
    world = world_of((0, 0, 0))
    run(world, 960, lambda body, _: hold(body))
    found = world.meter.contacts
    assert found is not None
    assert found.force[:, 2].sum() == pytest.approx(WEIGHT_N, abs=0.5)
    left = found.part[:, 1] == PARTS.index("foot_left")
    assert found.force[left, 2].sum() == pytest.approx(WEIGHT_N / 2, rel=0.01)
    assert set(found.part[:, 1].tolist()) == {PARTS.index("foot_left"), PARTS.index("foot_right")}
    np.testing.assert_array_equal(found.character, np.tile([-1, 0], (len(found.force), 1)))


def slide_m(push_n: float, friction: float, seconds: float = 1.0) -> float:
    """How far the left foot slides on slippery floor while the pelvis is pushed."""
    world = world_of((0, 0, 0), physics__friction=friction)
    run(world, 240, lambda body, _: hold(body, kp_hat=2000.0))
    world.refresh()
    foot = PARTS.index("foot_left")
    start = world.characters[0].box_centre[foot, 0]
    steps = round(seconds * 480)
    world.push(0, 0, np.array([push_n, 0.0, 0.0]), steps)
    run(world, steps, lambda body, _: hold(body, kp_hat=2000.0))
    world.refresh()
    assert world.characters[0].com_height() > 0.85, "it was to stay on its feet"
    return float(world.characters[0].box_centre[foot, 0] - start)


def test_a_character_slides_when_it_is_pushed_beyond_friction_and_not_before():
    """Pushed level with 30 and 70 N where friction holds 46 N: the second slides off with the rest of its push."""
    friction = 0.05
    limit = friction * WEIGHT_N
    assert 30.0 < limit < 70.0
    assert abs(slide_m(30.0, friction)) < 0.005
    expected = 0.5 * (70.0 - limit) / 94.536
    assert slide_m(70.0, friction) == pytest.approx(expected, rel=0.2)


def test_the_floor_turns_slippery_while_the_game_runs():
    settings = Settings()
    world = World([original()], settings)
    assert run(world, 10)[-1, 2] == pytest.approx(original().joint[0, 2], abs=0.01), "it was to stand"
    settings.set("physics.friction", 0.1)
    run(world, 10)
    found = world.meter.contacts
    assert found is not None and (found.friction == 0.1).all()


def test_there_are_no_contact_forces_in_the_air():
    world = world_of((0, 0, 1.0))
    run(world, 5, limp)
    assert contact_forces(world.model, world.data) is None and world.meter.contacts is None


def test_a_foot_stands_when_its_lowest_corner_is_below_four_millimetres():
    world = world_of((0, 0, 0.0039), (2, 0, 0.0041))
    assert [body.foot_contact for body in world.characters] == [(True, True), (False, False)]


def test_parts_of_one_body_collide_only_where_asked():
    for wanted in (False, True):
        world = world_of((0, 0, 2.0), physics__self_collision=wanted)
        run(world, 120, thrash)
        assert ("c0 - c0" in world.meter.partners) == wanted


@pytest.mark.parametrize(
    ("wrench", "excess"),
    [([100.0, 30.0, 40.0], 0.0), ([100.0, 30.0, 45.0], 54.08327 - 50.0), ([-2.0, 0.0, 0.0], 2.0)],
    ids=["on the cone", "beyond it", "pulling"],
)
def test_a_force_outside_its_friction_cone_would_be_noticed(wrench, excess):
    rows = np.array([[*wrench, 0.0, 0.0, 0.0]])
    assert cone_excess(rows, np.full((1, 5), 0.5)) == pytest.approx(excess, abs=1e-4)


def test_what_lies_is_borne_by_its_skin_and_feet_are_bare():
    world = world_of((0.0, 0.0, 0.0))
    world.place(0, np.array([0.0, 0.0, 0.2]), rotation.exp(np.array([0.0, -0.5 * np.pi, 0.0])), idle_joints())
    run(world, 480, limp)
    body = world.characters[0]
    world.refresh()
    lowest = [lowest_corner(body.turn[part], body.box_centre[part], body.plan.size[part] / 2.0) for part in range(len(PARTS))]
    assert 0.005 < min(low for part, low in enumerate(lowest) if part not in FEET) < SKIN_M
    assert min(lowest[part] for part in FEET) < 0.002


def test_skin_rubs_as_hard_as_soles_do():
    """A body that slides on its back is stopped by friction within v^2 / (2 mu g), and one on ice slides on."""
    way = {}
    for friction in (0.5, 0.05):
        world = world_of((0.0, 0.0, 0.0), physics__friction=friction)
        world.place(0, np.array([0.0, 0.0, 0.11]), rotation.exp(np.array([0.0, -0.5 * np.pi, 0.0])), idle_joints())
        run(world, 240, limp)
        world.data.qvel[1] = 1.5
        start = world.data.qpos[1]
        run(world, 480, limp)
        way[friction] = world.data.qpos[1] - start
    assert way[0.5] < 1.5**2 / (2.0 * 0.5 * 9.81) * 1.3 and way[0.05] > 2.0 * way[0.5]


def test_limbs_rub_on_each_other_half_as_hard_as_soles_do_also_after_the_friction_was_turned():
    settings = Settings({"physics.friction": 0.8})
    world = World([original()], settings)
    expected = np.array([1.0 if part in FEET else LIMB_SHARE for part in range(len(PARTS))])
    geoms = [int(world.model.geom(f"c0.{part}").id) for part in PARTS]
    for friction in (0.8, 0.3, 0.8):
        settings.set("physics.friction", friction)
        world.step()
        np.testing.assert_allclose(world.model.geom_friction[geoms, 0], friction * expected, rtol=1e-15)
        assert world.model.geom_friction[world.model.geom("floor").id, 0] == pytest.approx(friction, rel=1e-15)
