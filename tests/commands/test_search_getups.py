"""The search for key poses: what it turns, how it judges a try, and what it writes."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

from game import rotation
from game.characters.joint_limits import HIGH, LOW
from game.commands import BAD_INPUT, main
from game.commands.getup_trial import AXES, LONGEST_S, READY, SHORTEST_S, UNREADY, Trial, numbers_of, poses_of, unreadiness
from game.commands.search_getups import lies_on, write_key_poses
from game.control.whole_body import key_poses as room
from game.control.whole_body.key_poses import ROUTES, KeyPose, key_poses, pose_of
from game.tunables import Settings
from tests.physics.standing import bent, idle_joints, world_of


@pytest.mark.parametrize("route", ROUTES)
def test_numbers_and_poses_say_the_same(route):
    poses = key_poses()[route]
    for pose, again in zip(poses, poses_of(route, numbers_of(route, poses)), strict=True):
        np.testing.assert_allclose(again.joints, pose.joints, atol=2e-3)
        assert again.seconds == pytest.approx(min(max(pose.seconds, SHORTEST_S), LONGEST_S))


@pytest.mark.parametrize("route", ROUTES)
def test_whatever_is_proposed_a_human_could_do(route):
    rng = np.random.default_rng(0)
    for pose in poses_of(route, 5.0 * rng.normal(size=3 * (len(AXES[route]) + 1))):
        assert np.all(pose.joints >= LOW) and np.all(pose.joints <= HIGH) and SHORTEST_S <= pose.seconds <= LONGEST_S


def test_a_standing_body_is_ready_and_the_farther_from_it_the_worse():
    def of(height=0.0, joints=None):
        return unreadiness(world_of((0.0, 0.0, height), joints=joints).characters[0])

    assert of() == pytest.approx(0.0, abs=1e-6)
    assert 0.0 < of(0.05) < of(0.1)
    assert of(joints=bent(ankle_left=(0.0, 0.3, 0.0))) > 0.02
    leaning = [of(joints=bent(spine=(0.0, angle, 0.0))) for angle in (0.0, 0.8, 1.4)]
    assert leaning[0] <= leaning[1] <= leaning[2]


def test_it_tells_how_a_body_lies():
    def turned(x, y):
        return lies_on(np.concatenate((np.zeros(3), rotation.exp(np.array([x, y, 0.0])), idle_joints().reshape(-1))))

    assert [turned(0.0, -1.5), turned(0.0, 1.5), turned(1.5, 0.0), turned(-1.5, 0.0)] == ["supine", "prone", "side", "side"]


def test_a_try_that_does_nothing_is_not_good_and_repeats():
    trial = Trial("original", Settings({"physics.self_collision": True}))
    lying = trial.lie(np.random.default_rng(1))
    np.testing.assert_array_equal(lying, trial.lie(np.random.default_rng(1)))
    assert lying[2] < 0.4, "it has come down"
    straight = (KeyPose(pose_of(), 0.2),)
    losses = [trial.loss(lying, "prone", straight) for _ in range(2)]
    assert losses[0] >= UNREADY > READY and losses[0] == losses[1]


def test_what_it_writes_is_read_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "poses.toml"
    write_key_poses(path, dict(key_poses()))
    assert set(tomllib.loads(path.read_text())) == set(ROUTES)
    monkeypatch.setattr(room, "asset", lambda name: path)
    again = key_poses.__wrapped__()
    for route in ROUTES:
        for before, after in zip(key_poses()[route], again[route], strict=True):
            np.testing.assert_allclose(after.joints, before.joints, atol=2e-3)
            assert after.seconds == pytest.approx(before.seconds, abs=1e-3)


def test_bad_input_gets_one_sentence(capsys: pytest.CaptureFixture[str]):
    assert main(["search-getups", "--route", "prone", "--out", "poses.txt"]) == BAD_INPUT
    said = capsys.readouterr().err.strip()
    assert ".toml" in said and "\n" not in said
