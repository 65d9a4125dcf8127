"""Virtual actuation against finite differences, and strategies exchanged while a body stands."""

import mujoco as mj
import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import FEET, JOINTS
from game.control.strategies import STRATEGIES
from game.control.virtual_actuation import VirtualActuation, hip_torque_on_pelvis, leg_torque_of_force
from game.physics.guard import command_is_sound
from game.tunables import TUNABLES, Settings
from tests.control.test_ankle_strategy import target_of
from tests.physics.standing import bent, idle_joints, original, run, thrash, world_of

CROUCHED = bent(hip_left=(0, -0.8, 0), knee_left=(0, 1.5, 0), hip_right=(0.1, -0.7, 0.2), knee_right=(0, 1.4, 0), spine=(0, 0.5, 0))
FORCE = np.array([40.0, -25.0, 10.0])


def leg_rows(side: str) -> list[int]:
    return [3 * JOINTS.index(f"{joint}_{side}") + axis for joint in ("hip", "knee") for axis in range(3)]


@pytest.mark.parametrize(("side", "foot", "share"), [("left", FEET[0], (1.0, 0.0)), ("right", FEET[1], (0.0, 1.0))])
def test_leg_torques_are_the_transposed_jacobian_of_the_pelvis_over_a_fixed_foot(side, foot, share):
    """Turning a leg joint while the middle of the foot stays where it is moves the pelvis; torque = that motion, times the force."""
    world = world_of((0, 0, 0), joints=CROUCHED)
    body = world.characters[0]
    torque = leg_torque_of_force(body, np.array(share), FORCE)
    base, eps = world.data.qpos.copy(), 1e-6
    expected = np.zeros(42)
    for row in leg_rows(side):
        ends = []
        for sign in (1.0, -1.0):
            axis = np.zeros(world.model.nv)
            axis[6 + row] = sign
            world.data.qpos[:] = base
            mj.mj_integratePos(world.model, world.data.qpos, axis, eps)
            world.refresh()
            # the pelvis keeps its orientation; everything is shifted back until the foot stands where it stood
            ends.append(-body.box_centre[foot].copy())
        expected[row] = (ends[0] - ends[1]) / (2 * eps) @ FORCE
    np.testing.assert_allclose(torque, expected, atol=1e-6)


def test_a_force_is_shared_by_the_feet():
    body = world_of((0, 0, 0), joints=CROUCHED).characters[0]
    left, right = (leg_torque_of_force(body, np.array(share), FORCE) for share in ((1.0, 0.0), (0.0, 1.0)))
    np.testing.assert_allclose(leg_torque_of_force(body, np.array((0.3, 0.7)), FORCE), 0.3 * left + 0.7 * right)
    assert not left[leg_rows("right")].any() and not right[leg_rows("left")].any()


def test_the_hips_turn_the_pelvis_with_the_torque_that_was_asked_for():
    """The reaction of a joint torque on its parent, summed over both hips, in world axes."""
    body = world_of((0, 0, 0), joints=CROUCHED).characters[0]
    wanted = np.array([12.0, -7.0, 3.0])
    torque = hip_torque_on_pelvis(body, np.array([0.4, 0.6]), wanted).reshape(14, 3)
    hips = [JOINTS.index("hip_left"), JOINTS.index("hip_right")]
    on_pelvis = -sum(body.turn[hip + 1] @ torque[hip] for hip in hips)
    np.testing.assert_allclose(on_pelvis, wanted, atol=1e-12)
    assert not np.delete(torque, hips, axis=0).any()


def test_in_the_air_no_virtual_force_acts():
    world = world_of((0, 0, 1.0))
    body = world.characters[0]
    settings = Settings({"pd.gravity_feedforward": False})
    command = VirtualActuation(settings).command(target_of(bent(spine=(0, 0.4, 0))), body, 1 / 120)
    assert not command.feedforward.any()


def test_a_com_ahead_of_its_place_is_drawn_back_and_never_up():
    world = world_of((0, 0, 0))
    world.place(0, original().joint[0], rotation.exp(np.array([0.0, 0.15, 0.0])), idle_joints())
    settings = Settings()
    strategy = VirtualActuation(settings)
    strategy.command(target_of(idle_joints()), world.characters[0], 1 / 120)
    expected = settings.number("balance.com_stiffness") * (strategy.cos[0] - world.characters[0].com[0]) * original().total_mass
    assert strategy.force[0] == pytest.approx(expected) and strategy.force[0] < 0.0
    assert strategy.force[2] == 0.0
    assert strategy.pelvis_torque[1] == pytest.approx(-0.15 * settings.number("balance.pelvis_stiffness"))


@pytest.mark.parametrize("first", STRATEGIES)
@pytest.mark.parametrize("second", STRATEGIES)
def test_strategies_are_exchanged_without_a_jump_in_the_state(first, second):
    """The state is untouched by the exchange, the next step is honest, and nothing is remembered from before it."""
    settings = Settings()
    world = world_of((0, 0, 0))
    body, target = world.characters[0], target_of(bent(shoulder_left=(0, -0.5, 0)))
    old, new, fresh = STRATEGIES[first](settings), STRATEGIES[second](settings), STRATEGIES[second](settings)
    old.reset(body)
    run(world, 100, lambda b, _: old.command(target, b, 1 / 120))
    world.refresh()
    before = world.data.qpos.copy(), world.data.qvel.copy()
    new.command(target_of(CROUCHED), body, 1 / 120)
    new.reset(body)
    fresh.reset(body)
    ours, theirs = new.command(target, body, 1 / 120), fresh.command(target, body, 1 / 120)
    np.testing.assert_array_equal(before[0], world.data.qpos)
    np.testing.assert_array_equal(before[1], world.data.qvel)
    for field in ("rotation", "velocity", "kp", "kd", "feedforward"):
        np.testing.assert_array_equal(getattr(ours, field), getattr(theirs, field))
    states = run(world, 60, lambda b, _: new.command(target, b, 1 / 120))
    assert np.abs(np.diff(states[:, 63:], axis=0)).max() < 2.0, "speeds were to change smoothly"
    assert world.meter.unexplained_force_n[0] < 1e-6 and world.guard_actions == 0


@pytest.mark.parametrize("name", STRATEGIES)
def test_a_strategy_commands_every_pose_soundly(name):
    world = world_of((0, 0, 1.0))
    strategy = STRATEGIES[name](Settings())
    body = world.characters[0]
    strategy.reset(body)
    for step in range(0, 480, 8):
        run(world, 8, thrash)
        world.refresh()
        command = strategy.command(target_of(thrash(body, step).rotation), body, 1 / 120)
        assert command_is_sound(command)
        assert command.rotation.shape == (14, 4) and command.kp.shape == command.kd.shape == command.feedforward.shape == (42,)


def test_every_strategy_can_be_chosen():
    assert set(TUNABLES["balance.strategy"].choices) == set(STRATEGIES)
