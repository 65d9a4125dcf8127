"""The kinematics of the soles, against MuJoCo's Jacobians and against finite differences."""

import mujoco as mj
import numpy as np
import pytest

from game.characters.skeleton import FEET
from game.control.whole_body.leg_kinematics import sole_jacobian, sole_motion
from tests.control.whole_body.thrown_body import rate, sole_point, thrown


@pytest.mark.parametrize("side", [0, 1])
def test_the_jacobian_of_a_sole_is_that_of_mujoco(side):
    world, body = thrown()
    sole = sole_point(body, side)
    linear, angular = np.empty((3, 48)), np.empty((3, 48))
    mj.mj_jac(world.model, world.data, linear, angular, sole, body.root_body + FEET[side])
    np.testing.assert_allclose(sole_jacobian(side, sole, body.joint, body.turn), np.vstack((linear, angular)), atol=1e-12)


@pytest.mark.parametrize("side", [0, 1])
def test_each_degree_of_freedom_moves_the_sole_as_the_jacobian_says(side):
    world, body = thrown()
    jacobian = sole_jacobian(side, sole_point(body, side), body.joint, body.turn)
    for row in range(48):
        seen = rate(world, np.eye(48)[row], lambda b: sole_point(b, side))
        np.testing.assert_allclose(jacobian[:3, row], seen, atol=1e-8)


@pytest.mark.parametrize("side", [0, 1])
def test_the_twist_of_a_sole_is_its_jacobian_times_the_velocity(side):
    _, body = thrown()
    sole, velocity = sole_point(body, side), body.velocity
    twist, _ = sole_motion(side, sole, body.joint, body.turn, velocity)
    np.testing.assert_allclose(twist, sole_jacobian(side, sole, body.joint, body.turn) @ velocity, atol=1e-12)


@pytest.mark.parametrize("side", [0, 1])
def test_a_motion_at_constant_speeds_accelerates_the_sole_by_its_velocity_products(side):
    world, body = thrown()
    velocity = body.velocity
    assert np.abs(velocity).max() > 3.0

    def twist(b):
        return sole_jacobian(side, sole_point(b, side), b.joint, b.turn) @ velocity

    _, acceleration = sole_motion(side, sole_point(body, side), body.joint, body.turn, velocity)
    assert np.linalg.norm(acceleration[:3]) > 1.0
    np.testing.assert_allclose(acceleration, rate(world, velocity, twist), rtol=1e-6, atol=1e-5)


def test_a_sole_of_a_body_that_only_travels_has_its_velocity_and_no_acceleration():
    _, body = thrown()
    velocity = np.zeros(48)
    velocity[:3] = 1.0, -2.0, 0.5
    twist, acceleration = sole_motion(0, sole_point(body, 0), body.joint, body.turn, velocity)
    np.testing.assert_allclose(twist, [1.0, -2.0, 0.5, 0.0, 0.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(acceleration, 0.0, atol=1e-12)
