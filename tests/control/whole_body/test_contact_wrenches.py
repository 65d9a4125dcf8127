"""The wrenches of the soles: within friction and inside the sole always, and no better ones exist."""

import math

import numpy as np
import pytest

from game.control.whole_body.contact_wrenches import CONE_ROWS, cone_rows, solve_wrenches

FRICTION, LENGTH, WIDTH, YAW = 0.7, 0.13, 0.04, 0.6
SQUARE = FRICTION / math.sqrt(2.0)
NO_ROWS, NONE = np.zeros((0, 12)), np.zeros(0)


def cone(feet=2, yaw=YAW):
    return cone_rows((yaw, -0.5 * yaw)[:feet], FRICTION, LENGTH, WIDTH)


def of_corners(forces, yaw=YAW):
    """(6,) the wrench of forces (4, 3), in the sole's axes, at its four corners: the force in the world, the moment in the sole's axes."""
    corners = np.array([(sx * LENGTH, sy * WIDTH, 0.0) for sx in (-1, 1) for sy in (-1, 1)])
    c, s = math.cos(yaw), math.sin(yaw)
    (x, y, z), moment = np.sum(forces, axis=0), np.cross(corners, forces).sum(axis=0)
    return np.array([c * x - s * y, s * x + c * y, z, *moment])


def problem(seed, size=12):
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(size, size))
    return root @ root.T + 0.1 * np.eye(size), 100.0 * rng.normal(size=size)


def test_whatever_the_corners_can_push_with_is_allowed():
    """Each corner within its own friction, by the square and by the pyramid alike."""
    rng = np.random.default_rng(0)
    for _ in range(300):
        load = rng.exponential(size=4) * rng.integers(0, 2, 4)
        angle, share = rng.uniform(0.0, math.tau, 4), rng.uniform(0.0, SQUARE, 4)
        forces = np.column_stack((share * load * np.cos(angle), share * load * np.sin(angle), load))
        assert (cone(1) @ of_corners(forces)).max() <= 1e-12


def test_where_the_pressure_is_at_a_corner_nothing_can_twist_the_sole():
    at_corner = of_corners([(0.0, 0.0, 0.0)] * 3 + [(0.0, 0.0, 1.0)])
    assert (cone(1) @ at_corner).max() == pytest.approx(0.0, abs=1e-12)
    for twist in (-0.001, 0.001):
        assert (cone(1) @ (at_corner + [0.0, 0.0, 0.0, 0.0, 0.0, twist])).max() > 0.0


def test_a_sole_that_bears_evenly_can_be_twisted_as_far_as_its_corners_hold():
    """By forces across the length at all four corners and along it, each with the square's friction."""
    even = np.array([0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    most = SQUARE * (LENGTH + WIDTH)
    assert (cone(1) @ (even + [0, 0, 0, 0, 0, most])).max() == pytest.approx(0.0, abs=1e-12)
    assert (cone(1) @ (even - [0, 0, 0, 0, 0, 1.001 * most])).max() > 0.0


@pytest.mark.parametrize("yaw", [0.0, 1.2, -2.5])
def test_a_sole_that_pushes_sideways_with_all_its_friction_at_its_toes_is_twisted_by_forces_along_it_alone(yaw):
    toes = of_corners([(0.0, 0.0, 0.0)] * 2 + [(0.0, 0.5 * SQUARE, 0.5)] * 2, yaw)
    along = np.array([0.0, 0.0, 0.0, 0.0, 0.0, SQUARE * WIDTH])
    assert (cone(1, yaw) @ (toes + along)).max() == pytest.approx(0.0, abs=1e-12)
    assert (cone(1, yaw) @ (toes + 1.001 * along)).max() > 0.0


def test_a_little_more_of_a_force_than_friction_holds_is_too_much():
    rows = cone(1)
    assert rows.shape == (CONE_ROWS, 6)
    for force in ((FRICTION, 0.0), (0.0, -FRICTION)):
        assert (rows[:9] @ [*force, 1.0, 0.0, 0.0, 0.0]).max() <= 1e-12
        assert (rows @ [1.001 * force[0], 1.001 * force[1], 1.0, 0.0, 0.0, 0.0]).max() > 0.0
    assert (rows @ [0.0, 0.0, -1.0, 0.0, 0.0, 0.0]).max() > 0.0


def test_a_moment_about_the_length_of_the_sole_is_bounded_by_its_width():
    rows = cone(1)
    assert (rows @ [0.0, 0.0, 1.0, 0.999 * WIDTH, 0.0, 0.0]).max() <= 0.0 < (rows @ [0.0, 0.0, 1.0, 1.001 * WIDTH, 0.0, 0.0]).max()
    assert (rows @ [0.0, 0.0, 1.0, 0.0, 0.999 * LENGTH, 0.0]).max() <= 0.0 < (rows @ [0.0, 0.0, 1.0, 0.0, 1.001 * LENGTH, 0.0]).max()


@pytest.mark.parametrize("seed", range(8))
def test_no_wrench_within_the_cone_costs_less(seed):
    """The slope is a sum of the rows that hold, so that every way down leads out of the cone."""
    quadratic, linear = problem(seed)
    wrench = solve_wrenches(quadratic, linear, cone(), NO_ROWS, NONE, NONE)
    assert wrench is not None
    assert (cone() @ wrench).max() <= 1e-6
    assert_held_by([row for row in cone() if row @ wrench > -1e-6], quadratic @ wrench + linear)


@pytest.mark.parametrize("seed", range(6))
def test_limited_rows_stay_between_their_limits_at_the_least_cost(seed):
    """The slope is a sum of the rows that hold: from a lower limit upwards, from an upper one downwards."""
    quadratic, linear = problem(seed)
    free = solve_wrenches(quadratic, linear, cone(), NO_ROWS, NONE, NONE)
    assert free is not None
    rows = np.random.default_rng(100 + seed).normal(size=(3, 12))
    middle = rows @ free
    high, low = middle - 0.02 * np.abs(middle), middle - 0.5 * np.abs(middle) - 1.0
    wrench = solve_wrenches(quadratic, linear, cone(), rows, low, high)
    if wrench is None:
        pytest.skip("these rows leave no wrench in the cone")
    assert np.all(rows @ wrench <= high + 1e-6) and np.all(rows @ wrench >= low - 1e-6)
    assert (cone() @ wrench).max() <= 1e-6
    active = [row for row in cone() if row @ wrench > -1e-6]
    active += [row for row, bound in zip(rows, high, strict=True) if row @ wrench > bound - 1e-6]
    active += [-row for row, bound in zip(rows, low, strict=True) if row @ wrench < bound + 1e-6]
    assert_held_by(active, quadratic @ wrench + linear)


def assert_held_by(active, slope):
    push, left = non_negative(np.array(active).T, -slope)
    assert left <= 1e-4 * max(np.abs(slope).max(), 1.0)
    assert push.min() >= 0.0


def non_negative(columns, goal):
    """The non-negative combination of columns nearest to goal, and how far it stays from it (Lawson & Hanson 1974)."""
    count = columns.shape[1]
    x, passive = np.zeros(count), np.zeros(count, bool)
    for _ in range(10 * count):
        pull = columns.T @ (goal - columns @ x)
        if passive.all() or pull[~passive].max() <= 1e-9:
            break
        passive[np.flatnonzero(~passive)[np.argmax(pull[~passive])]] = True
        while True:
            trial = np.zeros(count)
            trial[passive] = np.linalg.lstsq(columns[:, passive], goal, rcond=None)[0]
            if trial[passive].min() > 0.0:
                x = trial
                break
            falling = passive & (trial <= 0.0)
            share = (x[falling] / (x[falling] - trial[falling] + 1e-300)).min()
            x = x + share * (trial - x)
            passive &= x > 1e-12
    return x, float(np.abs(columns @ x - goal).max())


def test_what_nothing_can_meet_is_none():
    quadratic, linear = problem(0)
    lift = np.zeros((1, 12))
    lift[0, 2] = 1.0
    assert solve_wrenches(quadratic, linear, cone(), lift, np.array([-20.0]), np.array([-10.0])) is None


def test_a_wrench_that_is_already_allowed_is_the_free_one():
    quadratic = np.eye(6)
    wanted = np.array([10.0, -20.0, 400.0, 5.0, 10.0, -6.0])
    found = solve_wrenches(quadratic, -wanted, cone(1), np.zeros((0, 6)), NONE, NONE)
    assert found is not None
    np.testing.assert_allclose(found, wanted, atol=1e-7)


def test_a_foot_that_is_pulled_up_lets_go():
    found = solve_wrenches(np.eye(6), np.array([0.0, 0.0, 300.0, 0.0, 0.0, 0.0]), cone(1), np.zeros((0, 6)), NONE, NONE)
    assert found is not None
    np.testing.assert_allclose(found, 0.0, atol=1e-7)


def test_the_problem_is_left_as_it_was():
    quadratic, linear = problem(1)
    rows, low, high = np.ones((1, 12)), np.array([-5.0]), np.array([5.0])
    copies = [array.copy() for array in (quadratic, linear, rows, low, high)]
    solve_wrenches(quadratic, linear, cone(), rows, low, high)
    for array, copy in zip((quadratic, linear, rows, low, high), copies, strict=True):
        np.testing.assert_array_equal(array, copy)
