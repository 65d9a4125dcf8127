"""Soles of planted feet lie flat, those of lifted ones are as the sensor has them."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import FEET
from game.target.flat_sole import FLAT_TIME_S, FlatSoles, laid_flat
from game.target.forward_kinematics import part_orientations
from tests.target.players import any_pose

PLAN = load_body_plan("original")
POSES = [any_pose(PLAN, seed, 0.4) for seed in range(6)]
BOTH = np.ones(2)


def feet_of(root, joints):
    return part_orientations(root, joints)[list(FEET)]


@pytest.mark.parametrize("pose", POSES)
def test_a_sole_laid_flat_is_level_and_points_where_it_pointed(pose):
    before = feet_of(pose.root_orientation, pose.joint_rotation)
    after = feet_of(pose.root_orientation, laid_flat(pose.root_orientation, pose.joint_rotation, BOTH))
    np.testing.assert_allclose(rotation.matrix(after)[:, 2, 2], 1.0, atol=1e-12)
    np.testing.assert_allclose([rotation.yaw(q) for q in after], [rotation.yaw(q) for q in before], atol=1e-9)


@pytest.mark.parametrize("pose", POSES)
def test_nothing_but_the_ankles_turns(pose):
    laid = laid_flat(pose.root_orientation, pose.joint_rotation, BOTH)
    others = [joint for joint in range(14) if joint + 1 not in FEET]
    np.testing.assert_array_equal(laid[others], pose.joint_rotation[others])


@pytest.mark.parametrize("pose", POSES)
def test_half_the_share_is_half_the_angle(pose):
    root, joints = pose.root_orientation, pose.joint_rotation
    half, whole = (feet_of(root, laid_flat(root, joints, share * BOTH)) for share in (0.5, 1.0))
    seen = feet_of(root, joints)

    def angle(a, b):
        return np.linalg.norm(rotation.log(rotation.multiply(rotation.conjugate(a), b)), axis=1)

    np.testing.assert_allclose(angle(seen, half), 0.5 * angle(seen, whole), atol=1e-9)


def test_a_foot_that_lifts_is_let_go_gradually_and_the_other_stays_flat():
    soles, pose = FlatSoles(), POSES[0]
    soles.apply(pose.root_orientation, pose.joint_rotation, (True, True), 0.0)
    np.testing.assert_array_equal(soles.share, 1.0)
    for _ in range(12):
        soles.apply(pose.root_orientation, pose.joint_rotation, (False, True), FLAT_TIME_S / 12)
    np.testing.assert_allclose(soles.share, (np.exp(-1.0), 1.0))
