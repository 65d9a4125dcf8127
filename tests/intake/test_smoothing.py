"""The joint filter takes the jitter and leaves the motion, at a bounded delay."""

from itertools import pairwise

import numpy as np
import pytest

from game.intake.smoothing import MAX_DEVIATION_M, JointSmoothing
from game.rotation import Floats

STRENGTHS = [0.25, 0.5, 1.0, 2.0]
POSE = np.random.default_rng(2).normal(size=(20, 3))


def filtered(joints: Floats, strength: float) -> Floats:
    """(T, 20, 3) through one filter, frame by frame."""
    smoothing = JointSmoothing()
    return np.array([smoothing.apply(frame, strength) for frame in joints])


def lag_frames(signal: Floats, output: Floats) -> float:
    """Delay of a sinusoid of one period a second at 30 Hz against another, from the phase of their Fourier coefficients."""
    wave = np.exp(-2j * np.pi * np.arange(len(signal)) / 30.0)
    return float(np.angle((signal @ wave) / (output @ wave)) * 30.0 / (2.0 * np.pi))


def test_strength_zero_passes_every_frame_through():
    joints = np.random.default_rng(3).normal(size=(20, 20, 3))
    np.testing.assert_array_equal(filtered(joints, 0.0), joints)


@pytest.mark.parametrize("strength", STRENGTHS)
def test_a_still_player_is_left_alone(strength):
    np.testing.assert_allclose(filtered(np.tile(POSE, (30, 1, 1)), strength), np.tile(POSE, (30, 1, 1)), atol=1e-12)


@pytest.mark.parametrize(("strength", "settled_s"), [(0.25, 0.5), (0.5, 0.7), (1.0, 1.5), (1.5, 3.0), (2.0, 9.0)])
def test_after_a_step_the_output_settles_on_the_new_place(strength, settled_s):
    joints = np.concatenate((np.tile(POSE, (5, 1, 1)), np.tile(POSE + 0.3, (400, 1, 1))))
    out = filtered(joints, strength)
    settled = 5 + round(30 * settled_s)
    np.testing.assert_allclose(out[settled:], joints[settled:], atol=0.004)


@pytest.mark.parametrize("strength", STRENGTHS)
def test_the_output_never_strays_from_the_sensor_by_more_than_the_deviation_limit(strength):
    joints = np.cumsum(np.random.default_rng(4).normal(scale=0.05, size=(100, 20, 3)), axis=0)
    stray = np.linalg.norm(filtered(joints, strength) - joints, axis=2)
    assert stray.max() <= MAX_DEVIATION_M * strength + 1e-12
    assert stray.max() > 0.5 * MAX_DEVIATION_M * strength, "the walk is rough enough to reach the limit"


def test_jitter_shrinks_and_the_more_the_stronger_the_filter():
    joints = POSE + np.random.default_rng(5).normal(scale=0.004, size=(300, 20, 3))
    jitter = [np.diff(filtered(joints, strength)[30:], axis=0).std() for strength in (0.0, *STRENGTHS)]
    assert all(stronger < weaker for weaker, stronger in pairwise(jitter))
    assert jitter[STRENGTHS.index(1.0) + 1] < 0.25 * jitter[0]


@pytest.mark.parametrize(("strength", "longest"), [(0.25, 0.5), (0.5, 0.5), (1.0, 1.0), (2.0, 3.0)])
def test_a_waving_hand_is_followed_within_a_few_frames_and_keeps_its_reach(strength, longest):
    wave = 0.2 * np.sin(2.0 * np.pi * np.arange(150) / 30.0)
    out = filtered(POSE + wave[:, None, None] * np.array([1.0, 0.0, 0.0]), strength)[:, 0, 0] - POSE[0, 0]
    assert -0.5 <= lag_frames(wave[60:], out[60:]) <= longest, "a weak filter predicts up to half a frame ahead"
    assert 0.75 < np.ptp(out[60:]) / 0.4 < 1.25


def test_turning_the_filter_off_and_on_starts_it_afresh():
    smoothing = JointSmoothing()
    smoothing.apply(POSE, 1.0)
    smoothing.apply(POSE + 1.0, 0.0)
    np.testing.assert_allclose(smoothing.apply(POSE + 1.0, 1.0), POSE + 1.0)


def test_the_filter_does_not_write_into_its_input():
    joints = np.tile(POSE, (3, 1, 1)) + np.arange(3)[:, None, None]
    kept = joints.copy()
    filtered(joints, 1.0)
    np.testing.assert_array_equal(joints, kept)
