"""The thesis's balance strategy: where the COM shall go, which foot bears, how far an ankle may be asked to turn."""

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import ANKLES, FEET, PARTS
from game.control.ankle_strategy import AnkleStrategy, com_target, left_share
from game.control.joint_command import JointCommand
from game.control.strategies import STRATEGIES
from game.physics.dynamics import BodyDynamics
from game.target.forward_kinematics import pose_skeleton
from game.target.kinematic_target import KinematicTarget, MappedInput
from game.tunables import Settings
from tests.physics.standing import bent, idle_joints, original, run, world_of

UP = np.array([0.0, 0.0, 0.9])
STILL = np.zeros(3)
LEFT, RIGHT = np.array([0.0, 0.1, 0.0]), np.array([0.0, -0.1, 0.0])


def target_of(joints: np.ndarray, root_orientation: np.ndarray = rotation.IDENTITY, velocity: np.ndarray | None = None) -> KinematicTarget:
    """A kinematic target of the original character at its idle place."""
    plan = original()
    root = plan.joint[0]
    pose = pose_skeleton(plan, root, root_orientation, joints)
    mapped = MappedInput(root, root_orientation, joints, np.zeros((5, 3)))
    speed = np.zeros(42) if velocity is None else velocity
    return KinematicTarget(0.0, root, root_orientation, joints, speed, pose, pose.centre_of_mass(plan), mapped)


def ankle_errors(body: BodyDynamics, command: JointCommand) -> list[float]:
    """How far, rad, each ankle is asked to turn from where it is."""
    ankles = list(ANKLES)
    asked = rotation.multiply(rotation.conjugate(body.joint_rotation[ankles]), command.rotation[ankles])
    return np.linalg.norm(rotation.log(asked), axis=1).tolist()


# Eq. 3.9 to 3.11


def test_at_rest_the_com_shall_stand_over_the_centre_of_support():
    np.testing.assert_allclose(com_target(np.array([0.1, -0.05, 0.9]), STILL, np.array([0.3, 0.2, 0.8]), 0.0, 0.4), UP)


def test_with_full_weight_it_shall_stand_where_the_target_s_does():
    offset = np.array([0.05, 0.02, 0.85])
    np.testing.assert_allclose(com_target(np.array([0.1, 0.0, 0.9]), STILL, offset, 1.0, 0.4), offset)


def test_between_it_is_the_weighted_mean():
    """Eq. 3.9."""
    offset = np.array([0.06, 0.02, 0.8])
    np.testing.assert_allclose(com_target(np.array([0.1, 0.0, 0.9]), STILL, offset, 0.25, 0.4), 0.25 * offset + 0.75 * UP)


def test_a_com_that_runs_ahead_is_to_be_led_back_by_a_share_of_its_speed():
    """Eq. 3.10 and 3.11 with the sign that keeps a body up: the part of the velocity across the way to the target counts."""
    goal = com_target(np.array([0.0, 0.0, 0.9]), np.array([0.3, -0.1, 0.7]), UP, 0.0, 0.4)
    np.testing.assert_allclose(goal, UP - 0.4 * np.array([0.3, -0.1, 0.0]))


def test_the_speed_that_counts_is_never_longer_than_the_way():
    goal = com_target(np.array([0.0, 0.0, 0.9]), np.array([30.0, 40.0, 0.0]), UP, 0.0, 0.5)
    np.testing.assert_allclose(goal, UP - 0.5 * 0.9 * np.array([0.6, 0.8, 0.0]))


def test_a_com_at_the_centre_of_support_gives_no_nonsense():
    assert np.isfinite(com_target(STILL, np.array([1.0, 0.0, 0.0]), STILL, 0.5, 0.4)).all()


# which foot bears


@pytest.mark.parametrize(("across", "share"), [(0.1, 1.0), (0.05, 0.75), (0.0, 0.5), (-0.05, 0.25), (-0.1, 0.0), (0.4, 1.0), (-0.4, 0.0)])
def test_the_left_foot_bears_by_where_the_target_s_com_lies_between_the_feet(across, share):
    assert left_share(np.array([0.3, across, 0.9]), LEFT, RIGHT, (True, True)) == pytest.approx(share)
    assert left_share(np.array([0.3, across, 0.9]), LEFT, RIGHT, (False, False)) == pytest.approx(share)


@pytest.mark.parametrize(("contact", "share"), [((True, False), 1.0), ((False, True), 0.0)])
def test_the_only_foot_on_the_floor_bears_everything(contact, share):
    for across in (-0.1, 0.0, 0.1):
        assert left_share(np.array([0.0, across, 0.9]), LEFT, RIGHT, contact) == share


def test_feet_on_one_spot_are_no_division_by_zero():
    assert 0.0 <= left_share(np.array([0.1, 0.0, 0.9]), LEFT, LEFT, (True, True)) <= 1.0


# the command


@pytest.mark.parametrize("clamp", [0.02, 0.034, 0.1])
def test_an_ankle_is_never_asked_for_more_than_its_clamp(clamp):
    world = world_of((0, 0, 0), joints=bent(hip_left=(0.0, -0.4, 0.0), hip_right=(0.0, -0.4, 0.0)))
    body = world.characters[0]
    strategy = AnkleStrategy(Settings({"balance.ankle_clamp_rad": clamp}))
    strategy.reset(body)
    command = strategy.command(target_of(idle_joints()), body, 1 / 120)
    assert max(ankle_errors(body, command)) == pytest.approx(clamp, rel=1e-6)


def test_within_its_clamp_a_lifted_foot_is_held_level_and_ahead():
    world = world_of((0, 0, 0.2), joints=bent(hip_left=(0.0, -0.1, 0.05), ankle_right=(0.02, 0.03, 0.0)))
    body = world.characters[0]
    command = AnkleStrategy(Settings({"balance.ankle_clamp_rad": 0.5})).command(target_of(idle_joints()), body, 1 / 120)
    assert body.foot_contact == (False, False)
    for ankle, foot in zip(ANKLES, FEET, strict=True):
        wanted_foot = rotation.multiply(body.orientation[foot - 1], command.rotation[ankle])
        heading = rotation.about_z(rotation.yaw(body.orientation[foot - 1]))
        assert np.linalg.norm(rotation.log(rotation.multiply(rotation.conjugate(heading), wanted_foot))) < 1e-9


def test_a_body_that_leans_ahead_presses_its_toes_down():
    """The ankle turns against the lean: its pitch target is a toe-down one, whose torque pushes the COM back."""
    lean = rotation.exp(np.array([0.0, 0.06, 0.0]))
    world = world_of((0, 0, 0))
    world.place(0, original().joint[0], lean, idle_joints())
    body = world.characters[0]
    strategy = AnkleStrategy(Settings({"balance.ankle_clamp_rad": 0.5}))
    strategy.command(target_of(idle_joints()), body, 1 / 120)
    assert body.com[0] - strategy.cos[0] > -0.04, "it was to lean"
    upright_world = world_of((0, 0, 0))
    level = AnkleStrategy(Settings({"balance.ankle_clamp_rad": 0.5}))
    shift = []
    for each_world, each in ((world, strategy), (upright_world, level)):
        command = each.command(target_of(idle_joints()), each_world.characters[0], 1 / 120)
        shin = each_world.characters[0].orientation[FEET[0] - 1]
        foot_wanted = rotation.log(rotation.multiply(shin, command.rotation[ANKLES[0]]))
        shift.append(foot_wanted[1])
    assert shift[0] > shift[1] + 0.02


def test_ankles_have_no_target_speed_and_all_else_is_the_target_s():
    velocity = np.linspace(-1.0, 1.0, 42)
    joints = bent(shoulder_left=(0.1, -0.8, 0.2), knee_left=(0.0, 0.2, 0.0), spine=(0.0, 0.1, 0.0))
    body = world_of((0, 0, 0)).characters[0]
    target = target_of(joints, velocity=velocity)
    command = AnkleStrategy(Settings()).command(target, body, 1 / 120)
    others = [j for j in range(14) if j not in ANKLES]
    np.testing.assert_array_equal(command.rotation[others], joints[others])
    np.testing.assert_array_equal(command.velocity.reshape(14, 3)[others], velocity.reshape(14, 3)[others])
    assert not command.velocity.reshape(14, 3)[list(ANKLES)].any()
    np.testing.assert_array_equal(target.joint_rotation, joints)
    np.testing.assert_array_equal(target.joint_velocity, velocity)


def test_which_way_the_target_faces_does_not_matter():
    body = world_of((0, 0, 0)).characters[0]
    settings = Settings({"balance.w_com": 0.5})
    joints = bent(spine=(0.2, 0.3, 0.0))
    ahead = AnkleStrategy(settings).command(target_of(joints), body, 1 / 120)
    aside = AnkleStrategy(settings).command(target_of(joints, rotation.about_z(1.1)), body, 1 / 120)
    np.testing.assert_allclose(ahead.rotation, aside.rotation, atol=1e-9)


def test_gravity_is_taken_off_only_where_the_switch_says_so():
    body = world_of((0, 0, 0)).characters[0]
    for wanted in (True, False):
        command = AnkleStrategy(Settings({"pd.gravity_feedforward": wanted})).command(target_of(bent(spine=(0, 0.3, 0))), body, 1 / 120)
        assert command.feedforward.any() == wanted


def test_a_shoved_body_stays_up_by_its_strategy_and_falls_without_one():
    """90 N backwards at the trunk for 0.3 s, towards the heels."""

    def com_height_after(name: str) -> float:
        world = world_of((0, 0, 0))
        balance = STRATEGIES[name](Settings())
        balance.reset(world.characters[0])
        target = target_of(idle_joints())

        def commander(body: BodyDynamics, _step: int) -> JointCommand:
            return balance.command(target, body, 1 / 120)

        run(world, 240, commander)
        world.push(0, PARTS.index("trunk"), np.array([-90.0, 0.0, 0.0]), 144)
        run(world, 960, commander)
        return world.characters[0].com_height()

    assert com_height_after("ankle") > 0.88
    assert com_height_after("virtual-actuation") > 0.88
    assert com_height_after("none") < 0.75, "it was to fall"
