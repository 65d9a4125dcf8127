"""Conservation laws: what flies falls by g and keeps its momentum, however hard its joints work."""

import mujoco as mj
import numpy as np
import pytest

from game import rotation
from game.physics.world import World
from tests.physics.standing import idle_joints, limp, original, run, thrash, world_of

G = 9.81


def momenta(world: World) -> tuple[np.ndarray, np.ndarray]:
    """Linear (3,) kg m/s, and angular (3,) N m s about the centre of mass."""
    mj.mj_forward(world.model, world.data)
    mj.mj_subtreeVel(world.model, world.data)
    root = world.characters[0].root_body
    return world.data.subtree_linvel[root] * 94.536, world.data.subtree_angmom[root].copy()


@pytest.mark.parametrize("step_s", [1 / 480, 1 / 1000])
def test_free_fall_is_the_closed_form_of_semi_implicit_steps(step_s):
    """v = -g h n and z = z0 - g h^2 n (n + 1) / 2, and nothing turns."""
    world = world_of((0, 0, 5.0), physics__step_s=step_s)
    h, start = world.step_s, world.data.qpos.copy()
    states = run(world, 300, limp)
    n = np.arange(1, 301)
    np.testing.assert_allclose(states[:, 63 + 2], -G * h * n, atol=1e-10)
    np.testing.assert_allclose(states[:, 2], start[2] - G * h * h * n * (n + 1) / 2, atol=1e-10)
    np.testing.assert_allclose(np.delete(states[:, :63], 2, axis=1), np.tile(np.delete(start, 2), (300, 1)), atol=1e-10)


def drift(step_s: float) -> tuple[float, float]:
    """How far 0.4 s of thrashing in flight let linear (against gravity's impulse) and angular momentum drift, and shares of their scale."""
    world = world_of((0, 0, 5.0), physics__step_s=step_s)
    world.data.qvel[:6] = [0.5, -0.2, 1.0, 0.4, 0.3, -0.5]
    world.meter.accept_state()
    linear, angular = momenta(world)
    every = round(1.0 / 120.0 / world.step_s)
    commands = [thrash(world.characters[0], 4 * tick) for tick in range(48)]
    worst_linear = worst_angular = 0.0
    for command in commands:
        world.command(0, command)
        for _ in range(every):
            world.step()
        now_linear, now_angular = momenta(world)
        expected = linear - [0.0, 0.0, 94.536 * G * world.step_count * world.step_s]
        worst_linear = max(worst_linear, float(np.linalg.norm(now_linear - expected)))
        worst_angular = max(worst_angular, float(np.linalg.norm(now_angular - angular)))
        world.meter.accept_state()
    return worst_linear, worst_angular


def test_momentum_is_conserved_in_flight_up_to_an_error_that_vanishes_with_the_step():
    """M and c are taken at the step's start, so each momentum drifts by a share of the step; joint torques do not enter at all."""
    coarse, fine = drift(1 / 480), drift(1 / 3840)
    assert fine[0] < 0.2 * coarse[0] + 1e-9 and fine[1] < 0.2 * coarse[1] + 1e-9
    assert fine[0] < 1.0, "kg m/s, of 94.5 kg thrashing"
    assert fine[1] < 0.5, "N m s"


def test_a_tumbling_body_keeps_its_angular_momentum():
    """All joints held stiff: a rigid body that tumbles about a skew axis."""
    world = world_of((0, 0, 20.0), physics__step_s=1 / 3840)
    world.data.qvel[3:6] = [2.0, 1.0, 3.0]
    world.meter.accept_state()
    before = momenta(world)[1]
    run(world, 3840, limp)
    after = momenta(world)[1]
    np.testing.assert_allclose(after, before, atol=0.01 * float(np.linalg.norm(before)))
    assert np.abs(rotation.log(world.data.qpos[3:7])).max() > 0.3, "it was to tumble"


def test_nothing_moves_without_gravity_and_command():
    world = world_of((0, 0, 1.0))
    world.model.opt.gravity[:] = 0.0
    start = world.data.qpos.copy()
    run(world, 100, limp)
    np.testing.assert_array_equal(world.data.qpos, start)


def test_the_body_plan_is_what_flies():
    world = world_of((0, 0, 1.0))
    body, plan = world.characters[0], original()
    assert float(body.subtree_mass[0]) == pytest.approx(plan.total_mass)
    np.testing.assert_allclose(body.box_centre - [0, 0, 1.0], plan.centre, atol=1e-12)
    np.testing.assert_allclose(body.joint - [0, 0, 1.0], plan.joint, atol=1e-12)
    np.testing.assert_array_equal(body.joint_rotation, idle_joints())
