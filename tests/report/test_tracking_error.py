"""Errors are nothing for perfect tracking, feel neither place nor heading, and name the joint that is off (thesis 4.2 and 4.3)."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import JOINTS
from game.report.tracking_error import TrackingError
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from tests.report.observed import body_in, elsewhere, target_of
from tests.target.players import any_pose

PLAN = load_body_plan("original")
ERRORS = ("joint_error_parent_rad", "joint_error_world_rad", "end_effector_error_m")
POSE = any_pose(PLAN, 1, 0.4)


def measured(own: PosedSkeleton, wanted: PosedSkeleton, mapped: PosedSkeleton | None = None) -> dict[str, float | str | None]:
    error = TrackingError()
    error.sample(body_in(own), own.joint_rotation, target_of(PLAN, wanted, mapped))
    return error.summary()


def bent_at(joint: str, angle: float) -> PosedSkeleton:
    """POSE with one joint turned further about its own x axis."""
    rotations = POSE.joint_rotation.copy()
    i = JOINTS.index(joint)
    rotations[i] = rotation.multiply(rotations[i], rotation.exp(np.array([angle, 0.0, 0.0])))
    return pose_skeleton(PLAN, POSE.joint[0], POSE.root_orientation, rotations)


@pytest.mark.parametrize("seed", range(4))
def test_perfect_tracking_has_no_error_wherever_it_happens(seed):
    pose = any_pose(PLAN, seed)
    out = measured(elsewhere(PLAN, pose, 2.0 * seed - 3.0, (1.0, -2.0, 0.3)), pose)
    for suffix in ("", "_vs_mapped"):
        for error in ERRORS:
            assert out[error + suffix] == pytest.approx(0.0, abs=1e-7)


@pytest.mark.parametrize("heading", [-2.5, 0.4, 3.1])
def test_place_and_heading_change_no_error(heading):
    here, there = (
        measured(bent_at("elbow_left", 0.5), POSE),
        measured(elsewhere(PLAN, bent_at("elbow_left", 0.5), heading, (3.0, 1.0, 0.0)), POSE),
    )
    assert here["end_effector_error_m"] > 0.001  # pyright: ignore[reportOptionalOperand, reportOperatorIssue]
    for error in ERRORS:
        assert there[error] == pytest.approx(here[error], abs=1e-9)


def test_one_joint_off_about_one_axis_counts_once_among_the_axes_of_all_joints_but_the_wrists():
    out = measured(bent_at("elbow_left", 0.36), POSE)
    assert out["worst_joint"] == "elbow_left"
    assert out["joint_error_parent_rad"] == pytest.approx(0.36 / (12 * 3))
    assert out["joint_error_parent_rad_vs_mapped"] == pytest.approx(0.36 / (10 * 3))


def test_in_the_world_a_bent_knee_also_turns_the_foot_below_it():
    out = measured(bent_at("knee_left", 0.2), POSE)
    parent, world = out["joint_error_parent_rad"], out["joint_error_world_rad"]
    assert isinstance(parent, float) and isinstance(world, float)
    assert 1.5 * parent < world < 3.5 * parent


def test_wrists_never_count_and_ankles_not_against_the_input():
    assert measured(bent_at("wrist_left", 1.0), POSE)["joint_error_parent_rad"] == pytest.approx(0.0, abs=1e-9)
    out = measured(bent_at("ankle_right", 1.0), POSE)
    assert out["joint_error_parent_rad_vs_mapped"] == pytest.approx(0.0, abs=1e-9)
    assert out["joint_error_parent_rad"] == pytest.approx(1.0 / 36.0)


def test_target_and_input_are_measured_apart():
    out = measured(POSE, POSE, bent_at("spine", 0.3))
    assert out["joint_error_parent_rad"] == pytest.approx(0.0, abs=1e-9)
    assert out["joint_error_parent_rad_vs_mapped"] == pytest.approx(0.3 / 30.0)
    assert out["worst_joint_vs_mapped"] == "spine"
    assert isinstance(away := out["end_effector_error_m_vs_mapped"], float) and away > 0.02


def test_a_hand_ten_centimetres_off_is_two_centimetres_over_five_end_effectors():
    moved = PosedSkeleton(POSE.turn, POSE.joint.copy(), POSE.root_orientation, POSE.joint_rotation)
    moved.joint[5] += [0.0, 0.06, 0.08]
    assert measured(moved, POSE)["end_effector_error_m"] == pytest.approx(0.02)


def test_samples_are_averaged():
    error = TrackingError()
    for angle in (0.1, 0.3):
        own = bent_at("neck", angle)
        error.sample(body_in(own), own.joint_rotation, target_of(PLAN, POSE))
    assert error.summary()["joint_error_parent_rad"] == pytest.approx(0.2 / 36.0)


def test_without_a_sample_there_is_no_error_to_tell():
    out = TrackingError().summary()
    assert set(out) == {f"{name}{suffix}" for name in (*ERRORS, "worst_joint") for suffix in ("", "_vs_mapped")}
    assert all(value is None for value in out.values())
