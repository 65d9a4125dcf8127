"""The eliminated optimisation solves the same problem as the whole one, and its torques are those of MuJoCo's inverse dynamics."""

import mujoco as mj
import numpy as np
import pytest

from game.control.whole_body.inverse_dynamics import (
    add_task,
    cholesky,
    eliminate,
    motion_and_torque,
    solve_lower_both,
    torque_of_wrench,
    wrench_cost,
)
from game.control.whole_body.leg_kinematics import sole_jacobian
from tests.control.whole_body.thrown_body import sole_point, thrown


class Tick:
    """A made-up tick: random tasks on a body thrown about, wrenches of `feet` soles, and the reduced problem of it."""

    def __init__(self, feet, seed=1):
        rng = np.random.default_rng(seed)
        self.world, self.body = thrown()
        self.mass, self.bias = self.body.equations
        self.hessian, self.gradient = 1e-3 * np.eye(48), np.zeros(48)
        self.rows, self.weight, self.wanted = rng.normal(size=(60, 48)), rng.uniform(0.1, 10.0, 60), rng.normal(size=60)
        add_task(self.hessian, self.gradient, self.rows, self.weight, self.wanted)
        soles = [sole_jacobian(side, sole_point(self.body, side), self.body.joint, self.body.turn) for side in range(feet)]
        self.jacobian = np.concatenate(soles) if soles else np.zeros((0, 48))
        self.price = np.full(6 * feet, 1e-4)
        self.lower, self.response, self.schur_inverse, self.free = eliminate(self.hessian, self.mass, self.gradient)
        self.quadratic, self.linear, self.residual = wrench_cost(
            self.free, self.mass, self.bias, self.schur_inverse, self.jacobian, self.price
        )

    def answer(self, wrench):
        return motion_and_torque(wrench, self.free, self.residual, self.response, self.schur_inverse, self.mass, self.bias, self.jacobian)

    def best_wrench(self):
        return np.linalg.solve(self.quadratic, -self.linear)


@pytest.fixture(scope="module")
def tick():
    return Tick(2)


def filled(lower):
    """The symmetric matrix whose lower triangle is given."""
    return np.tril(lower) + np.tril(lower, -1).T


def test_a_task_is_a_weighted_square():
    rng = np.random.default_rng(0)
    hessian, gradient = np.zeros((48, 48)), np.zeros(48)
    rows, weight, wanted = rng.normal(size=(3, 48)), np.array([1.0, 2.0, 0.5]), rng.normal(size=3)
    rows[:, ::3] = 0.0
    add_task(hessian, gradient, rows, weight, wanted)
    np.testing.assert_allclose(filled(hessian), rows.T @ (weight[:, None] * rows), atol=1e-12)
    np.testing.assert_allclose(gradient, rows.T @ (weight * wanted), atol=1e-12)


def test_the_factor_and_its_solution_are_those_of_linear_algebra(tick):
    full = filled(tick.hessian)
    np.testing.assert_allclose(cholesky(tick.hessian), np.linalg.cholesky(full), rtol=1e-9, atol=1e-9)
    right = np.random.default_rng(2).normal(size=(48, 4))
    np.testing.assert_allclose(solve_lower_both(tick.lower, right.T.copy()).T, np.linalg.solve(full, right), rtol=1e-7, atol=1e-10)


@pytest.mark.parametrize("feet", [0, 1, 2])
def test_the_reduced_problem_has_the_solution_of_the_whole_one(feet):
    """min 1/2 qdd'H qdd - g'qdd + 1/2 w'E w subject to M_u qdd + h_u = J_u'w, as one dense system of optimality conditions."""
    tick = Tick(feet)
    count = 6 * feet
    full = np.zeros((48 + count + 6, 48 + count + 6))
    full[:48, :48] = filled(tick.hessian)
    full[48 : 48 + count, 48 : 48 + count] = np.diag(tick.price)
    constraint = np.hstack((tick.mass[:6], -tick.jacobian[:, :6].T))
    full[48 + count :, : 48 + count] = constraint
    full[: 48 + count, 48 + count :] = constraint.T
    solution = np.linalg.solve(full, np.concatenate((tick.gradient, np.zeros(count), -tick.bias[:6])))
    wrench = tick.best_wrench() if feet else np.zeros(0)
    acceleration, _ = tick.answer(wrench)
    np.testing.assert_allclose(wrench, solution[48 : 48 + count], rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(acceleration, solution[:48], rtol=1e-5, atol=1e-6)


def test_any_wrench_keeps_the_unactuated_rows_of_the_equations_of_motion(tick):
    for seed in range(3):
        wrench = np.random.default_rng(seed).normal(scale=300.0, size=12)
        acceleration, _ = tick.answer(wrench)
        root = tick.mass[:6] @ acceleration + tick.bias[:6] - tick.jacobian[:, :6].T @ wrench
        np.testing.assert_allclose(root, 0.0, atol=1e-7)


def test_the_torques_are_those_of_mujocos_inverse_dynamics(tick):
    model, data = tick.world.model, tick.world.data
    wrench = np.random.default_rng(3).normal(scale=200.0, size=12)
    acceleration, torque = tick.answer(wrench)
    model.dof_damping[:] = 0.0
    data.qacc[:] = acceleration
    mj.mj_inverse(model, data)
    needed = data.qfrc_inverse - tick.jacobian.T @ wrench
    np.testing.assert_allclose(needed[:6], 0.0, atol=1e-6)
    np.testing.assert_allclose(torque, needed[6:], atol=1e-6)


def test_a_wrench_costs_what_the_quadratic_form_says(tick):
    def cost(wrench):
        acceleration, _ = tick.answer(wrench)
        tasks = tick.rows @ acceleration - tick.wanted
        effort = 1e-3 * acceleration @ acceleration + tick.price @ (wrench * wrench)
        return 0.5 * (tick.weight @ (tasks * tasks) + effort)

    def form(wrench):
        return 0.5 * wrench @ tick.quadratic @ wrench + tick.linear @ wrench

    one, other = np.random.default_rng(4).normal(scale=50.0, size=(2, 12))
    assert cost(one) - cost(other) == pytest.approx(form(one) - form(other), rel=1e-6)


def test_the_torques_answer_to_the_wrench_as_the_rows_say(tick):
    rows = np.array([0, 3, 7, 20, 41])
    answer = torque_of_wrench(rows, tick.response, tick.schur_inverse, tick.mass, tick.jacobian)
    _, at_rest = tick.answer(np.zeros(12))
    for k in range(12):
        _, torque = tick.answer(np.eye(12)[k])
        np.testing.assert_allclose(answer[:, k], (torque - at_rest)[rows], rtol=1e-6, atol=1e-8)
