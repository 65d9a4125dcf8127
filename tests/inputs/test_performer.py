"""The performer as a source of frames, and as a body whose bones do not stretch."""

import numpy as np
import pytest

from game.inputs.performance import person
from game.inputs.performer import FLOOR, NAMES, Performer, performed_joints, to_sensor
from kinect.body import BONES, JOINT_COUNT, Joint
from kinect.source import BodySource
from tests.inputs.performer_ground import ALL, CLIPS, performed

LENGTHS_S = (12.1, 32.0, 9.2, 8.6, 15.6, 10.7, 28.3, 21.2)


def test_it_knows_the_eight_clips_of_the_thesis_at_their_lengths():
    assert NAMES == ALL
    assert tuple(Performer(name).length_s for name in CLIPS) == LENGTHS_S
    assert sum(LENGTHS_S) == pytest.approx(137.7)


@pytest.mark.parametrize("name", ALL)
def test_frames_come_at_30_hz_from_time_0_to_the_end_with_every_joint_tracked(name):
    performer: BodySource = Performer(name, player=1)
    frames = performer.poll(1e9)
    np.testing.assert_allclose([frame.time_s for frame in frames], np.arange(len(frames)) / 30.0, atol=1e-12)
    assert performer.length_s is not None
    assert frames[-1].time_s == pytest.approx(performer.length_s, abs=1.0 / 30.0)
    assert all(frame.positions.shape == (JOINT_COUNT, 3) and np.isfinite(frame.positions).all() for frame in frames)
    assert all((frame.confidence == 1.0).all() and frame.floor == FLOOR and frame.player == 1 and frame.metric for frame in frames)


def test_frames_are_the_same_however_often_one_asks():
    at_once = Performer("boxing").poll(3.0)
    bit_by_bit, performer = [], Performer("boxing")
    for until in np.arange(-0.5, 3.0 + 1e-9, 1.0 / 480.0):
        bit_by_bit += performer.poll(float(until))
    assert [frame.time_s for frame in bit_by_bit] == [frame.time_s for frame in at_once]
    for a, b in zip(at_once, bit_by_bit):
        np.testing.assert_array_equal(a.positions, b.positions)


def test_a_frame_may_be_spoiled_without_spoiling_the_next_performance():
    first = Performer("waving").poll(0.0)[0]
    first.positions[:] = np.nan
    assert np.isfinite(Performer("waving").poll(0.0)[0].positions).all()


def test_an_unknown_motion_is_refused_with_the_valid_names():
    with pytest.raises(ValueError, match=r"'dancing'.*waving, leaning, bowing.*standing") as refusal:
        Performer("dancing")
    assert str(refusal.value).count("\n") == 0


def test_the_status_says_what_it_does_and_when_it_is_over():
    performer = Performer("jump")
    performer.poll(2.0)
    assert "jumping" in performer.status and "21.2 s" in performer.status
    performer.close()
    performer.close()
    assert "finished" in performer.status
    assert performer.poll(30.0) == []


def test_the_person_faces_a_level_sensor_two_and_a_half_metres_away():
    frame = Performer("standing").poll(0.0)[0]
    heights = frame.positions @ np.array(FLOOR[:3]) + FLOOR.d
    np.testing.assert_allclose(heights, performed_joints("standing", 0.0)[0, :, 2], atol=1e-12)
    np.testing.assert_allclose(heights[[Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]], person.ANKLE_HEIGHT_M)
    assert frame.positions[Joint.HAND_RIGHT, 0] > frame.positions[Joint.HAND_LEFT, 0]
    assert frame.positions[Joint.FOOT_LEFT, 2] < frame.positions[Joint.ANKLE_LEFT, 2]
    assert frame.positions[Joint.HIP_CENTER, 2] == pytest.approx(2.5, abs=0.05)
    np.testing.assert_allclose(to_sensor(np.array([1.0, 2.0, 3.0])), [-2.0, 2.1, 1.5])


@pytest.mark.parametrize("name", ALL)
def test_no_bone_ever_changes_its_length(name):
    _, joints = performed(name)
    for parent, child in BONES:
        lengths = np.linalg.norm(joints[:, child] - joints[:, parent], axis=1)
        assert np.ptp(lengths) < 1e-9, f"{parent.name} to {child.name}"


def test_the_person_has_a_mans_mass_and_stature():
    assert pytest.approx(person.MASS_KG) == person.POINT_MASSES_KG.sum()
    np.testing.assert_allclose(person.POINT_WEIGHTS.sum(axis=1), 1.0)
    joints = performed_joints("standing", 0.0)[0]
    assert person.centre_of_mass(joints[None])[0, 2] / person.HEIGHT_M == pytest.approx(0.55, abs=0.015)
    assert 1.55 < joints[Joint.HEAD, 2] < person.HEIGHT_M


def test_the_motion_between_frames_is_smooth():
    fine = np.arange(2.0, 2.4, 1e-4)
    joints = performed_joints("boxing", fine)
    assert np.abs(np.diff(joints, 2, axis=0)).max() / 1e-8 < 80.0, "an acceleration in m/s2: no jump in the velocity"
    assert np.abs(np.diff(joints, 3, axis=0)).max() / 1e-4**3 < 5000.0, "a jerk in m/s3: no jump in the acceleration"
