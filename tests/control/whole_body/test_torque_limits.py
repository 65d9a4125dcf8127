"""Torques within what the joints have: always, without breaking the equations of motion where standing legs are what is short."""

import numpy as np
import pytest

from game.characters.skeleton import FEET
from game.control.whole_body.contact_wrenches import cone_rows
from game.control.whole_body.foot_tasks import STANCE_WEIGHT
from game.control.whole_body.inverse_dynamics import eliminate
from game.control.whole_body.task_stack import add_com, add_sole, diagonal_tasks, wrench_rows
from game.control.whole_body.torque_limits import FAST_RAD_S, SLOW_RAD_S, Problem, limits_at, within_limits
from tests.control.whole_body.thrown_body import sole_point
from tests.physics.standing import bent, world_of

WEIGHT = np.full(42, 0.6)

CROUCH = bent(
    hip_left=(0.0, -0.6, 0.0), knee_left=(0.0, 1.2, 0.0), ankle_left=(0.0, -0.6, 0.0),
    hip_right=(0.0, -0.6, 0.0), knee_right=(0.0, 1.2, 0.0), ankle_right=(0.0, -0.6, 0.0),
)  # fmt: skip


@pytest.fixture(scope="module")
def crouching():
    """A body that crouches with both soles on the floor, in slight motion."""
    world = world_of((0.0, 0.0, -0.16), joints=CROUCH)
    body = world.characters[0]
    lowest = min(sole_point(body, side)[2] for side in range(2))
    world.data.qpos[2] -= lowest
    world.data.qvel[:] = np.random.default_rng(0).normal(scale=0.1, size=48)
    world.refresh()
    return body


def problem(body, joint_goal, lift=0.0):
    """Both feet stand; joints are asked for `joint_goal` (42,) rad/s^2, the COM to rise at `lift` m/s^2."""
    mass, bias = body.equations
    hessian, gradient = diagonal_tasks(WEIGHT, joint_goal, 4.0, np.zeros(3))
    rows = []
    for side in range(2):
        foot = np.full(6, STANCE_WEIGHT)
        jacobian = add_sole(hessian, gradient, side, sole_point(body, side), body.joint, body.turn, foot, np.zeros(6))
        rows.append(wrench_rows(jacobian, body.turn[FEET[side]]))
    goal = np.array([0.0, 0.0, lift])
    add_com(hessian, gradient, mass, bias, body.gravity, body.subtree_mass[0], np.array([2000.0, 2000.0, 500.0]), goal)
    lower, response, schur_inverse, free = eliminate(hessian, mass, gradient)
    cone = cone_rows((0.0, 0.0), 0.7, 0.13, 0.04)
    price = np.tile([1e-6, 1e-6, 1e-6, 21e-6, 6e-6, 21e-6], 2)
    return Problem(gradient, lower, response, schur_inverse, free, mass, bias, np.concatenate(rows), price, cone, (0, 1))


def solve(body, joint_goal, strength, lift=0.0):
    low, high = -strength, strength
    made = problem(body, joint_goal, lift)
    torque, acceleration, wrench = within_limits(made, low, high, WEIGHT, made.mass.diagonal()[6:])
    consistent = made.mass[6:] @ acceleration + made.bias[6:] - made.jacobian[:, 6:].T @ wrench
    return torque, acceleration, wrench, consistent


@pytest.mark.parametrize("limit", [5.0, 40.0, 150.0])
@pytest.mark.parametrize("seed", range(4))
def test_no_torque_ever_leaves_its_limits(crouching, seed, limit):
    goal = np.random.default_rng(seed).normal(scale=80.0, size=42)
    torque, acceleration, wrench, _ = solve(crouching, goal, np.full(42, limit))
    assert np.all(np.abs(torque) <= limit)
    assert np.isfinite(acceleration).all() and np.isfinite(wrench).all()


def test_a_strong_body_does_what_it_is_asked_by_torques_that_agree_with_its_motion(crouching):
    torque, _, wrench, consistent = solve(crouching, np.zeros(42), np.full(42, 1e4), lift=1.0)
    np.testing.assert_allclose(torque, consistent, atol=1e-6)
    assert wrench[2] + wrench[8] == pytest.approx(crouching.subtree_mass[0] * (9.81 + 1.0), rel=0.05)


def test_where_a_standing_knee_is_short_the_other_joints_make_up_and_motion_and_torque_agree(crouching):
    free, *_ = solve(crouching, np.zeros(42), np.full(42, 1e4), lift=2.0)
    strength = np.full(42, 1e4)
    knee = 3 * 9 + 1
    assert abs(free[knee]) > 50.0
    strength[knee] = 0.9 * abs(free[knee])
    torque, _, _, consistent = solve(crouching, np.zeros(42), strength, lift=2.0)
    assert abs(torque[knee]) == pytest.approx(strength[knee], rel=1e-6)
    np.testing.assert_allclose(torque, consistent, atol=1e-4)


def test_an_arm_that_is_short_is_swung_more_slowly_instead_of_being_cut_off(crouching):
    goal = np.zeros(42)
    shoulder = 3 * 2 + 1
    goal[shoulder] = 60.0
    free, fast, *_ = solve(crouching, goal, np.full(42, 1e4))
    strength = np.full(42, 1e4)
    strength[shoulder] = 0.7 * abs(free[shoulder])
    torque, slower, _, consistent = solve(crouching, goal, strength)
    assert abs(torque[shoulder]) <= strength[shoulder]
    assert 0.0 < slower[6 + shoulder] < fast[6 + shoulder]
    cut_off = abs(consistent[shoulder]) - strength[shoulder]
    assert cut_off < 0.02 * strength[shoulder], "asking for less left almost nothing to cut"


def test_a_muscle_that_shortens_fast_loses_its_force_and_one_being_stretched_keeps_it():
    strength = np.array([100.0, 50.0, 20.0])
    between = 0.5 * (SLOW_RAD_S + FAST_RAD_S)
    low, high = limits_at(-strength, strength, np.array([between, -FAST_RAD_S, FAST_RAD_S + 5.0]))
    np.testing.assert_allclose(high, [50.0, 50.0, 0.0])
    np.testing.assert_allclose(low, [-100.0, 0.0, -20.0])


def test_each_way_a_joint_has_the_strength_of_the_muscle_on_that_side():
    low, high = limits_at(np.array([-200.0]), np.array([90.0]), np.array([0.5 * (SLOW_RAD_S + FAST_RAD_S)]))
    assert low[0] == -200.0 and high[0] == pytest.approx(45.0)


def test_a_slow_joint_has_all_its_strength_both_ways():
    strength = np.full(3, 80.0)
    for speed in (-SLOW_RAD_S, 0.0, SLOW_RAD_S):
        low, high = limits_at(-strength, strength, np.full(3, speed))
        np.testing.assert_array_equal(high, strength)
        np.testing.assert_array_equal(low, -strength)


def test_a_faster_joint_never_has_more_to_go_faster_with():
    speeds = np.linspace(-40.0, 40.0, 81)
    low, high = limits_at(-np.ones(81), np.ones(81), speeds)
    assert np.all(np.diff(high) <= 0.0) and np.all(np.diff(low) <= 0.0)
    assert np.all(low <= 0.0) and np.all(high >= 0.0)
