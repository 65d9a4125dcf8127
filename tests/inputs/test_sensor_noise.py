"""At scale 1 the sensor model errs as much as a real Kinect v1, and in the same way."""

import numpy as np
import pytest

from game.inputs.performer import FLOOR, NAMES, performed_joints, to_sensor
from game.inputs.sensor_noise import SensorNoise
from game.inputs.sensor_noise_bow import hip_drop
from game.inputs.sensor_noise_states import InferredRuns
from game.inputs.sensor_noise_table import BONE_CV, INFERRED_SHARE, JITTER_MM, RESTING_LAG1, RETURN_STEP_MM, RUN_FRAMES
from kinect.body import BONES, BodyFrame, Floats, Joint

WITHIN = 0.25
"""How near the model has to come to the measured figures."""


class Poses:
    """A source that shows the given poses, 30 a second, level sensor."""

    status = "Poses."

    def __init__(self, positions: Floats) -> None:
        self.positions = positions
        self.next = 0

    @property
    def length_s(self) -> float:
        return (len(self.positions) - 1) / 30.0

    def poll(self, until_s: float) -> list[BodyFrame]:
        frames = []
        while self.next < len(self.positions) and self.next / 30.0 <= until_s + 1e-9:
            frames.append(BodyFrame(self.next / 30.0, self.positions[self.next], np.ones(20), floor=FLOOR))
            self.next += 1
        return frames

    def close(self) -> None:
        self.next = len(self.positions)


def motion(name: str, every_s: float = 1.0 / 30.0) -> Floats:
    """(T, 20, 3) a performed motion in the sensor frame."""
    ends = {
        "waving": 12.1,
        "leaning": 32.0,
        "bowing": 9.2,
        "reaching": 8.6,
        "boxing": 15.6,
        "stepping": 10.7,
        "balancing": 28.3,
        "jump": 21.2,
    }
    return to_sensor(performed_joints(name, np.arange(0.0, ends[name], every_s)))


def resting(frames: int) -> Floats:
    return np.repeat(to_sensor(performed_joints("standing", 0.0)), frames, axis=0)


def seen(positions: Floats, **settings: float) -> tuple[Floats, Floats]:
    """(T, 20, 3) positions and (T, 20) confidence as the sensor model reports them."""
    seed = int(settings.pop("seed", 0))
    frames = SensorNoise(Poses(positions), seed=seed, **settings).poll(np.inf)
    return np.array([f.positions for f in frames]), np.array([f.confidence for f in frames])


def bone_cv(positions: Floats) -> Floats:
    """(19,) standard deviation of each bone's length over its mean."""
    ends = np.array(BONES)
    lengths = np.linalg.norm(positions[:, ends[:, 1]] - positions[:, ends[:, 0]], axis=2)
    return lengths.std(axis=0) / lengths.mean(axis=0)


def assert_near(found: Floats, measured: Floats | tuple[float, ...], within: float = WITHIN) -> None:
    np.testing.assert_allclose(found, measured, rtol=within)


@pytest.fixture(scope="module")
def still() -> tuple[Floats, Floats]:
    """Two minutes of a person who does not move at all."""
    return seen(resting(3600), scale=1.0, seed=11)


def test_a_resting_joint_jitters_by_the_measured_second_difference(still):
    second = np.linalg.norm(np.diff(still[0], 2, axis=0), axis=2)
    assert_near(1000.0 * np.median(second, axis=0), JITTER_MM)


def test_the_jitter_has_heavy_tails(still):
    second = np.linalg.norm(np.diff(still[0], 2, axis=0), axis=2)
    assert np.all(np.percentile(second, 95, axis=0) > 2.2 * np.median(second, axis=0)), "a Gaussian in three axes has 1.8"


def test_a_resting_joint_wanders_with_the_measured_correlation(still):
    windows = still[0].reshape(-1, 30, 20, 3)
    off = windows - windows.mean(axis=1, keepdims=True)
    lag1 = (off[:, 1:] * off[:, :-1]).sum(axis=(1, 3)) / (off**2).sum(axis=(1, 3))
    assert_near(np.median(lag1, axis=0), RESTING_LAG1)


def test_resting_bones_keep_their_length(still):
    assert np.median(bone_cv(still[0])) < 0.015, "0.6 % on real recordings; all the rest comes with movement"


def test_moving_bones_vary_by_the_measured_share():
    spreads = []
    for name in NAMES[:8]:
        positions = motion(name, every_s=0.25)  # the error follows the pose, so four frames a second tell the same
        spreads += [bone_cv(seen(positions, scale=1.0, seed=seed)[0]) for seed in range(16)]
    assert_near(np.median(spreads, axis=0), BONE_CV)


def test_bone_lengths_follow_the_pose_and_not_the_time():
    pose = np.concatenate([motion("boxing")[60:90]] * 2)
    frames = SensorNoise(Poses(pose), scale=1.0, seed=3)._bones
    first, again = (frames.displacement(pose[k], 1.0) for k in (5, 35))
    np.testing.assert_array_equal(first, again)
    moves = [np.abs(frames.displacement(pose[k + 1], 1.0) - frames.displacement(pose[k], 1.0)).max(axis=1) for k in range(29)]
    assert np.delete(moves, [Joint.HAND_LEFT, Joint.HAND_RIGHT], axis=1).max() < 0.04, "slow: even a punch shifts no joint by 4 cm a frame"


def test_inferred_runs_have_the_measured_share_and_length():
    runs = InferredRuns(np.random.default_rng(5))
    steps = [runs.step(1.0) for _ in range(40000)]
    shown = np.array([inferred for inferred, _ in steps])
    offset = np.array([astray for _, astray in steps])
    for left in (
        Joint.SHOULDER_LEFT,
        Joint.ELBOW_LEFT,
        Joint.WRIST_LEFT,
        Joint.HAND_LEFT,
        Joint.KNEE_LEFT,
        Joint.ANKLE_LEFT,
        Joint.FOOT_LEFT,
    ):
        pair = [left, left + 4]  # left and right together: a single joint's long runs are too few for a steady share
        assert shown[:, pair].mean() == pytest.approx(INFERRED_SHARE[pair].mean(), rel=WITHIN), left.name
    assert shown.mean() == pytest.approx(INFERRED_SHARE.mean(), rel=0.1)
    assert not np.any(shown[:, INFERRED_SHARE == 0.0])
    lengths, returns = [], []
    for joint in range(20):
        edge = np.diff(shown[:, joint].astype(int), prepend=0)
        starts, ends = np.flatnonzero(edge == 1), np.flatnonzero(edge == -1)
        lengths.extend(ends - starts[: len(ends)])
        returns.extend(np.linalg.norm(offset[ends, joint] - offset[ends - 1, joint], axis=1) * 1000.0)
    assert_near(np.percentile(lengths, (50, 90)), RUN_FRAMES)
    assert_near(np.percentile(returns, (50, 90)), RETURN_STEP_MM)


def test_inferred_joints_say_so_in_their_confidence():
    assert set(np.unique(seen(resting(300), scale=1.0, seed=2)[1])) == {0.5, 1.0}


def test_a_third_of_the_noise_has_a_third_of_the_runs_and_no_others():
    full, third = (InferredRuns(np.random.default_rng(2)) for _ in range(2))
    shown = np.array([(full.step(1.0)[0], third.step(1.0 / 3.0)[0]) for _ in range(10000)])
    assert not np.any(shown[:, 1] & ~shown[:, 0])
    runs = [np.count_nonzero(np.diff(shown[:, which].astype(int), axis=0) == 1) for which in (0, 1)]
    assert runs[1] / runs[0] == pytest.approx(1.0 / 3.0, rel=0.1)


def test_leaps_of_hands_and_feet_come_with_the_outliers_only():
    positions = resting(1500)
    calm = seen(positions, scale=1.0, seed=8)[0]
    wild = seen(positions, scale=1.0, outliers=1.0, seed=8)[0]
    off = np.linalg.norm(wild - calm, axis=2)
    feet = off[:, [Joint.FOOT_LEFT, Joint.FOOT_RIGHT]]
    assert np.all(off[:, [Joint.HIP_CENTER, Joint.SPINE]] == 0.0)
    assert 0.01 < np.mean(feet > 0.045) < 0.15
    second = np.linalg.norm(np.diff(wild, 2, axis=0), axis=2)[:, Joint.HAND_LEFT]
    assert np.percentile(second, 95) > 0.04, "58 mm on real hands at rest"


def test_the_hips_sink_in_a_bow_while_the_ankles_stay():
    true = motion("bowing")
    frames = SensorNoise(Poses(true), scale=1.0, seed=1).poll(np.inf)
    deepest = int(np.argmin(true[:, Joint.HEAD, 1]))
    plane = frames[deepest].floor
    assert plane is not None
    heights = frames[deepest].positions @ np.array(plane[:3]) + plane.d
    sunk = true[deepest, :, 1] + 0.9 - heights
    assert 0.13 < sunk[Joint.HIP_CENTER] < 0.52
    assert sunk[Joint.HIP_LEFT] > 0.08 and sunk[Joint.SPINE] > 0.08
    assert np.abs(sunk[[Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]]).max() < 0.03
    upright = frames[10].positions @ np.array(frames[10].floor[:3]) + plane.d  # pyright: ignore[reportOptionalSubscript]
    assert abs(true[10, Joint.HIP_CENTER, 1] + 0.9 - upright[Joint.HIP_CENTER]) < 0.04


def test_a_crouch_with_bent_knees_loses_little_of_its_hip_height():
    true = motion("reaching")
    low = true[int(np.argmin(true[:, Joint.HIP_CENTER, 1]))]
    drop = hip_drop(low, np.array([0.0, 1.0, 0.0]))
    assert np.all(drop[:, 1] <= 0.0)
    sunk = low + drop
    assert sunk[Joint.HIP_LEFT, 1] > sunk[Joint.KNEE_LEFT, 1], "the hips stay above the knees"


def test_the_tilted_sensor_reports_the_floor_it_really_sees():
    positions = resting(300)
    frames = SensorNoise(Poses(positions), scale=1.0, seed=6).poll(np.inf)
    plane = frames[0].floor
    assert plane is not None and plane != FLOOR
    assert np.linalg.norm(plane[:3]) == pytest.approx(1.0)
    tilt = np.degrees(np.arccos(plane.b))
    assert 0.1 < tilt < 5.0
    heights = np.array([f.positions[Joint.ANKLE_LEFT] @ np.array(plane[:3]) + plane.d for f in frames])
    assert np.mean(heights) == pytest.approx(0.08, abs=0.02)


def test_frames_come_late_by_the_latency_and_keep_their_capture_time():
    source = SensorNoise(Poses(motion("waving")[:60]), latency_s=0.1)
    assert source.poll(0.09) == []
    assert [frame.time_s for frame in source.poll(0.1)] == [0.0]
    assert max(frame.time_s for frame in source.poll(1.0)) == pytest.approx(0.9)
    source.latency_s = 0.0
    assert max(frame.time_s for frame in source.poll(1.0)) == pytest.approx(1.0)


def test_a_source_without_any_error_passes_untouched():
    true = motion("waving")[:30]
    frames = SensorNoise(Poses(true)).poll(np.inf)
    np.testing.assert_array_equal([frame.positions for frame in frames], true)
    assert all(frame.floor == FLOOR and np.all(frame.confidence == 1.0) for frame in frames)


def test_every_error_grows_with_the_scale():
    true = resting(200)
    third, full = (seen(true, scale=scale, seed=9)[0] for scale in (1.0 / 3.0, 1.0))
    ratio = np.linalg.norm(full - true, axis=2).mean() / np.linalg.norm(third - true, axis=2).mean()
    assert ratio == pytest.approx(3.0, rel=0.02)


def test_equal_seeds_give_equal_frames_however_they_are_polled_and_others_differ():
    true = motion("boxing")[:90]
    at_once = seen(true, scale=1.0, outliers=1.0, seed=5)[0]
    source = SensorNoise(Poses(true), 1.0, 0.0, 1.0, 5)
    bit_by_bit = [frame.positions for k in range(300) for frame in source.poll(k / 100.0)]
    np.testing.assert_array_equal(at_once, bit_by_bit)
    assert not np.allclose(at_once, seen(true, scale=1.0, outliers=1.0, seed=6)[0])


def test_a_joint_that_was_never_seen_stays_unseen_and_spoils_no_other():
    true = resting(20)
    true[:, Joint.HAND_LEFT] = np.nan
    shown = seen(true, scale=1.0, outliers=1.0, seed=1)[0]
    assert np.all(np.isnan(shown[:, Joint.HAND_LEFT]))
    assert np.all(np.isfinite(np.delete(shown, Joint.HAND_LEFT, axis=1)))
