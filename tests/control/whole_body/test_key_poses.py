"""Key poses on the way up: read from a file, within human reach, mirrored as a body is."""

import numpy as np
import pytest

from game.characters.joint_limits import HIGH, LOW
from game.characters.skeleton import JOINTS
from game.control.whole_body.key_poses import ROUTES, in_mirror, key_poses, pose_of


@pytest.mark.parametrize("route", ROUTES)
def test_every_route_has_key_poses_that_a_human_can_take_up_in_a_short_time(route):
    poses = key_poses()[route]
    assert poses
    for pose in poses:
        assert np.all(pose.joints >= LOW) and np.all(pose.joints <= HIGH)
        assert 0.1 <= pose.seconds <= 1.0


def test_what_is_told_of_one_side_holds_for_both_in_a_mirror():
    pose = pose_of(shoulder=(0.3, -0.5, 0.2), spine=(0.0, 0.4, 0.0))
    np.testing.assert_array_equal(in_mirror(pose), pose)
    left, right = JOINTS.index("shoulder_left"), JOINTS.index("shoulder_right")
    np.testing.assert_allclose(pose[[left, right]], [(0.3, -0.5, 0.2), (-0.3, -0.5, -0.2)])


def test_one_side_may_be_told_alone_and_two_mirrors_show_the_thing_itself():
    pose = pose_of(hip=(0.1, -1.0, 0.0), hip_right=(0.2, 0.5, -0.1), neck=(0.1, 0.2, 0.3))
    assert pose[JOINTS.index("hip_right")] == pytest.approx((0.2, 0.5, -0.1))
    np.testing.assert_array_equal(in_mirror(in_mirror(pose)), pose)
    assert in_mirror(pose)[JOINTS.index("hip_left")] == pytest.approx((-0.2, 0.5, 0.1))
