"""The three inverses of the Jacobian do what their papers say: Eq. 3.2 to 3.5 of Zwennes 2014, Buss & Kim 2005."""

import math
from itertools import pairwise

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import END_EFFECTOR_PARTS
from game.rotation import Floats
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from game.target.inverse_kinematics import (
    SDLS_MAX_ANGLE_RAD,
    SINGULAR,
    SOLVERS,
    clamp_targets,
    damped_least_squares,
    pseudoinverse,
    selectively_damped,
)
from game.target.jacobian import end_effector_jacobian
from tests.target.players import any_pose, idle

PLAN = load_body_plan("original")
STILL = np.zeros(42)
SEEDS = range(5)


def bent(seed: int) -> PosedSkeleton:
    """A pose with bent elbows and knees: all its end-effectors can move any way but the neck, which keeps its distance from the spine."""
    pose = any_pose(PLAN, seed, 0.4)
    rotations = pose.joint_rotation.copy()
    for joint in (3, 6, 9, 12):
        rotations[joint] = rotation.multiply(rotations[joint], rotation.exp(np.array([0.0, 1.2 if joint > 7 else -1.2, 0.0])))
    return pose_skeleton(PLAN, pose.joint[0], pose.root_orientation, rotations)


def reachable_error(jacobian: Floats, seed: int, size_m: float) -> Floats:
    """(15,) an error that some small turn of the joints takes away to first order."""
    error = jacobian @ np.random.default_rng(100 + seed).normal(size=42)
    return error * size_m / np.abs(error).max()


def places(pose: PosedSkeleton) -> Floats:
    return pose.joint[list(END_EFFECTOR_PARTS)]


def stepped(pose: PosedSkeleton, step: Floats) -> PosedSkeleton:
    rotations = rotation.multiply(rotation.exp(step.reshape(14, 3)), pose.joint_rotation)
    return pose_skeleton(PLAN, pose.joint[0], pose.root_orientation, rotations)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_pseudoinverse_is_numpys_on_regular_poses(seed):
    jacobian = end_effector_jacobian(bent(seed))
    phi = np.random.default_rng(seed).normal(size=42)
    error = np.random.default_rng(seed + 1).normal(scale=0.1, size=15)
    inverse = np.linalg.pinv(jacobian, rcond=1e-6)
    expected = inverse @ error + 0.7 * (phi - inverse @ jacobian @ phi)
    np.testing.assert_allclose(pseudoinverse(jacobian, error, phi, 0.9, 0.7), expected, atol=1e-5)


@pytest.mark.parametrize("seed", SEEDS)
def test_damped_least_squares_tends_to_the_pseudoinverse_as_the_damping_goes(seed):
    jacobian = end_effector_jacobian(bent(seed))
    error = reachable_error(jacobian, seed, 0.1)
    exact = pseudoinverse(jacobian, error, STILL, 0.0, 0.0)
    away = [np.abs(damped_least_squares(jacobian, error, STILL, damping, 0.0) - exact).max() for damping in (0.4, 0.04, 0.004, 0.0004)]
    assert away[0] > 1e-3, "at the damping of the thesis the two differ"
    for wide, narrow in pairwise(away[1:]):
        assert narrow < 0.015 * wide, "the difference goes with the square of the damping"
    np.testing.assert_array_equal(damped_least_squares(jacobian, error, STILL, 0.0, 0.0), exact)


@pytest.mark.parametrize("damping", [0.1, 0.4, 1.2])
def test_damped_least_squares_minimises_error_and_step_together(damping):
    jacobian, error = end_effector_jacobian(bent(0)), np.random.default_rng(1).normal(scale=0.1, size=15)
    stacked = np.vstack((jacobian, damping * np.eye(42)))
    expected = np.linalg.lstsq(stacked, np.concatenate((error, STILL)), rcond=None)[0]
    np.testing.assert_allclose(damped_least_squares(jacobian, error, STILL, damping, 1.0), expected, atol=1e-7)


def test_a_stretched_limb_leaves_every_solver_finite():
    jacobian = end_effector_jacobian(idle(PLAN))
    error = np.tile([0.0, 0.0, 0.1], 5)
    for name, solver in SOLVERS.items():
        step = solver(jacobian, error, np.ones(42), 0.0, 1.0)
        assert np.all(np.isfinite(step)) and np.abs(step).max() < 2.0, name


@pytest.mark.parametrize("method", ["pseudoinverse", "dls", "sdls"])
@pytest.mark.parametrize("seed", SEEDS)
def test_without_damping_pose_tracking_moves_no_end_effector_to_first_order(method, seed):
    pose = bent(seed)
    jacobian, phi = end_effector_jacobian(pose), np.random.default_rng(seed).normal(scale=0.5, size=42)
    step = SOLVERS[method](jacobian, np.zeros(15), phi, 0.0, 1.0)
    assert np.abs(step).max() > 0.1
    np.testing.assert_allclose(jacobian @ step, 0.0, atol=1e-7)
    moved = [np.abs(places(stepped(pose, share * step)) - places(pose)).max() for share in (0.02, 0.01)]
    assert moved[1] < 0.3 * moved[0], "what remains is of second order"


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.4, 1.2])
@pytest.mark.parametrize("seed", SEEDS)
def test_with_damping_pose_tracking_moves_the_end_effectors_by_the_identity(damping, seed):
    # J (I - J+ J) phi = m (J J^T + m I)^-1 J phi, with m the squared damping and its regularisation
    jacobian, phi = end_effector_jacobian(bent(seed)), np.random.default_rng(seed).normal(scale=0.5, size=42)
    total = damping**2 + SINGULAR
    moved = jacobian @ damped_least_squares(jacobian, np.zeros(15), phi, damping, 1.0)
    np.testing.assert_allclose(moved, total * np.linalg.solve(jacobian @ jacobian.T + total * np.eye(15), jacobian @ phi), atol=1e-7)
    if damping >= 0.05:
        assert np.abs(moved).max() > 1e-4


def test_the_pose_weight_scales_the_pose_term_and_nothing_else():
    jacobian, phi = end_effector_jacobian(bent(2)), np.random.default_rng(3).normal(size=42)
    error = reachable_error(jacobian, 2, 0.05)
    for solver in SOLVERS.values():
        none, half, full = (solver(jacobian, error, phi, 0.4, weight) for weight in (0.0, 0.5, 1.0))
        np.testing.assert_allclose(half, 0.5 * (none + full), atol=1e-9)
        np.testing.assert_allclose(none, solver(jacobian, error, STILL, 0.4, 1.0), atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_selectively_damped_equals_the_pseudoinverse_for_small_errors_on_regular_poses(seed):
    jacobian = end_effector_jacobian(bent(seed))
    error = reachable_error(jacobian, seed, 1e-4)
    exact = pseudoinverse(jacobian, error, STILL, 0.0, 0.0)
    np.testing.assert_allclose(selectively_damped(jacobian, error, STILL, 0.0, 0.0), exact, atol=1e-7 * np.abs(exact).max() + 1e-9)


@pytest.mark.parametrize("size_m", [0.01, 0.15, 1.0, 100.0])
@pytest.mark.parametrize("pose", [idle(PLAN), bent(0), bent(1), any_pose(PLAN, 3, 1.5)], ids=["stretched", "bent", "bent too", "wild"])
def test_selectively_damped_never_steps_an_axis_by_more_than_45_degrees(pose, size_m):
    jacobian = end_effector_jacobian(pose)
    for seed in range(10):
        error = np.random.default_rng(seed).normal(scale=size_m, size=15)
        step = selectively_damped(jacobian, error, STILL, 0.0, 1.0)
        assert np.abs(step).max() <= SDLS_MAX_ANGLE_RAD + 1e-12 == pytest.approx(math.pi / 4.0)


@pytest.mark.parametrize("method", ["pseudoinverse", "sdls"])
@pytest.mark.parametrize("seed", SEEDS)
def test_reachable_targets_are_reached(method, seed):
    pose, there = bent(seed), places(stepped(bent(seed), np.random.default_rng(seed).normal(scale=0.3, size=42)))
    for _ in range(60):
        error = clamp_targets(there - places(pose), 0.15)
        pose = stepped(pose, SOLVERS[method](end_effector_jacobian(pose), error.reshape(-1), STILL, 0.0, 0.0))
    np.testing.assert_allclose(places(pose), there, atol=1e-4)


def test_the_targets_are_clamped_one_by_one_keeping_their_direction():
    error = np.array([[0.3, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.0], [-0.2, 0.2, -0.1], [0.0, 0.0, 0.15]])
    clamped = clamp_targets(error, 0.15)
    np.testing.assert_allclose(np.linalg.norm(clamped, axis=1), [0.15, 0.1, 0.0, 0.15, 0.15])
    np.testing.assert_allclose(clamped[3] / 0.15, error[3] / 0.3)
    np.testing.assert_array_equal(clamped[[1, 2]], error[[1, 2]])
