"""A fall: given up when no step helps, arms to the floor, chin off it, ever less firm, every joint within its range."""

import numpy as np
import pytest

from game import rotation
from game.characters.joint_limits import HIGH, LOW, joint_angles
from game.characters.skeleton import JOINT_COUNT, JOINTS, PARTS
from game.control.whole_body.falling import LET_GO_S, LIMP_RATE, LOST_M, THROWN_M, TOPPLED_M, fall, is_lost, protective_pose
from game.tunables import Settings
from tests.physics.standing import bent
from tests.scenes.staged import make_scene, run_s

SQUARE = np.array([[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]])
NECK = 3 * JOINTS.index("neck") + 1
DIRECTIONS = [(1.0, 0.0, -0.2), (-1.0, 0.0, -0.2), (0.1, 1.0, -0.2), (0.1, -1.0, -0.2), (0.0, 0.0, -1.0)]


def commanded(since_s=0.0, turn=None):
    """(rotation vectors (42,), kp (42,), kd (42,)) of a fall, all inertias 0.5 kg m^2."""
    rotations, kp, kd = np.empty((JOINT_COUNT, 4)), np.empty(42), np.empty(42)
    fall(since_s, np.eye(3) if turn is None else turn, bent(), np.full(42, 0.5), rotations, kp, kd)
    return rotation.log(rotations).reshape(-1), kp, kd


def test_balance_is_given_up_where_no_step_reaches_and_sooner_where_the_trunk_has_toppled():
    def com(beyond: float) -> np.ndarray:
        return np.array([0.1 + beyond, 0.0, 0.9])

    def lost(beyond: float, trunk_up: float) -> bool:
        return is_lost(SQUARE, com(beyond), com(beyond)[:2], trunk_up)

    assert not lost(LOST_M - 0.01, 0.9) and lost(LOST_M + 0.01, 0.9)
    assert not lost(TOPPLED_M - 0.01, 0.1) and lost(TOPPLED_M + 0.01, 0.1)


def test_balance_is_given_up_where_the_body_is_thrown_farther_than_it_can_step():
    over = np.array([0.0, 0.0, 0.9])
    assert not is_lost(SQUARE, over, np.array([0.1 + THROWN_M - 0.01, 0.0]), 1.0)
    assert is_lost(SQUARE, over, np.array([0.1 + THROWN_M + 0.01, 0.0]), 1.0)


def test_who_bows_to_the_floor_over_the_feet_has_not_lost_the_balance():
    assert not is_lost(SQUARE, np.array([0.05, 0.0, 0.6]), np.array([0.05, 0.0]), -0.2)


def test_arms_go_ahead_in_a_fall_to_the_front_and_the_chin_is_tucked_in_one_to_the_back():
    front, back = (protective_pose(np.array([ahead, 0.0, -0.1])).reshape(-1) for ahead in (1.0, -1.0))
    for side in ("left", "right"):
        shoulder = 3 * JOINTS.index(f"shoulder_{side}") + 1
        assert front[shoulder] < -1.0 and back[shoulder] > 0.3
    assert front[NECK] < -0.3 and back[NECK] > 0.5


def test_a_fall_to_either_side_mirrors_the_other():
    left, right = (protective_pose(np.array([0.0, side, -0.2])) for side in (1.0, -1.0))
    np.testing.assert_array_equal(left, right)


@pytest.mark.parametrize("down", DIRECTIONS)
def test_every_protective_pose_is_within_human_reach(down):
    pose = protective_pose(np.array(down)).reshape(-1, 3)
    assert np.all(pose >= LOW) and np.all(pose <= HIGH)


def test_stiffness_goes_by_degrees_and_damping_stays():
    gains = np.array([commanded(since_s=t)[1:] for t in np.linspace(0.0, 2.0 * LET_GO_S, 13)])
    kp, kd = gains[:, 0], gains[:, 1]
    assert np.diff(kp, axis=0).max() <= 0.0
    np.testing.assert_allclose(kp[-1], 0.5 * LIMP_RATE**2)
    np.testing.assert_array_equal(kd[0], kd[-1])


def shoved(direction_deg: float) -> dict[str, float]:
    """What a shove of 200 N s at the chest leads to within three seconds: rad/s; degrees past a range."""
    settings = Settings({"physics.self_collision": True, "whole_body.get_up": False})
    scene = make_scene("mirror", "performer:standing", settings)
    scene.enter()
    run_s(scene, 0.5)
    simulation = scene.simulation  # type: ignore[attr-defined]
    world, body = simulation.world, simulation.world.characters[0]
    angle = np.radians(direction_deg)
    world.push(0, PARTS.index("trunk"), 1000.0 * np.array([np.cos(angle), np.sin(angle), 0.0]), round(0.2 / world.step_s))
    speeds, past = [], []
    for _ in range(180):
        scene.fixed_update()
        speeds.append(np.linalg.norm(body.velocity[6:].reshape(-1, 3), axis=1))
        angles = joint_angles(body.joint_rotation)
        past.append(np.maximum(np.maximum(LOW - angles, angles - HIGH), 0.0).max())
    out = {
        "fallen": float(simulation.fighters[0].strategy.fallen),
        "fast": float(np.percentile(speeds, 99)),
        "past": float(np.degrees(np.max(past))),
        "calm": float(np.mean(speeds[-30:])),
        "unexplained": float(world.meter.unexplained_force_n[0]),
        "guarded": float(world.guard_actions),
    }
    scene.leave()
    return out


FALLS_DEG = [0.0, 100.0, 200.0]


@pytest.mark.parametrize("direction_deg", FALLS_DEG)
def test_a_body_shoved_over_falls_without_whirling_limbs_by_its_own_torques(direction_deg):
    found = shoved(direction_deg)
    assert found["fallen"] and not found["guarded"]
    assert found["fast"] < 25.0 and found["calm"] < 2.0
    assert found["past"] < 10.0
    assert found["unexplained"] < 1e-6
