"""The eight motions are what they are called, and none of them is tame."""

import itertools

import numpy as np
import pytest

from game.inputs.performance.person import point_masses
from game.inputs.performer import Performer
from kinect.body import Joint
from tests.inputs.performer_ground import ALL, ANKLES, STEP_S, bearing, performed, rate, sole

QUIET_S = 0.7
LEGS = ((Joint.HIP_LEFT, Joint.KNEE_LEFT, Joint.ANKLE_LEFT), (Joint.HIP_RIGHT, Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT))
ARMS = ((Joint.SHOULDER_LEFT, Joint.ELBOW_LEFT, Joint.WRIST_LEFT), (Joint.SHOULDER_RIGHT, Joint.ELBOW_RIGHT, Joint.WRIST_RIGHT))


def bend(joints, chain):
    """(T,) angle between the two bones of a limb, radians, 0 straight."""
    upper = joints[:, chain[1]] - joints[:, chain[0]]
    lower = joints[:, chain[2]] - joints[:, chain[1]]
    cosine = (upper * lower).sum(axis=1) / (np.linalg.norm(upper, axis=1) * np.linalg.norm(lower, axis=1))
    return np.arccos(np.clip(cosine, -1.0, 1.0))


def turning_points(values):
    """Indices where values turn back."""
    return np.nonzero(np.diff(np.sign(np.diff(values))))[0] + 1


def inclination(joints, lower, axis):
    """(T,) degrees by which the line from lower to SHOULDER_CENTER leans towards a world axis."""
    line = joints[:, Joint.SHOULDER_CENTER] - joints[:, lower]
    return np.degrees(np.arctan2(line[:, axis], line[:, 2]))


@pytest.mark.parametrize("name", ALL)
def test_it_begins_and_ends_in_quiet_standing(name):
    t, joints = performed(name)
    assert np.abs(joints[t <= QUIET_S] - joints[0]).max() < 0.005
    assert np.linalg.norm(rate(joints)[t <= QUIET_S], axis=-1).max() < 0.05
    assert np.abs(joints[t > t[-1] - 0.1] - joints[0]).max() < 0.01
    for arm, leg in zip(ARMS, LEGS):
        hang = joints[0, arm[2]] - joints[0, arm[0]]
        assert -hang[2] > 0.5, "arms hang"
        assert 5.0 < np.degrees(bend(joints[:1], leg)[0]) < 20.0, "knees nearly straight, not locked"
    assert joints[0, Joint.ANKLE_LEFT, 1] - joints[0, Joint.ANKLE_RIGHT, 1] == pytest.approx(0.2, abs=0.04)


@pytest.mark.parametrize("name", ALL)
def test_joints_turn_no_faster_than_a_persons_and_legs_never_lock(name):
    _, joints = performed(name)
    for leg in LEGS:
        assert np.degrees(bend(joints, leg).min()) > 5.0
        assert np.abs(rate(bend(joints, leg))).max() < 12.0
    for arm in ARMS:
        assert np.abs(rate(bend(joints, arm))).max() < 20.0


def test_waving_swings_each_wrist_by_forty_centimetres_more_than_once_a_second():
    t, joints = performed("waving")
    for wrist, start in ((Joint.WRIST_RIGHT, 2.0), (Joint.WRIST_LEFT, 6.9)):
        waving = (t > start) & (t < 9.4)
        path = joints[waving, wrist, 1]
        turns = turning_points(path)
        assert np.abs(np.diff(path[turns])).min() >= 0.40
        assert 1.0 / (2.0 * np.diff(t[waving][turns]).mean()) >= 1.0
        assert joints[waving, wrist, 2].max() > joints[0, Joint.HEAD, 2]


def test_leaning_bends_the_trunk_by_25_degrees_to_both_sides_and_moves_the_weight_with_it():
    _, joints = performed("leaning")
    lean = inclination(joints, Joint.HIP_CENTER, 1)
    assert lean.max() >= 25.0 and lean.min() <= -25.0
    assert np.count_nonzero(np.diff(np.sign(lean[np.abs(lean) > 20.0]))) >= 4
    assert np.linalg.norm(rate(joints[:, Joint.SHOULDER_CENTER]), axis=1).max() < 0.5, "slowly"
    weight = point_masses(joints)[..., 1].mean(axis=1)
    assert np.corrcoef(weight, lean)[0, 1] > 0.8


def test_bowing_inclines_the_trunk_by_60_degrees_with_the_hips_going_back():
    _, joints = performed("bowing")
    bow = inclination(joints, Joint.HIP_CENTER, 0)
    assert bow.max() >= 60.0
    assert joints[bow.argmax(), Joint.HIP_CENTER, 0] < joints[0, Joint.HIP_CENTER, 0] - 0.1


def test_reaching_brings_both_wrists_below_half_a_metre_with_bent_knees():
    _, joints = performed("reaching")
    highest = joints[:, [Joint.WRIST_LEFT, Joint.WRIST_RIGHT], 2].max(axis=1)
    lowest = highest.argmin()
    assert highest[lowest] <= 0.50
    assert all(np.degrees(bend(joints, leg)[lowest]) > 45.0 for leg in LEGS)


def test_boxing_throws_twelve_punches_at_three_metres_a_second():
    _, joints = performed("boxing")
    punches = 0
    for _, _, wrist in ARMS:
        speed = np.linalg.norm(rate(joints[:, wrist]), axis=1)
        peaks = turning_points(speed)
        forward = rate(joints[:, wrist])[peaks, 0] > 0.8 * speed[peaks]
        punches += np.count_nonzero((speed[peaks] >= 3.0) & forward)
    assert punches >= 12
    frames = np.array([frame.positions for frame in Performer("boxing").poll(16.0)])
    seen = [np.linalg.norm(frames[2:, wrist] - frames[:-2, wrist], axis=1).max() * 15.0 for _, _, wrist in ARMS]
    assert min(seen) >= 3.0, "fast enough even for a sensor that sees it over two frames"


def test_stepping_lifts_the_feet_in_turn_ten_times_by_eight_centimetres():
    t, joints = performed("stepping")
    steps = []
    for side in ANKLES:
        up = ~bearing("stepping", side)
        starts, ends = np.nonzero(np.diff(up.astype(int)) == 1)[0], np.nonzero(np.diff(up.astype(int)) == -1)[0]
        clearance = sole(joints, side)[..., 2].min(axis=1)
        steps += [(t[a], side, clearance[a : b + 1].max()) for a, b in zip(starts, ends)]
    steps.sort()
    assert len(steps) >= 10
    assert min(height for _, _, height in steps) >= 0.08
    assert all(before[1] != after[1] for before, after in itertools.pairwise(steps))


@pytest.mark.parametrize("side", ["left", "right"])
def test_balancing_holds_each_leg_up_for_five_seconds(side):
    t, joints = performed("balancing")
    clearance = sole(joints, side)[..., 2].min(axis=1)
    other = "right" if side == "left" else "left"
    held = (clearance > 0.15) & bearing("balancing", other)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], held.astype(int), [0]])))
    assert max(b - a for a, b in zip(edges[::2], edges[1::2])) * STEP_S >= 5.0
    assert t[-1] > 28.0


def test_each_jump_clears_five_centimetres_and_a_fifth_of_a_second_from_a_crouch():
    t, joints = performed("jump")
    flying = ~bearing("jump", "left") & ~bearing("jump", "right")
    edges = np.flatnonzero(np.diff(flying.astype(int)))
    jumps = list(zip(edges[::2], edges[1::2]))
    assert len(jumps) >= 3
    lowest = np.minimum(sole(joints, "left")[..., 2].min(axis=1), sole(joints, "right")[..., 2].min(axis=1))
    for a, b in jumps:
        assert t[b] - t[a] >= 0.2
        assert lowest[a:b].max() >= 0.05
        before, after = (t > t[a] - 0.6) & (t < t[a]), (t > t[b]) & (t < t[b] + 0.6)
        for part in (before, after):
            assert all(np.degrees(bend(joints[part], leg).max()) > 60.0 for leg in LEGS)
