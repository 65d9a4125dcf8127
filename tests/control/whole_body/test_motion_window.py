"""The window of frames as a smooth motion: what is a parabola comes out exactly, with its velocity and its acceleration."""

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import JOINT_COUNT, JOINTS
from game.control.whole_body.motion_window import MotionWindow
from tests.control.whole_body.moving_target import standing_at, target_at
from tests.physics.standing import idle_joints

FRAME_S = 1.0 / 30.0
ROOT, SHOULDER = JOINT_COUNT, JOINTS.index("shoulder_left")
START, VELOCITY, ACCELERATION = standing_at(), np.array([0.4, -0.3, 0.2]), np.array([-1.5, 2.5, 4.0])


def fallen(time_s):
    """Root (3,) of a body on a parabola."""
    return START + time_s * VELOCITY + 0.5 * time_s**2 * ACCELERATION


def parabola(frames, span_s=0.134):
    window = MotionWindow()
    for k in range(frames):
        window.add(target_at(k * FRAME_S, fallen(k * FRAME_S)), span_s)
    return window


def spinning(angle, frames=5, axis=(0.6, 0.0, 0.8)):
    """A window of a body whose root and left shoulder turn about `axis`, by angle(t) rad."""
    window = MotionWindow()
    for k in range(frames):
        turn = rotation.exp(angle(k * FRAME_S) * np.array(axis))
        joints = idle_joints()
        joints[SHOULDER] = turn
        window.add(target_at(k * FRAME_S, START, turn, joints), 1.0)
    return window


@pytest.mark.parametrize("time_s", [0.0, 0.05, 0.1, 4 * FRAME_S])
def test_a_parabola_is_given_back_with_its_velocity_and_acceleration(time_s):
    moment = parabola(5).moment(time_s)
    for place in range(4):
        np.testing.assert_allclose(moment.velocity[place], VELOCITY + time_s * ACCELERATION, atol=1e-9)
        np.testing.assert_allclose(moment.acceleration[place], ACCELERATION, atol=1e-8)
    np.testing.assert_allclose(moment.place[0], fallen(time_s), atol=1e-12)
    shift = moment.place - parabola(5).moment(0.0).place
    np.testing.assert_allclose(shift, np.tile(fallen(time_s) - START, (4, 1)), atol=1e-11)


@pytest.mark.parametrize("late", [0.0, 0.006, 0.012])
def test_frames_at_uneven_times_make_the_same_parabola(late):
    window = MotionWindow()
    for k in range(6):
        time_s = k * FRAME_S + (late if k % 2 else -late)
        window.add(target_at(time_s, fallen(time_s)), 1.0)
    moment = window.moment(0.1)
    np.testing.assert_allclose(moment.place[0], fallen(0.1), atol=1e-12)
    np.testing.assert_allclose(moment.acceleration[0], ACCELERATION, atol=1e-8)


def test_a_constant_spin_comes_out_as_such():
    window = spinning(lambda t: 3.0 * t)
    for time_s in (0.0, 0.04, 4 * FRAME_S):
        moment = window.moment(time_s)
        expected = rotation.exp(3.0 * time_s * np.array([0.6, 0.0, 0.8]))
        for row, turn in ((ROOT, moment.root), (SHOULDER, moment.joint[SHOULDER])):
            assert abs(turn @ expected) == pytest.approx(1.0, abs=1e-12)
            np.testing.assert_allclose(moment.spin[row], [1.8, 0.0, 2.4], atol=1e-9)
            np.testing.assert_allclose(moment.spin_rate[row], 0.0, atol=1e-8)


def test_a_spin_that_grows_evenly_has_that_spin_rate():
    window = spinning(lambda t: 0.3 + 2.0 * t + 0.5 * 8.0 * t * t)
    moment = window.moment(0.1)
    np.testing.assert_allclose(moment.spin[ROOT], (2.0 + 0.8) * np.array([0.6, 0.0, 0.8]), atol=1e-9)
    np.testing.assert_allclose(moment.spin_rate[ROOT], 8.0 * np.array([0.6, 0.0, 0.8]), atol=1e-7)


def test_a_turn_past_half_a_circle_has_no_jump():
    window = spinning(lambda t: np.pi - 0.1 + 3.0 * t, axis=(0.0, 0.0, 1.0))
    np.testing.assert_allclose(window.moment(0.08).spin[ROOT], [0.0, 0.0, 3.0], atol=1e-9)


def test_one_frame_is_a_body_at_rest():
    moment = parabola(1).moment(0.0)
    np.testing.assert_allclose(moment.place[0], START, atol=1e-12)
    assert not moment.velocity.any() and not moment.acceleration.any() and not moment.spin.any() and not moment.spin_rate.any()


def test_two_frames_are_a_straight_line():
    moment = parabola(2).moment(FRAME_S)
    np.testing.assert_allclose(moment.place[0], fallen(FRAME_S), atol=1e-12)
    np.testing.assert_allclose(moment.velocity[0], (fallen(FRAME_S) - START) / FRAME_S, atol=1e-9)
    assert not moment.acceleration.any()


def test_three_frames_are_a_parabola_even_where_the_span_is_shorter():
    moment = parabola(3, span_s=0.0).moment(FRAME_S)
    np.testing.assert_allclose(moment.place[0], fallen(FRAME_S), atol=1e-12)
    np.testing.assert_allclose(moment.acceleration[0], ACCELERATION, atol=1e-7)


def test_frames_older_than_the_span_are_forgotten():
    window = MotionWindow()
    window.add(target_at(-FRAME_S, standing_at(7.0)), 0.134)
    for k in range(5):
        window.add(target_at(k * FRAME_S, fallen(k * FRAME_S)), 0.134)
    np.testing.assert_allclose(window.moment(0.1).place[0], fallen(0.1), atol=1e-12)


def test_time_that_goes_back_or_stands_still_starts_over():
    for back_s in (0.0, 0.05):
        window = parabola(4)
        window.add(target_at(3 * FRAME_S - back_s, standing_at(2.0)), 1.0)
        moment = window.moment(3 * FRAME_S)
        np.testing.assert_allclose(moment.place[0], standing_at(2.0), atol=1e-12)
        assert not moment.velocity.any()


def test_no_moment_lies_before_the_window_nor_far_after_it():
    window = parabola(5)
    np.testing.assert_array_equal(window.moment(-3.0).place, window.moment(0.0).place)
    np.testing.assert_array_equal(window.moment(9.0).place, window.moment(4 * FRAME_S + 0.5 * FRAME_S).place)


def test_the_velocity_of_the_com_is_the_slope_of_a_straight_line():
    window = MotionWindow()
    window.add(target_at(0.0, START), 1.0)
    np.testing.assert_array_equal(window.com_velocity(), np.zeros(3))
    for k in range(1, 5):
        window.add(target_at(k * FRAME_S, START + k * FRAME_S * VELOCITY), 1.0)
    np.testing.assert_allclose(window.com_velocity(), VELOCITY, atol=1e-9)


def test_the_newest_frame_is_the_one_added_last():
    window = parabola(5)
    assert window.newest_s == pytest.approx(4 * FRAME_S)
    np.testing.assert_allclose(window.newest_places[0], fallen(4 * FRAME_S))
    np.testing.assert_allclose(window.newest_places[3], target_at(0.0, fallen(4 * FRAME_S)).com)
