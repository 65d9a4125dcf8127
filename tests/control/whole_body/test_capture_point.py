"""The capture point, against the closed form of the linear inverted pendulum."""

import numpy as np
import pytest

from game.control.whole_body.capture_point import capture_point, natural_frequency, predicted, pressure_target
from game.control.whole_body.support_polygon import distance_inside, sole_corners

HULL = sole_corners(np.zeros(2), 0.0, 0.15, 0.14)
OMEGA = natural_frequency(9.81, 1.0)


def pendulum(com, velocity, pressure, time_s):
    """COM and velocity (2,) of a linear inverted pendulum over a fixed pressure, after time_s."""
    c, s = np.cosh(OMEGA * time_s), np.sinh(OMEGA * time_s)
    away = com - pressure
    return pressure + c * away + s * velocity / OMEGA, OMEGA * s * away + c * velocity


def test_the_pendulum_of_a_high_body_is_slower():
    assert natural_frequency(9.81, 0.9) == pytest.approx(np.sqrt(9.81 / 0.9))
    assert natural_frequency(9.81, 1.1) < natural_frequency(9.81, 0.9)


def test_a_body_on_the_floor_has_no_endless_frequency():
    assert natural_frequency(9.81, 0.0) == natural_frequency(9.81, -1.0) == natural_frequency(9.81, 0.2)


def test_a_body_comes_to_rest_over_its_capture_point():
    com, velocity = np.array([0.05, -0.02, 1.0]), np.array([0.3, 0.2, 0.0])
    xi = capture_point(com, velocity, OMEGA)
    place, speed = pendulum(com[:2], velocity[:2], xi, 3.0)
    np.testing.assert_allclose(place, xi, atol=1e-3)
    np.testing.assert_allclose(speed, 0.0, atol=1e-3)


def test_the_vertical_speed_moves_no_capture_point():
    com = np.array([0.0, 0.0, 1.0])
    np.testing.assert_array_equal(capture_point(com, np.array([0.0, 0.0, 2.0]), OMEGA), np.zeros(2))


def test_the_predicted_capture_point_is_that_of_the_pendulum_later_on():
    com, velocity, pressure = np.array([0.05, -0.02]), np.array([0.3, 0.2]), np.array([0.1, 0.05])
    xi = com + velocity / OMEGA
    place, speed = pendulum(com, velocity, pressure, 0.26)
    np.testing.assert_allclose(predicted(xi, pressure, OMEGA, 0.26), place + speed / OMEGA, atol=1e-12)


def test_the_pressure_brings_the_capture_point_home_at_the_rate_asked_for():
    wanted, gain, dt = np.array([0.01, 0.0]), 5.0, 1e-4
    xi = start = np.array([0.06, 0.03])
    for _ in range(2000):
        pressure = pressure_target(xi, wanted, OMEGA, gain, HULL)
        xi = predicted(xi, pressure, OMEGA, dt)
    np.testing.assert_allclose(xi - wanted, (start - wanted) * np.exp(-gain * 0.2), rtol=1e-2)


@pytest.mark.parametrize("x", [0.14, 0.16, 0.4])
def test_no_pressure_is_asked_for_outside_the_hull_wherever_the_capture_point_is(x):
    pressure = pressure_target(np.array([x, 0.0]), np.zeros(2), OMEGA, 20.0, HULL)
    assert distance_inside(HULL, pressure) == pytest.approx(0.0, abs=1e-12)


def test_a_capture_point_where_it_should_be_needs_the_pressure_under_it():
    xi = np.array([0.03, -0.02])
    np.testing.assert_allclose(pressure_target(xi, xi, OMEGA, 5.0, HULL), xi, atol=1e-15)


@pytest.mark.parametrize("yaw_rad", [-0.07, 0.0, 0.3])
def test_a_pressure_at_the_edge_lies_straight_beyond_the_capture_point(yaw_rad):
    """The place of a turned sole nearest to a far-off pressure is its corner: that would turn the body and lift no side of it."""
    hull = sole_corners(np.zeros(2), yaw_rad, 0.15, 0.075)
    xi, wanted = np.array([0.01, 0.04]), np.array([0.02, -0.5])
    pressure = pressure_target(xi, wanted, OMEGA, 10.0, hull)
    away, way = pressure - xi, xi - wanted
    assert distance_inside(hull, pressure) == pytest.approx(0.0, abs=1e-12)
    assert away @ way > 0.0 and away[0] * way[1] == pytest.approx(away[1] * way[0], abs=1e-12)


def test_a_capture_point_just_outside_a_turned_sole_asks_for_no_corner_of_it():
    hull = sole_corners(np.zeros(2), -0.07, 0.15, 0.075)
    pressure = pressure_target(np.array([0.0, 0.09]), np.array([0.0, -5.0]), OMEGA, 10.0, hull)
    assert distance_inside(hull, pressure) == pytest.approx(0.0, abs=1e-12)
    assert np.min(np.linalg.norm(hull - pressure, axis=1)) > 0.1
