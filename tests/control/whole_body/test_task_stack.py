"""The rows of the tasks: each is the acceleration of the thing it is named for, against MuJoCo and finite differences."""

import mujoco as mj
import numpy as np
import pytest

from game.characters.skeleton import FEET
from game.control.whole_body.inverse_dynamics import add_task
from game.control.whole_body.leg_kinematics import sole_jacobian
from game.control.whole_body.task_stack import add_com, add_sole, add_spin, diagonal_tasks, wrench_rows
from tests.control.whole_body.thrown_body import sole_point, thrown

STEP_S = 1e-6


def after(world, body, acceleration, look):
    """What `look(world)` sees STEP_S before and after, the velocity changing by `acceleration` (48,); central difference."""
    position, velocity = world.data.qpos.copy(), world.data.qvel.copy()
    seen = []
    for sign in (1.0, -1.0):
        mj.mj_integratePos(world.model, world.data.qpos, velocity, sign * STEP_S)
        world.data.qvel[:] = velocity + sign * STEP_S * acceleration
        mj.mj_forward(world.model, world.data)
        mj.mj_subtreeVel(world.model, world.data)
        world.refresh()
        seen.append(look())
        world.data.qpos[:], world.data.qvel[:] = position, velocity
    mj.mj_forward(world.model, world.data)
    world.refresh()
    return (seen[0] - seen[1]) / (2.0 * STEP_S)


def rows_and_rest(add):
    """Rows (k, 48) and the rest (k,) of the task that `add(hessian, gradient, weight, goal)` adds: value = rows qdd + rest.

    With weight w_i alone the Hessian is w_i rows_i rows_i' and the gradient rows_i (goal_i - rest_i).
    """
    rows, rests = [], []
    for k in range(3):
        hessian, gradient = np.zeros((48, 48)), np.zeros(48)
        add(hessian, gradient, np.eye(3)[k], np.zeros(3))
        with_goal = np.zeros(48)
        add(np.zeros((48, 48)), with_goal, np.eye(3)[k], np.ones(3))
        row = with_goal - gradient
        rows.append(row)
        rests.append(-(gradient @ row) / (row @ row))
        np.testing.assert_allclose(np.tril(np.outer(row, row)), hessian, rtol=1e-8, atol=1e-9)
    return np.array(rows), np.array(rests)


def test_the_com_row_is_the_acceleration_of_the_centre_of_mass():
    world, body = thrown()
    mass, bias = body.equations
    total, gravity = body.subtree_mass[0], body.gravity
    rows, rest = rows_and_rest(lambda h, g, w, goal: add_com(h, g, mass, bias, gravity, total, w, goal))
    for seed in range(2):
        acceleration = np.random.default_rng(seed).normal(scale=20.0, size=48)
        seen = after(world, body, acceleration, lambda: world.characters[0].com_velocity)
        np.testing.assert_allclose(rows @ acceleration + rest, seen, rtol=1e-5, atol=1e-4)


def test_a_body_that_falls_freely_accelerates_by_gravity():
    _, body = thrown()
    mass, bias = body.equations
    falling = np.linalg.solve(mass, -bias)
    rows, rest = rows_and_rest(lambda h, g, w, goal: add_com(h, g, mass, bias, body.gravity, body.subtree_mass[0], w, goal))
    np.testing.assert_allclose(rows @ falling + rest, [0.0, 0.0, -9.81], atol=1e-8)


def test_the_momentum_is_that_of_mujoco():
    world, body = thrown()
    mass, bias = body.equations
    arm = body.com - body.joint[0]
    momentum = add_spin(np.zeros((48, 48)), np.zeros(48), mass, bias, body.velocity, np.zeros(48), body.turn[0], arm, 1.0, 2.0)
    mj.mj_forward(world.model, world.data)
    mj.mj_subtreeVel(world.model, world.data)
    seen = world.data.subtree_angmom[body.root_body]
    assert np.linalg.norm(seen) > 1.0
    np.testing.assert_allclose(momentum, seen, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("share", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("decay", [0.0, 2.0])
def test_the_spin_task_brings_the_momentum_to_the_wanted_one(decay, share):
    """The accelerations that fulfil the task change MuJoCo's angular momentum at -decay times what there is too much of it.

    A body wanted to move as it moves, but at a `share` of its speed, wants that share of its momentum.
    """
    world, body = thrown()
    mass, bias = body.equations
    arm = body.com - body.joint[0]
    hessian, gradient = np.zeros((48, 48)), np.zeros(48)
    momentum = add_spin(hessian, gradient, mass, bias, body.velocity, share * body.velocity, body.turn[0], arm, 1.0, decay)
    full = np.tril(hessian) + np.tril(hessian, -1).T
    acceleration = np.linalg.lstsq(full, gradient, rcond=1e-10)[0]
    seen = after(world, body, acceleration, lambda: world.data.subtree_angmom[body.root_body].copy())
    np.testing.assert_allclose(seen, -decay * (1.0 - share) * momentum, rtol=1e-4, atol=2e-3)


def test_the_diagonal_tasks_ask_each_axis_for_its_own():
    weight, goal = np.linspace(0.1, 1.0, 42), np.linspace(-30.0, 30.0, 42)
    hessian, gradient = diagonal_tasks(weight, goal, 4.0, np.array([1.0, 2.0, 3.0]))
    assert np.all(hessian[~np.eye(48, dtype=bool)] == 0.0)
    assert np.all(np.diag(hessian) > 0.0), "every axis costs something, or the cost would be flat"
    wanted = gradient / np.diag(hessian)
    np.testing.assert_allclose(wanted[:6], [0.0, 0.0, 0.0, 1.0, 2.0, 3.0], rtol=1e-5)
    np.testing.assert_allclose(wanted[6:], goal, rtol=2e-4)


@pytest.mark.parametrize("side", [0, 1])
def test_the_task_of_a_sole_is_the_task_of_its_jacobian(side):
    _, body = thrown()
    sole, rng = sole_point(body, side), np.random.default_rng(0)
    weight, goal = rng.uniform(1.0, 9.0, 6), rng.normal(size=6)
    hessian, gradient = np.zeros((48, 48)), np.zeros(48)
    jacobian = add_sole(hessian, gradient, side, sole, body.joint, body.turn, weight, goal)
    np.testing.assert_array_equal(jacobian, sole_jacobian(side, sole, body.joint, body.turn))
    expected = np.zeros((48, 48)), np.zeros(48)
    add_task(*expected, jacobian, weight, goal)
    np.testing.assert_array_equal(hessian, expected[0])
    np.testing.assert_array_equal(gradient, expected[1])


def test_the_moments_of_a_wrench_turn_about_the_axes_of_the_foot():
    """Power is the same whichever axes it is told in: w'(J qd) with the moment turned back to the world."""
    _, body = thrown()
    foot = body.turn[FEET[0]]
    jacobian = sole_jacobian(0, sole_point(body, 0), body.joint, body.turn)
    wrench, velocity = np.array([30.0, -20.0, 500.0, 5.0, -9.0, 2.0]), body.velocity
    in_world = np.concatenate((wrench[:3], foot @ wrench[3:]))
    assert wrench @ wrench_rows(jacobian, foot) @ velocity == pytest.approx(in_world @ jacobian @ velocity)
    np.testing.assert_array_equal(wrench_rows(jacobian, foot)[:3], jacobian[:3])
