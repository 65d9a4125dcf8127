"""Nothing but the floor, gravity, the other fighter and stated pushes moves a character, and the meter sees whatever else would."""

import mujoco as mj
import numpy as np
import pytest

from game.characters.skeleton import PARTS
from game.physics.hang import hold_root
from game.physics.world import World
from game.tunables import TUNABLES
from tests.physics.standing import bent, hold, limp, run, swing, thrash, unexplained, world_of

FORCE_N, TORQUE_NM = 1e-6, 1e-6
REACH = {"shoulder_left": (0.0, -1.4, 0.0), "shoulder_right": (0.0, -1.4, 0.0)}


def is_honest(world: World) -> bool:
    force, torque = unexplained(world)
    return force < FORCE_N and torque < TORQUE_NM


def shoving(body, step):
    return hold(body, bent(spine=(0.0, 0.2, 0.0), **REACH))


# what is honest


def test_a_character_that_stands_and_swings_its_arms_is_moved_by_floor_and_gravity_alone():
    world = world_of((0, 0, 0))
    run(world, 720)
    assert world.characters[0].com_height() > 0.85, "it was to stand"
    assert is_honest(world), unexplained(world)
    assert world.meter.partners == ["floor - c0"]


@pytest.mark.parametrize("places", [[(0, 0, 0)], [(0, 0, 0), (0.55, 0, 0)]], ids=["alone", "shoving"])
def test_the_step_that_is_played_with_is_as_honest(places):
    step_s = float(TUNABLES["physics.step_s"].default)
    world = world_of(*places, physics__step_s=step_s)
    run(world, round(1.5 / step_s), shoving)
    assert is_honest(world), unexplained(world)
    assert "floor - c0" in world.meter.partners


def test_a_character_that_topples_and_lies_is_honest():
    world = world_of((0, 0, 0))
    run(world, 960, limp)
    assert world.characters[0].com_height() < 0.4, "it was to fall"
    assert is_honest(world), unexplained(world)


def test_a_character_that_thrashes_on_the_floor_is_honest():
    world = world_of((0, 0, 0))
    run(world, 720, thrash)
    assert is_honest(world), unexplained(world)


def test_a_character_that_thrashes_in_the_air_is_honest_and_has_no_partner():
    world = world_of((0, 0, 3.0))
    run(world, 240, thrash)
    assert is_honest(world), unexplained(world)
    assert world.meter.partners == []


@pytest.mark.parametrize("distance", [0.55, 0.35])
def test_two_who_shove_each_other_are_honest_and_each_other_s_partners(distance):
    world = world_of((0, 0, 0), (distance, 0, 0))
    run(world, 720, shoving)
    assert is_honest(world), unexplained(world)
    assert world.meter.partners == ["c0 - c1", "floor - c0", "floor - c1"]


def test_a_body_in_knots_that_may_collide_with_itself_is_honest():
    world = world_of((0, 0, 0), physics__self_collision=True)
    run(world, 360, thrash)
    assert "c0 - c0" in world.meter.partners
    assert is_honest(world), unexplained(world)


@pytest.mark.parametrize("integrator", ["implicitfast", "euler"])
def test_the_other_integrators_are_honest_too(integrator):
    world = world_of((0, 0, 0), physics__integrator=integrator, physics__step_s=0.0005)
    run(world, 480)
    assert is_honest(world), unexplained(world)


def test_what_two_fighters_do_to_each_other_is_equal_and_opposite():
    world = world_of((0, 0, 0), (0.35, 0, 0))
    touched = 0
    for _ in range(480):
        run(world, 1, shoving)
        found = world.meter.contacts
        if found is None:
            continue
        between = (found.character >= 0).all(axis=1)
        on = found.on_characters(2)[:, between]
        touched += int(between.sum())
        np.testing.assert_array_equal(on[0], -on[1])
        assert (np.abs(on[0]) == 1.0).all()
    assert touched > 100


def test_contact_forces_alone_move_the_common_centre_of_mass():
    """From rest, two bodies' momentum gains exactly gravity and the floor's forces: the forces between them cancel."""
    world = world_of((0, 0, -0.001), (0.19, 0, -0.001))
    jacobian = [body.com_jacobian.copy() for body in world.characters]
    mass = [float(body.subtree_mass[0]) for body in world.characters]
    world.command(0, hold(world.characters[0], bent(**REACH)))
    world.step()
    found = world.meter.contacts
    assert found is not None and (found.character >= 0).all(axis=1).any(), "they were to touch"
    gained = sum(m * (j @ body.velocity) for m, j, body in zip(mass, jacobian, world.characters, strict=True)) / world.step_s
    floor = found.force[(found.character < 0).any(axis=1)].sum(axis=0)
    assert floor[2] > 100.0, "the floor was to push"
    np.testing.assert_allclose(gained, floor - [0.0, 0.0, 9.81 * sum(mass)], atol=1e-6)


# what is not: each is caught within one per cent


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("index", [0, 1])
def test_a_newton_on_any_part_is_caught(part, index):
    world = world_of((0, 0, 0), (2.0, 0, 0))
    world.data.xfrc_applied[world.characters[index].root_body + PARTS.index(part), :3] = [0.6, 0.0, 0.8]
    run(world, 3)
    assert world.meter.unexplained_force_n[index] == pytest.approx(1.0, rel=0.01)
    assert world.meter.unexplained_force_n[1 - index] < FORCE_N


@pytest.mark.parametrize("row", range(6))
@pytest.mark.parametrize("index", [0, 1])
def test_a_newton_or_newton_metre_at_a_root_is_caught(row, index):
    world = world_of((0, 0, 0), (2.0, 0, 0))
    world.data.qfrc_applied[world.characters[index].dofs][row] = 1.0
    run(world, 3)
    caught, silent = (world.meter.unexplained_force_n, world.meter.unexplained_torque_nm)[:: 1 if row < 3 else -1]
    assert caught[index] == pytest.approx(1.0, rel=0.01)
    assert caught[1 - index] < FORCE_N and silent[index] < FORCE_N


def test_a_weld_to_the_world_is_caught_at_its_own_force():
    world = world_of((0, 0, 0.5))
    body = world.characters[0]
    hold_root(world.model, world.data, 0, body.joint[0], body.orientation[0])
    largest_force = largest_torque = 0.0
    for _ in range(20):
        run(world, 1)
        weld = np.zeros(world.data.nefc)
        weld[: world.data.ne] = world.data.efc_force[: world.data.ne]
        on_axes = np.zeros(world.model.nv)
        mj.mj_mulJacTVec(world.model, world.data, on_axes, weld)
        largest_force = max(largest_force, float(np.linalg.norm(on_axes[:3])))
        largest_torque = max(largest_torque, float(np.linalg.norm(on_axes[3:6])))
    assert largest_force > 500.0, "it was to bear the body"
    assert unexplained(world) == pytest.approx((largest_force, largest_torque), rel=0.01)


def test_a_part_without_weight_is_caught(monkeypatch):
    compile_model = mj.MjSpec.compile

    def weightless(spec):
        spec.body("c0.trunk").gravcomp = 1.0
        return compile_model(spec)

    monkeypatch.setattr(mj.MjSpec, "compile", weightless)
    world = world_of((0, 0, 0))
    run(world, 20)
    assert unexplained(world)[0] == pytest.approx(9.81 * 23.805, rel=0.01)


def test_a_written_place_is_caught_as_the_force_that_would_have_caused_it():
    world = world_of((0, 0, 2.0), (2.0, 0, 0))
    run(world, 5, limp)
    world.data.qpos[2] += 1e-4
    run(world, 1, limp)
    expected = 94.536 * 1e-4 / world.step_s**2
    assert world.meter.unexplained_force_n[0] == pytest.approx(expected, rel=0.01)
    assert world.meter.unexplained_force_n[1] < FORCE_N


def test_a_written_joint_angle_is_caught_through_the_mass_matrix():
    world = world_of((0, 0, 2.0))
    run(world, 5, limp)
    world.refresh()
    mass_matrix = world.characters[0].mass_matrix
    turn = 1e-3
    hip = 6 + 3 * 8
    jump = np.zeros(48)
    jump[hip + 1] = turn
    before = world.data.qpos.copy()
    mj.mj_integratePos(world.model, world.data.qpos, jump, 1.0)
    assert not np.array_equal(before, world.data.qpos)
    run(world, 1, limp)
    expected = mass_matrix[:6] @ jump / world.step_s**2
    assert world.meter.unexplained_force_n[0] == pytest.approx(np.linalg.norm(expected[:3]), rel=0.01)
    assert world.meter.unexplained_torque_nm[0] == pytest.approx(np.linalg.norm(expected[3:]), rel=0.01)


def test_a_written_speed_is_caught():
    world = world_of((0, 0, 2.0))
    run(world, 5, limp)
    world.data.qvel[0] += 1e-4
    run(world, 1, limp)
    assert unexplained(world)[0] == pytest.approx(94.536 * 1e-4 / world.step_s, rel=0.01)


# what is stated is not


def test_a_stated_push_is_listed_and_leaves_nothing_unexplained():
    world = world_of((0, 0, 0), (2.0, 0, 0))
    run(world, 10)
    world.push(1, PARTS.index("hand_left"), np.array([30.0, -20.0, 10.0]), 24)
    world.push(1, PARTS.index("trunk"), np.array([0.0, 40.0, 0.0]), 12)
    before = world.characters[1].com.copy()
    run(world, 60)
    assert is_honest(world), unexplained(world)
    assert np.linalg.norm(world.characters[1].com - before) > 0.003, "it was to move"
    assert world.stated_pushes == [
        {"step": 10, "character": 1, "part": "hand_left", "force_n": [30.0, -20.0, 10.0], "steps": 24},
        {"step": 10, "character": 1, "part": "trunk", "force_n": [0.0, 40.0, 0.0], "steps": 12},
    ]
    assert not world.data.xfrc_applied.any(), "a push ends"


def test_a_push_gives_the_body_its_impulse_in_flight():
    world = world_of((0, 0, 3.0))
    world.push(0, PARTS.index("trunk"), np.array([100.0, 0.0, 0.0]), 48)
    run(world, 96, limp)
    world.refresh()
    assert world.characters[0].com_velocity[0] == pytest.approx(100.0 * 48 * world.step_s / 94.536, rel=1e-3)


def test_nothing_is_applied_to_a_root():
    world = world_of((0, 0, 0), (0.35, 0, 0))
    for _ in range(120):
        run(world, 1, thrash)
        for body in world.characters:
            root = slice(body.dofs.start, body.dofs.start + 6)
            assert not world.data.qfrc_applied[root].any()
            assert not world.actuation.torque[root].any()
            assert not world.model.dof_damping[root].any()
    assert not world.data.xfrc_applied.any() and not world.data.ctrl.any()


@pytest.mark.parametrize("force", [[np.nan, 0, 0], [1.0, 2.0], [np.inf, 0, 0]])
def test_a_push_that_is_no_force_is_refused_in_words(force):
    world = world_of((0, 0, 0))
    with pytest.raises(ValueError, match="three finite numbers"):
        world.push(0, 0, np.array(force), 5)


def test_swinging_does_not_depend_on_the_meter():
    metered, unmetered = world_of((0, 0, 0)), world_of((0, 0, 0))
    unmetered.meter.active = False
    np.testing.assert_array_equal(run(metered, 120, swing), run(unmetered, 120, swing))
    assert unexplained(unmetered) == (0.0, 0.0)
