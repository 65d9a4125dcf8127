"""The performer obeys mechanics: forces come from feet on the floor, and there are none in the air."""

import numpy as np
import pytest

from game.inputs.performance.balance import GRAVITY, solve_pelvis_path
from game.inputs.performance.figure import pose_figure
from game.inputs.performance.person import MASS_KG, POINT_MASSES_KG, centre_of_mass, point_masses
from game.inputs.performance.repertoire import motion
from game.inputs.performance.script import SIDES
from game.inputs.performance.tridiagonal import Spline, solve_tridiagonal
from tests.inputs.performer_ground import (
    ALL,
    ANKLES,
    FEET,
    HEEL_TO_BALL,
    STEP_S,
    acceleration,
    bearing,
    contact_points,
    margin_inside,
    performed,
    rate,
    sole,
    tilt,
)

WEIGHT_N = MASS_KG * GRAVITY


def ground_reaction(name):
    """(T - 2,) vertical force, N, and (T - 2, 2) zero moment point, m, from the point masses alone."""
    points = point_masses(performed(name)[1])
    pull = acceleration(points)
    points = points[1:-1]
    weight = POINT_MASSES_KG * (pull[..., 2] + GRAVITY)
    force = weight.sum(axis=1)
    moment = (weight[..., None] * points[..., :2]).sum(axis=1) - ((POINT_MASSES_KG * points[..., 2])[..., None] * pull[..., :2]).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        return force, moment / force[:, None]


@pytest.mark.parametrize("name", ALL)
def test_the_zero_moment_point_stays_under_the_feet(name):
    force, zmp = ground_reaction(name)
    corners = contact_points(name)[1:-1]
    grounded = [k for k in range(len(force)) if len(corners[k]) and force[k] > 0.01 * WEIGHT_N]
    margins = np.array([margin_inside(zmp[k], corners[k]) for k in grounded])
    assert margins.min() > (0.0 if name == "jump" else 0.03), "metres inside the support polygon, in every sample"


@pytest.mark.parametrize("name", ALL)
def test_in_slow_parts_the_centre_of_mass_is_over_the_feet(name):
    _, joints = performed(name)
    com = centre_of_mass(joints)
    corners = contact_points(name)
    slow = (np.linalg.norm(rate(com), axis=1) < 0.02) & (np.linalg.norm(rate(rate(com)), axis=1) < 0.1)
    slow = np.nonzero(slow & [len(each) > 0 for each in corners])[0][::6]
    assert len(slow) > 30
    assert min(margin_inside(com[k, :2], corners[k]) for k in slow) > 0.01


@pytest.mark.parametrize("name", ALL)
def test_the_floor_only_pushes(name):
    force, _ = ground_reaction(name)
    assert force.min() > -0.01 * WEIGHT_N
    assert force.max() < 2.5 * WEIGHT_N


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("side", ["left", "right"])
def test_a_foot_on_the_floor_does_not_move_and_none_goes_through_it(name, side):
    _, joints = performed(name)
    down = bearing(name, side)
    flat = down & (np.abs(tilt(joints, side)) < 1e-9)
    corners = sole(joints, side)
    for joint in (ANKLES[side], FEET[side]):
        assert np.ptp(joints[flat, joint], axis=0).max() < 1e-9
    assert np.abs(corners[flat][..., 2]).max() < 1e-9
    heels, ball = corners[:, :2], corners[:, :2] + HEEL_TO_BALL * (corners[:, 2:] - corners[:, :2])
    assert np.ptp(ball[down], axis=0).max() < 1e-9, "the heel rises about the ball of the foot"
    assert min(heels[..., 2].min(), ball[..., 2].min()) > -1e-9


def flights():
    return motion("jump").script.airborne["left"]


def test_both_feet_leave_and_land_together_in_a_jump():
    script = motion("jump").script
    assert script.airborne["left"] == script.airborne["right"] and len(flights()) >= 3


def test_in_flight_the_centre_of_mass_falls_freely():
    t, joints = performed("jump")
    com = centre_of_mass(joints)
    for leaves, lands in flights():
        aloft = (t > leaves + STEP_S) & (t < lands - STEP_S)
        fall = np.polyfit(t[aloft], com[aloft, 2], 2)
        assert 2.0 * fall[0] == pytest.approx(-GRAVITY, rel=0.02)
        np.testing.assert_allclose(np.polyval(fall, t[aloft]), com[aloft, 2], atol=2e-4)
        assert np.ptp(rate(com)[aloft, :2], axis=0).max() < 0.01


def test_in_flight_the_angular_momentum_is_kept():
    t, joints = performed("jump")
    arm = point_masses(joints) - centre_of_mass(joints)[:, None]
    spin = (np.cross(arm, rate(arm)) * POINT_MASSES_KG[:, None]).sum(axis=1)
    for leaves, lands in flights():
        aloft = (t > leaves + 2 * STEP_S) & (t < lands - 2 * STEP_S)
        assert np.ptp(spin[aloft], axis=0).max() < 0.3, "kg m2/s"
        push_off = (t > leaves - 0.3) & (t < leaves)
        assert np.ptp(spin[push_off], axis=0).max() > 3.0, "on the floor it does change"


def test_the_weight_goes_to_the_other_foot_before_one_lifts():
    for name in ("stepping", "balancing"):
        t, joints = performed(name)
        com = centre_of_mass(joints)[:, 1]
        for side, towards in zip(SIDES, (-1.0, 1.0)):
            for leaves, _ in motion(name).script.airborne[side]:
                assert towards * com[np.searchsorted(t, leaves)] > 0.02, f"{name} at {leaves:.2f} s"


def test_a_wrong_weight_shift_would_be_seen():
    script = motion("balancing").script
    t, joints = performed("balancing")
    lifted = joints.copy()
    lifted[..., 1] *= -1.0
    held_up = (t > 4.0) & (t < 9.0)
    corners = contact_points("balancing")
    wrong = centre_of_mass(lifted)[held_up][:, :2]
    assert not script.on_floor(t, "left")[held_up].any()
    assert max(margin_inside(point, corners[k]) for point, k in zip(wrong, np.nonzero(held_up)[0])) < -0.05


def test_the_path_solver_finds_the_zero_moment_point_it_was_asked_for():
    t = np.arange(0.0, 6.0, 1.0 / 120.0)
    channels = motion("standing").script.sample(t)
    wanted = np.column_stack([0.02 * np.sin(t) ** 3 * (t < np.pi), 0.05 * np.sin(t) ** 3 * (t < np.pi)])
    pelvis = solve_pelvis_path(pose_figure(channels), wanted, None, np.zeros(len(t), bool), 1.0 / 120.0, rounds=7)
    points = point_masses(pose_figure(channels).joints(pelvis))
    pull = (points[2:] - 2.0 * points[1:-1] + points[:-2]) * 120.0**2
    weight = POINT_MASSES_KG * (pull[..., 2] + GRAVITY)
    for axis in (0, 1):
        moment = (weight * points[1:-1, :, axis]).sum(axis=1) - (POINT_MASSES_KG * points[1:-1, :, 2] * pull[..., axis]).sum(axis=1)
        np.testing.assert_allclose(moment / weight.sum(axis=1), wanted[1:-1, axis], atol=1e-4)


def test_tridiagonal_systems_are_solved_exactly():
    random = np.random.default_rng(3)
    for size in (1, 2, 5, 64, 101):
        lower, upper = random.uniform(-1, 1, size), random.uniform(-1, 1, size)
        diagonal = 2.5 + random.uniform(0, 1, size)
        right = random.normal(size=(size, 2))
        matrix = np.diag(diagonal) + np.diag(lower[1:], -1) + np.diag(upper[:-1], 1)
        np.testing.assert_allclose(solve_tridiagonal(lower, diagonal, upper, right), np.linalg.solve(matrix, right), atol=1e-12)


def test_the_spline_goes_through_its_values_and_bends_smoothly():
    values = np.random.default_rng(4).normal(size=(30, 1))
    spline = Spline(values, 0.1)
    np.testing.assert_allclose(spline(np.linspace(0.0, 2.9, 30)), values, atol=1e-12)
    before, after = (np.arange(0.5, 2.5, 0.1, dtype=np.float64) + nudge for nudge in (-2e-5, 2e-5))
    bend = [(spline(at + 1e-5) - 2 * spline(at) + spline(at - 1e-5)) / 1e-10 for at in (before, after)]
    np.testing.assert_allclose(bend[0], bend[1], atol=1.0)
