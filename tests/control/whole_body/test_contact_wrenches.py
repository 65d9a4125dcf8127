"""The wrenches of the soles: within friction and inside the sole always, and no better ones exist."""

import numpy as np
import pytest

from game.control.whole_body.contact_wrenches import CONE_ROWS, cone_rows, solve_wrenches

FRICTION, LENGTH, WIDTH, TWIST = 0.7, 0.13, 0.04, 0.08
NO_ROWS, NONE = np.zeros((0, 12)), np.zeros(0)


def cone(feet=2):
    return cone_rows(feet, FRICTION, LENGTH, WIDTH, TWIST)


def rays(feet=2):
    """(k, 6 feet) the extreme wrenches of each foot: 1 N of load with the friction and the moments at their corners."""
    pushes = [(FRICTION, 0.0), (-FRICTION, 0.0), (0.0, FRICTION), (0.0, -FRICTION)]
    corners = [(sx * WIDTH, sy * LENGTH, sz * TWIST) for sx in (-1, 1) for sy in (-1, 1) for sz in (-1, 1)]
    one = np.array([[*push, 1.0, *corner] for push in pushes for corner in corners])
    return np.concatenate([np.hstack((np.zeros((len(one), 6 * f)), one, np.zeros((len(one), 6 * (feet - f - 1))))) for f in range(feet)])


def problem(seed, size=12):
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(size, size))
    return root @ root.T + 0.1 * np.eye(size), 100.0 * rng.normal(size=size)


def test_the_rows_allow_exactly_the_wrenches_between_the_extreme_ones():
    rows = cone(1)
    assert rows.shape == (CONE_ROWS, 6)
    assert (rays(1) @ rows.T).max() <= 1e-12
    # and a little more of anything is too much
    for k, much in enumerate((FRICTION, FRICTION, -1.0, WIDTH, LENGTH, TWIST)):
        wrench = np.array([0.0, 0.0, 1.0 if k != 2 else 0.0, 0.0, 0.0, 0.0])
        wrench[k] = 1.001 * much
        assert (rows @ wrench).max() > 0.0


def test_a_moment_about_the_length_of_the_sole_is_bounded_by_its_width():
    rows = cone(1)
    assert (rows @ [0.0, 0.0, 1.0, 0.039, 0.0, 0.0]).max() <= 0.0 < (rows @ [0.0, 0.0, 1.0, 0.05, 0.0, 0.0]).max()
    assert (rows @ [0.0, 0.0, 1.0, 0.0, 0.129, 0.0]).max() <= 0.0 < (rows @ [0.0, 0.0, 1.0, 0.0, 0.14, 0.0]).max()


@pytest.mark.parametrize("seed", range(8))
def test_no_wrench_within_the_cone_costs_less(seed):
    """On a cone w is best where its own direction has no slope and every extreme ray leads uphill."""
    quadratic, linear = problem(seed)
    wrench = solve_wrenches(quadratic, linear, cone(), NO_ROWS, NONE, NONE)
    assert wrench is not None
    slope = quadratic @ wrench + linear
    assert (cone() @ wrench).max() <= 1e-6
    assert (rays() @ slope).min() >= -1e-5
    assert abs(wrench @ slope) <= 1e-4


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
    slope = quadratic @ wrench + linear
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
