"""The PD law against closed forms: one joint alone, all joints at once, and the explicit torques of the thesis."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import JOINTS, PARTS
from game.control.joint_command import JointCommand
from game.physics.actuation import PASSIVE_DAMPING
from game.physics.world import World
from tests.physics.standing import bent, hold, idle_joints, limp, original, run, swing, world_of

NECK = JOINTS.index("neck")
TWIST = 3 * NECK + 2
KP, KD, GOAL_RAD = 300.0, 2.0, 0.8


def nearly_fixed_trunk(**settings: Any) -> World:
    """Weightless flight of a body so heavy that only the head can turn: one joint alone."""
    plan = original()
    mass = np.full(15, 1e9)
    mass[PARTS.index("head")] = plan.mass[PARTS.index("head")]
    over_the_neck = plan.centre.copy()
    over_the_neck[PARTS.index("head"), :2] = plan.joint[PARTS.index("head"), :2]
    world = world_of((0, 0, 50.0), plan=replace(plan, mass=mass, centre=over_the_neck), **settings)
    world.model.opt.gravity[:] = 0.0
    return world


def twist_command(goal_speed: float = 0.0, feedforward: float = 0.0) -> JointCommand:
    kp, kd, velocity, torque = np.zeros((4, 42))
    kp[TWIST], kd[TWIST], velocity[TWIST], torque[TWIST] = KP, KD, goal_speed, feedforward
    return JointCommand(bent(neck=(0.0, 0.0, GOAL_RAD)), velocity, kp, kd, torque)


def head_twist(world: World) -> tuple[float, float]:
    """Angle and speed of the head about the neck's axis."""
    joints = world.data.qpos[7:63].reshape(14, 4)
    return float(rotation.log(joints[NECK])[2]), float(world.data.qvel[6 + TWIST])


def head_inertia() -> float:
    """Of the head's box about the neck's axis, through its middle."""
    head = PARTS.index("head")
    x, y, _ = original().size[head]
    return float(original().mass[head] * (x * x + y * y) / 12.0)


@pytest.mark.parametrize("integrator", ["discrete", "implicitfast", "euler"])
@pytest.mark.parametrize("feedforward", [0.0, 0.5])
def test_a_single_joint_takes_its_step_as_stable_pd_says(integrator, feedforward):
    """I (v' - v) / h = kp (goal - angle - h v') + kd (goal speed - v') + torque, angle' = angle + h v'."""
    world = nearly_fixed_trunk(physics__integrator=integrator)
    inertia, h = head_inertia(), world.step_s
    command = twist_command(goal_speed=0.3, feedforward=feedforward)
    angle = speed = 0.0
    for _ in range(200):
        push = KP * (GOAL_RAD - angle) + KD * 0.3 + feedforward
        speed = (inertia * speed + h * push) / (inertia + h * (KD + h * KP))
        angle += h * speed
        run(world, 1, lambda *_: command)
        assert head_twist(world) == pytest.approx((angle, speed), abs=1e-7)
    assert 0.3 < angle < 1.2, "it was to come near its goal"


def test_a_single_joint_takes_its_step_as_explicit_pd_says():
    """I (v' - v) / h = kp (goal - angle) - kd v."""
    world = nearly_fixed_trunk(physics__integrator="explicit")
    inertia, h = head_inertia(), world.step_s
    command = twist_command()
    angle = speed = 0.0
    for _ in range(200):
        speed += h / inertia * (KP * (GOAL_RAD - angle) - KD * speed)
        angle += h * speed
        run(world, 1, lambda *_: command)
        assert head_twist(world) == pytest.approx((angle, speed), abs=1e-7)


def test_a_stiff_joint_that_explicit_pd_would_blow_up_comes_to_rest_at_its_goal():
    world = nearly_fixed_trunk(physics__step_s=1.0 / 120.0)
    stiff = replace(twist_command(), kp=np.full(42, 25000.0), kd=np.full(42, 2.0 * np.sqrt(25000.0)))
    assert world.step_s * stiff.kd[0] / head_inertia() > 100.0, "explicit damping diverges above 2"
    run(world, 240, lambda *_: stiff)
    angle, speed = head_twist(world)
    assert angle == pytest.approx(GOAL_RAD, abs=1e-3) and abs(speed) < 1e-3


@pytest.mark.parametrize("integrator", ["discrete", "implicitfast", "euler"])
def test_in_flight_all_joints_obey_stable_pd_at_once(integrator):
    """Joint rows of M (v' - v) / h + c = kp (e - h v') + kd (target speed - v') + torque, with M and c of the step's start."""
    world = world_of((0, 0, 5.0), physics__integrator=integrator)
    run(world, 50)
    h = world.step_s
    world.refresh()
    body = world.characters[0]
    rng = np.random.default_rng(3)
    command = replace(hold(body), velocity=rng.normal(size=42), feedforward=rng.normal(size=42))
    world.command(0, command)
    joints, speed = body.joint_rotation, body.velocity
    error = rotation.log(rotation.multiply(rotation.conjugate(joints), command.rotation)).reshape(-1)
    world.step()
    after = body.velocity
    expected = command.kp * (error - h * after[6:]) + command.kd * (command.velocity - after[6:]) + command.feedforward
    # the data still holds M and c of the step's start
    if integrator != "implicitfast":  # which solves with the velocity derivative of c besides
        balance = body.mass_matrix @ (after - speed) / h + body.bias
        np.testing.assert_allclose(balance[6:], expected, rtol=1e-9, atol=1e-6)
        np.testing.assert_allclose(balance[:6], 0.0, atol=1e-6)
    np.testing.assert_allclose(world.actuation.torque[6:], expected, rtol=1e-9, atol=1e-9)


def test_explicit_torques_are_the_pd_law_at_the_start_of_the_step():
    world = world_of((0, 0, 5.0), physics__integrator="explicit", physics__step_s=0.0001)
    run(world, 50, swing)
    world.refresh()
    body = world.characters[0]
    command = swing(body, 50)
    joints, speed = body.joint_rotation, body.velocity
    error = rotation.log(rotation.multiply(rotation.conjugate(joints), command.rotation)).reshape(-1)
    world.command(0, command)
    world.step()
    expected = command.kp * error + command.kd * (command.velocity - speed[6:]) + command.feedforward
    np.testing.assert_allclose(world.actuation.torque[6:], expected, rtol=1e-9, atol=1e-9)
    assert not world.model.dof_damping.any()


@pytest.mark.parametrize("step_s", [1 / 480, 1 / 240, 1 / 120])
def test_a_character_stands_under_stable_pd_whatever_the_step(step_s):
    world = world_of((0, 0, 0), physics__step_s=step_s)
    states = run(world, round(2.0 / world.step_s), lambda body, _: hold(body))
    assert world.characters[0].com_height() > 0.9
    assert np.abs(states[-20:, 63:]).max() < 0.05, "it was to stand still"


def test_a_limp_character_has_light_damping_and_nothing_else():
    world = world_of((0, 0, 2.0))
    run(world, 30, swing)
    world.actuation.relax(0)
    run(world, 1, limp)
    np.testing.assert_allclose(world.actuation.torque[6:], -PASSIVE_DAMPING * world.data.qvel[6:])


def test_peak_torques_are_the_largest_of_all_steps():
    world = world_of((0, 0, 0))
    largest = np.zeros(48)
    for _ in range(60):
        run(world, 1)
        largest = np.maximum(largest, np.abs(world.actuation.torque))
    np.testing.assert_array_equal(world.peak_torque, largest)
    assert (largest[6:] > 0.0).any() and not largest[:6].any()


def test_each_character_follows_its_own_command():
    world = world_of((0, 0, 2.0), (3.0, 0, 2.0))
    raised = bent(shoulder_left=(0.0, -1.0, 0.0))

    def hold_in_flight(joints):
        return lambda body, _: replace(hold(body, joints), feedforward=np.zeros(42))

    run(world, 240, (hold_in_flight(raised), hold_in_flight(idle_joints())))
    shoulder = JOINTS.index("shoulder_left")
    angles = [float(np.linalg.norm(rotation.log(body.joint_rotation[shoulder]))) for body in world.characters]
    assert angles[0] == pytest.approx(1.0, abs=0.1) and angles[1] < 0.1
