"""Soft joint limits: inside its range a joint is left alone, at the end of it it is stopped, and it never bends the wrong way."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import rotation
from game.characters.joint_limits import HIGH, LOW
from game.characters.skeleton import JOINTS
from game.control.whole_body.joint_limits import EXTRA_WEIGHT, NEAR_HIGH, NEAR_LOW, soft_limits
from tests.physics.standing import bent, idle_joints

KNEE, ELBOW = JOINTS.index("knee_left"), JOINTS.index("elbow_left")
KNEE_ROW, ELBOW_ROW = 3 * KNEE + 1, 3 * ELBOW + 1
DT = 1.0 / 120.0


def softened(joints, velocity=None, goal=None):
    """(weight, goal) after the limits, of joints asked for `goal` with weight 0.5."""
    weight, asked = np.full(42, 0.5), np.zeros(42) if goal is None else goal.copy()
    soft_limits(joints, np.zeros(42) if velocity is None else velocity, weight, asked)
    return weight, asked


def only(row, value):
    out = np.zeros(42)
    out[row] = value
    return out


def knee(angle_rad):
    return bent(knee_left=(0.0, angle_rad, 0.0))


def test_well_inside_their_ranges_joints_are_left_alone():
    joints = bent(knee_left=(0.0, 1.0, 0.0), knee_right=(0.0, 1.0, 0.0), elbow_left=(0.0, -1.0, 0.0), hip_left=(0.1, -0.5, 0.1))
    goal = np.linspace(-200.0, 200.0, 42)
    weight, asked = softened(joints, goal=goal)
    np.testing.assert_array_equal(weight, 0.5)
    np.testing.assert_array_equal(asked, goal)


def test_a_knee_that_is_asked_to_bend_backwards_is_asked_to_stop():
    start = LOW[KNEE, 1]
    weight, asked = softened(knee(start), goal=only(KNEE_ROW, -100.0))
    assert weight[KNEE_ROW] == pytest.approx(0.5 + EXTRA_WEIGHT)
    assert asked[KNEE_ROW] == pytest.approx(-100.0 * 0.5 / (0.5 + EXTRA_WEIGHT), abs=1e-6), "only what the task itself weighs"


def test_a_knee_bent_backwards_is_asked_back_even_where_nobody_else_asks():
    weight, asked = softened(knee(LOW[KNEE, 1] - 0.2))
    assert asked[KNEE_ROW] > 40.0
    assert weight[KNEE_ROW] == pytest.approx(0.5 + EXTRA_WEIGHT)


def test_a_knee_that_shoots_towards_straight_is_braked_before_it_is():
    joints = knee(0.3)
    _, resting = softened(joints)
    weight, shooting = softened(joints, velocity=only(KNEE_ROW, -8.0))
    assert resting[KNEE_ROW] == 0.0 < shooting[KNEE_ROW]
    assert weight[KNEE_ROW] > 0.5


def test_a_joint_that_leaves_the_end_of_its_range_is_not_held_back():
    goal = only(KNEE_ROW, 60.0)
    _, asked = softened(knee(LOW[KNEE, 1]), goal=goal)
    assert asked[KNEE_ROW] == pytest.approx(60.0)


def test_the_weight_grows_evenly_towards_the_end():
    weights = [softened(bent(elbow_left=(0.0, HIGH[ELBOW, 1] - d * NEAR_HIGH[ELBOW, 1], 0.0)))[0][ELBOW_ROW] for d in (1.1, 0.75, 0.5, 0.0)]
    np.testing.assert_allclose(np.array(weights) - 0.5, EXTRA_WEIGHT * np.array([0.0, 0.25, 0.5, 1.0]), atol=1e-9)


def test_a_knee_feels_its_limit_earlier_than_other_joints():
    assert NEAR_LOW[KNEE, 1] == 0.22 and NEAR_LOW[ELBOW, 1] < 0.22


@pytest.mark.parametrize("speed", [0.0, 4.0, 10.0])
@pytest.mark.parametrize("push", [0.0, 40.0, 150.0])
def test_a_joint_that_obeys_stays_within_its_range(speed, push):
    """Driven at the end of its range by a task of little weight, it overshoots by a few degrees at the most."""
    for row, joint, end, sign in ((KNEE_ROW, KNEE, LOW[KNEE, 1], -1.0), (ELBOW_ROW, ELBOW, LOW[ELBOW, 1], -1.0)):
        angle, rate, farthest = end + 0.5, sign * speed, 0.0
        for _ in range(240):
            joints = idle_joints()
            joints[joint] = rotation.exp(np.array([0.0, angle, 0.0]))
            _, asked = softened(joints, only(row, rate), only(row, sign * push))
            rate += DT * asked[row]
            angle += DT * rate
            farthest = max(farthest, sign * (angle - end))
        assert farthest < 0.07
        assert abs(rate) < 0.05 or sign * (angle - end) < 0.0


@given(st.integers(0, 41), st.floats(-3.0, 3.0), st.floats(-20.0, 20.0), st.floats(-300.0, 300.0))
def test_no_goal_is_ever_pushed_further_outward_and_no_weight_taken_away(row, angle, speed, goal):
    joints = idle_joints()
    vector = np.zeros(3)
    vector[row % 3] = angle
    joints[row // 3] = rotation.exp(vector)
    weight, asked = softened(joints, only(row, speed), only(row, goal))
    assert np.all(weight >= 0.5) and np.all(weight <= 0.5 + EXTRA_WEIGHT)
    assert np.isfinite(asked).all()
    low, high = LOW[row // 3, row % 3], HIGH[row // 3, row % 3]
    if angle > high:
        assert asked[row] <= goal + 1e-9
    if angle < low:
        assert asked[row] >= goal - 1e-9
