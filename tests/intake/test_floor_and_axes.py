"""However the sensor is tilted, its floor becomes the room's floor; without a floor the ankles stand in for it (thesis 3.3.1)."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game import rotation
from game.floor_level import level_over_floor
from game.intake.world_frame import ANKLE_ABOVE_SOLE_M, Levelling, floor_from_ankles, to_world
from game.rotation import Floats
from kinect.body import BodyFrame, Floor, Joint
from tests.kinect.recordings import standing_joints

FEW = settings(max_examples=40)
DIRECTION = (
    st.tuples(*[st.floats(-1.0, 1.0)] * 3).map(np.array).filter(lambda v: np.linalg.norm(v) > 0.1).map(lambda v: v / np.linalg.norm(v))
)
UP = np.array([0.0, 1.0, 0.0])


def plane(normal: Floats, height: float) -> Floor:
    return Floor(float(normal[0]), float(normal[1]), float(normal[2]), height)


def frame(positions: Floats, floor: Floor | None, time_s: float = 0.0) -> BodyFrame:
    return BodyFrame(time_s, positions, np.ones(20), floor=floor)


def heights(joints: Floats) -> Floats:
    return joints[:, 2]


@FEW
@given(normal=DIRECTION, height=st.floats(-2.0, 3.0), scale=st.floats(0.2, 5.0), seed=st.integers(0, 99))
def test_points_of_the_plane_come_to_height_zero_and_its_normal_to_vertical(normal, height, scale, seed):
    points = np.random.default_rng(seed).normal(size=(20, 3))
    points -= (points @ normal + height)[:, None] * normal
    floor = plane(scale * normal, scale * height)
    np.testing.assert_allclose(level_over_floor(points, floor)[:, 1], 0.0, atol=1e-9)
    above = level_over_floor(points + 0.7 * normal, floor)
    np.testing.assert_allclose(above - level_over_floor(points, floor), np.tile(0.7 * UP, (20, 1)), atol=1e-9)


@FEW
@given(tilt=st.floats(-0.9, 0.9), height=st.floats(0.1, 2.0))
def test_a_sensor_that_only_nods_is_corrected_exactly(tilt, height):
    level = standing_joints() + [0.0, 0.9 - height, 0.0]
    nod = rotation.exp(np.array([tilt, 0.0, 0.0]))
    seen = rotation.unrotate(nod, level)
    corrected = level_over_floor(seen, plane(rotation.unrotate(nod, UP), height))
    np.testing.assert_allclose(corrected, level + [0.0, height, 0.0], atol=1e-9)


@FEW
@given(tilt=st.floats(-0.5, 0.5), roll=st.floats(-0.5, 0.5))
def test_a_sensor_that_nods_and_leans_keeps_heights_and_distances(tilt, roll):
    level = standing_joints()
    turned = rotation.multiply(rotation.exp(np.array([tilt, 0.0, 0.0])), rotation.exp(np.array([0.0, 0.0, roll])))
    corrected = level_over_floor(rotation.unrotate(turned, level), plane(rotation.unrotate(turned, UP), 0.9))
    np.testing.assert_allclose(corrected[:, 1], level[:, 1] + 0.9, atol=1e-9)
    across = np.linalg.norm(corrected[:, None] - corrected[None], axis=2)
    np.testing.assert_allclose(across, np.linalg.norm(level[:, None] - level[None], axis=2), atol=1e-9)


def test_a_player_before_the_sensor_stands_at_the_origin_and_faces_forward_with_the_left_hand_at_the_left():
    world = to_world(level_over_floor(standing_joints(), Floor(0.0, 1.0, 0.0, 0.9)))
    np.testing.assert_allclose(world[Joint.HIP_CENTER], [0.0, 0.0, 0.97], atol=1e-12)
    assert world[Joint.HAND_LEFT, 1] > 0.1 and world[Joint.HAND_RIGHT, 1] < -0.1
    nearer = to_world(np.array([[0.0, 0.0, 2.0]]))
    assert nearer[0, 0] == pytest.approx(0.5), "a step towards the sensor is a step forward"


def test_the_change_of_axes_is_a_rotation_and_no_mirror():
    axes = (to_world(np.eye(3)) - to_world(np.zeros((3, 3)))).T
    np.testing.assert_allclose(axes @ axes.T, np.eye(3))
    assert np.linalg.det(axes) == pytest.approx(1.0)


def test_the_recorded_floor_is_used_and_kept_while_later_frames_have_none():
    levelling = Levelling()
    levelling.apply(frame(standing_joints(), Floor(0.0, 1.0, 0.0, 1.1)))
    kept = levelling.apply(frame(standing_joints(), None))
    assert kept[Joint.ANKLE_LEFT, 2] == pytest.approx(0.08 + 0.2)


def test_a_new_floor_replaces_the_old():
    levelling = Levelling()
    levelling.apply(frame(standing_joints(), Floor(0.0, 1.0, 0.0, 1.1)))
    assert levelling.apply(frame(standing_joints(), Floor(0.0, 1.0, 0.0, 0.9)))[Joint.ANKLE_LEFT, 2] == pytest.approx(0.08)


@pytest.mark.parametrize("floor", [None, Floor(0.0, 0.0, 0.0, 0.0), Floor(math.nan, 1.0, 0.0, 0.9), Floor(0.0, 1.0, 0.0, math.inf)])
def test_without_a_usable_floor_the_lower_ankle_stands_at_ankle_height(floor):
    joints = standing_joints()
    joints[Joint.ANKLE_LEFT, 1] += 0.3
    world = Levelling().apply(frame(joints, floor))
    assert world[Joint.ANKLE_RIGHT, 2] == pytest.approx(ANKLE_ABOVE_SOLE_M)
    assert floor_from_ankles(joints).d == pytest.approx(0.9)


def test_without_a_floor_a_jump_leaves_the_floor_where_it_was():
    levelling = Levelling()
    standing = levelling.apply(frame(standing_joints(), None))
    jumping = levelling.apply(frame(standing_joints() + [0.0, 0.25, 0.0], None))
    np.testing.assert_allclose(heights(jumping), heights(standing) + 0.25)


def test_without_a_floor_a_player_who_began_on_one_leg_sinks_to_the_lowest_ankle_once_both_stand():
    levelling = Levelling()
    levelling.apply(frame(standing_joints() + [0.0, 0.1, 0.0], None))
    assert heights(levelling.apply(frame(standing_joints(), None)))[Joint.ANKLE_LEFT] == pytest.approx(ANKLE_ABOVE_SOLE_M)


def test_a_guessed_floor_gives_way_to_a_real_one():
    levelling = Levelling()
    levelling.apply(frame(standing_joints(), None))
    assert heights(levelling.apply(frame(standing_joints(), Floor(0.0, 1.0, 0.0, 0.95))))[Joint.ANKLE_LEFT] == pytest.approx(0.13)


def test_levelling_leaves_the_frame_as_it_was():
    joints = standing_joints()
    Levelling().apply(frame(joints, Floor(0.1, 0.9, 0.2, 0.9)))
    np.testing.assert_array_equal(joints, standing_joints())
