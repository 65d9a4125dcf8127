"""What is no command and no state makes its own character limp, is counted and said, and leaves the other fighter bit for bit alone."""

from collections.abc import Callable
from dataclasses import replace

import mujoco as mj
import numpy as np
import pytest

from game.characters.skeleton import PARTS
from game.control.joint_command import JointCommand
from game.physics.actuation import PASSIVE_DAMPING
from game.physics.guard import PLACE_LIMIT_M, SPEED_LIMIT, command_is_sound
from game.physics.world import World
from tests.physics.standing import hold, limp, run, swing, unexplained, world_of

AT = 60
APART = ((0, 0, 0), (3.0, 0, 0))
STEPS = 720


def spoiled(field: str, value: float) -> Callable[[JointCommand], JointCommand]:
    def spoil(command: JointCommand) -> JointCommand:
        array = getattr(command, field).copy()
        array.reshape(-1)[5] = value
        return replace(command, **{field: array})

    return spoil


COMMAND_FAULTS = {
    "target not a number": spoiled("rotation", np.nan),
    "target infinite": spoiled("rotation", np.inf),
    "target not a unit quaternion": lambda c: replace(c, rotation=1.1 * c.rotation),
    "target quaternion zero": lambda c: replace(c, rotation=0.0 * c.rotation),
    "target velocity not a number": spoiled("velocity", np.nan),
    "torque not a number": spoiled("feedforward", np.nan),
    "torque infinite": spoiled("feedforward", -np.inf),
    "torque beyond all bodies": spoiled("feedforward", 1e7),
    "stiffness not a number": spoiled("kp", np.nan),
    "stiffness negative": spoiled("kp", -1.0),
    "damping infinite": spoiled("kd", np.inf),
    "damping negative": spoiled("kd", -1.0),
}


def write(array: str, row: int, value: float) -> Callable[[World], None]:
    def fault(world: World) -> None:
        getattr(world.data, array)[row] = value

    return fault


def explode(world: World) -> None:
    """A sound command whose torque no step survives."""
    command = hold(world.characters[0])
    gain = command.kp.copy()
    gain[0] = 1e300
    turned = command.rotation.copy()
    turned[0] = [0.0, 1.0, 0.0, 0.0]
    world.command(0, replace(command, rotation=turned, kp=gain))


STATE_FAULTS = {
    "place not a number": write("qpos", 1, np.nan),
    "quaternion infinite": write("qpos", 10, np.inf),
    "root out of the world": write("qpos", 0, 1e12),
    "speed not a number": write("qvel", 20, np.nan),
    "speed infinite": write("qvel", 2, -np.inf),
    "speed beyond all bodies": write("qvel", 30, 10 * SPEED_LIMIT),
    "deep under the floor": write("qpos", 2, -0.5 * PLACE_LIMIT_M),
    "explosion": explode,
    "foreign force not a number": write("qfrc_applied", 3, np.nan),
}
MAY_WARN = pytest.mark.warnings_expected


def other_one(states: np.ndarray) -> np.ndarray:
    """Position and velocity of character 1."""
    return np.hstack((states[:, 63:126], states[:, 126 + 48 :]))


@pytest.fixture(scope="module")
def undisturbed() -> np.ndarray:
    return other_one(run(world_of(*APART), STEPS))


@pytest.mark.parametrize("fault", COMMAND_FAULTS)
def test_an_unsound_command_is_told_from_a_sound_one(fault):
    command = hold(world_of((0, 0, 0)).characters[0])
    assert command_is_sound(command)
    assert not command_is_sound(COMMAND_FAULTS[fault](command))


@pytest.mark.parametrize("fault", COMMAND_FAULTS)
def test_a_command_that_is_none_makes_its_character_limp_and_is_said(fault):
    world = world_of((0, 0, 0))
    run(world, AT)
    world.command(0, COMMAND_FAULTS[fault](swing(world.characters[0], AT)))
    states = run(world, 60, limp)
    assert world.guard_actions == 1
    assert world.faults == [f"step {AT}: character 0 goes limp, its joint command is not finite or not a rotation"]
    assert not world.data.qfrc_applied.any() and (world.model.dof_damping[6:] == PASSIVE_DAMPING).all()
    assert np.isfinite(states).all() and unexplained(world)[0] < 1e-6


def test_the_next_sound_command_ends_being_limp():
    world = world_of((0, 0, 0))
    run(world, AT)
    world.command(0, COMMAND_FAULTS["torque not a number"](swing(world.characters[0], AT)))
    run(world, 480)
    assert world.characters[0].com_height() > 0.85
    assert world.data.qfrc_applied.any()


@MAY_WARN
@pytest.mark.parametrize("fault", STATE_FAULTS)
def test_a_state_that_is_none_is_rolled_back_counted_and_said(fault):
    world = world_of((0, 0, 0))
    run(world, AT)
    STATE_FAULTS[fault](world)
    states = run(world, 240, limp)
    assert world.guard_actions >= 1
    assert world.faults[0].startswith(f"step {AT}: character 0 goes limp, ")
    assert np.isfinite(states).all()
    assert np.abs(states[:, 126 - 63 :]).max() < SPEED_LIMIT
    assert np.isfinite(unexplained(world)).all()
    assert np.isfinite(world.peak_torque[6:]).all()


@MAY_WARN
@pytest.mark.parametrize("fault", ["place not a number", "speed infinite", "speed beyond all bodies", "explosion"])
def test_a_mended_character_goes_on_limp_and_honestly_from_its_last_sound_state(fault):
    world, shadow = world_of((0, 0, 0)), world_of((0, 0, 0))
    before = run(world, AT)[-1]
    run(shadow, AT)
    STATE_FAULTS[fault](world)
    after = run(world, 1, limp)[0]
    shadow.actuation.relax(0)
    expected = run(shadow, 1, limp)[0]
    np.testing.assert_array_equal(after, expected)
    assert np.abs(after - before).max() < 0.5
    assert unexplained(world)[0] < 1e-6


@MAY_WARN
def test_a_state_that_is_none_from_the_very_start_is_mended():
    world = world_of((0, 0, 0))
    world.data.qpos[8] = np.nan
    assert np.isfinite(run(world, 10, limp)).all()
    assert world.guard_actions == 1


@MAY_WARN
def test_a_body_deep_under_the_floor_is_kept_still_while_no_step_can_be_taken():
    world = world_of((0, 0, 0))
    world.data.qpos[2] = -0.5 * PLACE_LIMIT_M
    states = run(world, 5, limp)
    assert world.guard_actions >= 5
    np.testing.assert_array_equal(states[1:, :63], states[:-1, :63])
    assert not states[:, 63:].any()


@MAY_WARN
@pytest.mark.parametrize("fault", STATE_FAULTS)
def test_the_other_fighter_does_not_feel_a_failed_state_bit_for_bit(fault, undisturbed):
    world = world_of(*APART)
    first = run(world, AT)
    STATE_FAULTS[fault](world)
    rest = run(world, STEPS - AT, (limp, swing))
    assert world.guard_actions >= 1
    np.testing.assert_array_equal(other_one(np.vstack((first, rest))), undisturbed)


@pytest.mark.parametrize("fault", ["target not a number", "torque infinite", "target not a unit quaternion"])
def test_the_other_fighter_does_not_feel_a_failed_command_bit_for_bit(fault, undisturbed):
    """The faulty one falls down meanwhile, so its contacts and the work of its solver differ from the run without the fault."""

    def failing(body, step):
        command = swing(body, step)
        return command if step < AT else COMMAND_FAULTS[fault](command)

    world = world_of(*APART)
    states = run(world, STEPS, (failing, swing))
    assert world.guard_actions == (STEPS - AT) // 4
    assert world.characters[0].com_height() < 0.5
    np.testing.assert_array_equal(other_one(states), undisturbed)


def test_the_other_fighter_does_not_feel_a_push_either(undisturbed):
    world = world_of(*APART)
    first = run(world, AT)
    world.push(0, PARTS.index("trunk"), np.array([-400.0, 0.0, 0.0]), 40)
    rest = run(world, STEPS - AT)
    assert world.characters[0].com_height() < 0.8, "it was to go down"
    np.testing.assert_array_equal(other_one(np.vstack((first, rest))), undisturbed)


@MAY_WARN
@pytest.mark.parametrize("when", [0, 12], ids=["first step of the push", "first step after it"])
def test_a_repeated_step_feels_its_pushes(when):
    world = world_of((0, 0, 2.0))
    world.push(0, PARTS.index("trunk"), np.array([200.0, 0.0, 0.0]), 12)
    run(world, when, limp)
    explode(world)
    run(world, 20, limp)
    assert world.guard_actions == 1
    assert unexplained(world)[0] < 1e-6
    world.refresh()
    assert world.characters[0].com_velocity[0] == pytest.approx(200.0 * 12 * world.step_s / 94.536, rel=1e-3)


def test_messages_stop_at_a_hundred_and_counting_does_not():
    world = world_of((0, 0, 0))
    broken = COMMAND_FAULTS["stiffness negative"](hold(world.characters[0]))
    for _ in range(150):
        world.command(0, broken)
    assert world.guard_actions == 150 and len(world.faults) == 100


@MAY_WARN
def test_mujoco_never_starts_over_by_itself():
    world = world_of((0, 0, 1.0))
    assert world.model.opt.disableflags & mj.mjtDisableBit.mjDSBL_AUTORESET
    run(world, 50, limp)
    world.data.qfrc_applied[2] = 1e15
    run(world, 10, limp)
    assert world.data.time == pytest.approx(60 * world.step_s)
    assert world.warnings > 0, "the failed step was to be noticed by MuJoCo"
