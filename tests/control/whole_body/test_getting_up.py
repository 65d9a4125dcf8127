"""Getting up by key poses: torques within the joints' strength, and feet that can take over only where they could stand up."""

import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import JOINT_COUNT
from game.characters.strength import joint_strength
from game.control.whole_body.getting_up import FULL_RAD, HELD_S, GettingUp, drive, is_ready, nearer_route_of, route_of
from game.control.whole_body.key_poses import KeyPose, key_poses, pose_of
from game.control.whole_body.torque_limits import limits_at
from tests.physics.standing import bent, idle_joints, original, world_of

LOW, HIGH = joint_strength(original())
X, Y = (np.array(axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))


def driven(start, goal, span_s, since_s, joints, velocity):
    """(rotations (14, 4), kp (42,), kd (42,))"""
    out = np.empty((JOINT_COUNT, 4)), np.empty(42), np.empty(42)
    drive(start, goal, span_s, since_s, joints, velocity, LOW, HIGH, *out)
    return out


def torque(joints, velocity, command):
    """(42,) that stable PD gives at the tick."""
    goals, kp, kd = command
    return kp * rotation.log(rotation.multiply(rotation.conjugate(joints), goals)).reshape(-1) - kd * velocity


def test_whatever_the_pose_and_the_speed_the_torque_keeps_within_what_the_joints_have():
    rng = np.random.default_rng(3)
    for _ in range(50):
        goal, angles, velocity = 0.8 * rng.normal(size=(14, 3)), 0.5 * rng.normal(size=(14, 3)), 6.0 * rng.normal(size=42)
        joints = rotation.exp(angles)
        given = torque(joints, velocity, driven(angles, goal, 0.3, rng.uniform(0.0, 0.5), joints, velocity))
        least, most = limits_at(LOW, HIGH, velocity)
        assert np.all(given >= least - 1e-9) and np.all(given <= most + 1e-9)
        # and some of them are at their limit, or nothing is shown
        assert np.any(np.isclose(given, least)) and np.any(np.isclose(given, most))


def test_a_body_that_rests_in_its_key_pose_needs_no_torque():
    pose = pose_of(hip=(0.0, -0.5, 0.0), knee=(0.0, 1.0, 0.0))
    joints = rotation.exp(pose)
    np.testing.assert_allclose(torque(joints, np.zeros(42), driven(pose, pose, 0.3, 0.4, joints, np.zeros(42))), 0.0, atol=1e-9)


def test_a_joint_far_from_its_goal_gets_all_its_strength_and_one_near_it_a_share():
    knee = 3 * 9 + 1
    goal = pose_of(knee=(0.0, 2.0, 0.0))
    far = torque(idle_joints(), np.zeros(42), driven(np.zeros((14, 3)), goal, 0.3, 1.0, idle_joints(), np.zeros(42)))
    assert far[knee] == pytest.approx(HIGH[knee])
    joints = bent(knee_left=(0.0, 2.0 - 0.1 * FULL_RAD, 0.0))
    near = torque(joints, np.zeros(42), driven(np.zeros((14, 3)), goal, 0.3, 1.0, joints, np.zeros(42)))
    assert near[knee] == pytest.approx(0.1 * min(-LOW[knee], HIGH[knee]))


def lying(turn):
    world = world_of((0.0, 0.0, 0.0))
    world.place(0, np.array([0.0, 0.0, 0.3]), turn, idle_joints())
    return world.characters[0]


def test_it_knows_how_it_lies():
    back, front = rotation.exp(-0.5 * np.pi * Y), rotation.exp(0.5 * np.pi * Y)
    assert route_of(lying(back)) == "supine" and route_of(lying(front)) == "prone"
    for angle in (0.5 * np.pi, -0.5 * np.pi):
        assert route_of(lying(rotation.exp(angle * X))) == "side"
    assert nearer_route_of(lying(rotation.multiply(rotation.exp(1.4 * X), rotation.exp(-0.3 * Y)))) == "supine"


def test_poses_off_the_side_are_mirrored_on_the_left_one():
    right_down, left_down = (lying(rotation.exp(angle * X)) for angle in (0.5 * np.pi, -0.5 * np.pi))
    goals = []
    for body in (right_down, left_down):
        out = np.empty((JOINT_COUNT, 4)), np.empty(42), np.empty(42)
        GettingUp(body, "side").drive(body, LOW, HIGH, 10.0, *out)
        goals.append(rotation.log(out[0]))
    mirrored = goals[1][[0, 1, 5, 6, 7, 2, 3, 4, 11, 12, 13, 8, 9, 10]] * [-1.0, 1.0, -1.0]
    # strength is the same on both sides but for round-off
    np.testing.assert_allclose(goals[0], mirrored, atol=1e-9)
    assert np.abs(goals[0] - goals[1]).max() > 0.05


def test_pose_follows_pose_and_a_try_ends_after_the_last_has_been_held():
    body = lying(rotation.exp(0.5 * np.pi * Y))
    poses = (KeyPose(pose_of(knee=(0.0, 0.2, 0.0)), 0.2), KeyPose(pose_of(knee=(0.0, 0.4, 0.0)), 0.3))
    getting_up, out, ticks, last = GettingUp(body, "prone", poses), (np.empty((14, 4)), np.empty(42), np.empty(42)), 0, 0
    while not getting_up.has_ended:
        getting_up.drive(body, LOW, HIGH, 1.0 / 60.0, *out)
        ticks, last = ticks + 1, last + getting_up.comes_to_stand
    assert ticks - last == 12
    assert last / 60.0 == pytest.approx(0.3 + HELD_S, abs=0.02)


def test_who_rolls_over_does_not_come_to_stand():
    body = lying(rotation.exp(-0.5 * np.pi * Y))
    getting_up, out, ticks = GettingUp(body, "supine"), (np.empty((14, 4)), np.empty(42), np.empty(42)), 0
    while not getting_up.has_ended:
        getting_up.drive(body, LOW, HIGH, 1.0 / 60.0, *out)
        ticks += 1
        assert not getting_up.comes_to_stand
    assert ticks / 60.0 == pytest.approx(sum(pose.seconds for pose in key_poses()["supine"]), abs=0.05)


def test_feet_take_over_where_a_body_could_stand_up_and_nowhere_else():
    def ready(height=0.0, joints=None, velocity=(0.0, 0.0, 0.0)):
        world = world_of((0.0, 0.0, height), joints=joints)
        world.data.qvel[:3] = velocity
        world.refresh()
        return is_ready(world.characters[0])

    assert ready()
    assert not ready(height=0.05), "in the air"
    assert not ready(joints=bent(ankle_left=(0.0, 0.5, 0.0))), "on its toes"
    assert not ready(velocity=(0.0, 0.0, -1.0)), "fast"
    assert not ready(velocity=(-0.6, 0.0, 0.0)), "on its way over its heels"
