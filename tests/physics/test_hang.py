"""The start-up hang (thesis 4.1): low over the floor, short, upright, the root held, and let go under the meter's eyes."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import BUILT_IN, load_body_plan
from game.characters.skeleton import FEET
from game.physics.hang import HANG_S, SOLE_CLEARANCE_M, hanging_root, hold_root, release_root
from game.physics.world import World
from game.target.forward_kinematics import pose_skeleton
from game.tunables import Settings
from tests.physics.standing import bent, hold, idle_joints, original, run, unexplained

LEANING = bent(
    hip_left=(0.0, -0.4, 0.0), hip_right=(0.0, -0.4, 0.0), spine=(0.0, 0.3, 0.1), knee_left=(0.0, 0.5, 0.0), knee_right=(0.0, 0.5, 0.0)
)
TILTED = rotation.multiply(rotation.about_z(0.7), rotation.exp(np.array([0.1, 0.2, 0.0])))


def test_the_hang_is_short_and_low():
    assert HANG_S < 1.5 and SOLE_CLEARANCE_M < 0.08


@pytest.mark.parametrize("character", BUILT_IN)
def test_an_idle_body_hangs_as_it_stands_two_centimetres_up(character):
    plan = load_body_plan(character)
    position, orientation = hanging_root(plan, np.array([0.3, -0.2]), rotation.IDENTITY, idle_joints())
    assert position[2] - plan.joint[0, 2] == pytest.approx(SOLE_CLEARANCE_M, abs=0.01)
    np.testing.assert_allclose(position[:2], [0.3, -0.2])
    assert np.linalg.norm(rotation.log(orientation)) < 0.1


def test_a_leaning_pose_is_tilted_until_its_com_is_over_its_feet():
    plan = original()
    position, orientation = hanging_root(plan, np.zeros(2), TILTED, LEANING)
    pose = pose_skeleton(plan, position, orientation, LEANING)
    ankles = pose.joint[list(FEET)].mean(axis=0)
    ahead = rotation.rotate(rotation.about_z(-rotation.yaw(orientation)), pose.centre_of_mass(plan) - ankles)
    assert ahead[0] == pytest.approx(plan.centre_offset[FEET[0]][0], abs=0.01)
    assert ahead[1] == pytest.approx(0.0, abs=0.01)
    assert pose.joint[list(FEET), 2].min() - plan.joint[FEET[0], 2] == pytest.approx(SOLE_CLEARANCE_M)


def test_a_lying_pose_is_not_turned_upright_by_force():
    lying = rotation.exp(np.array([0.0, np.pi / 2, 0.0]))
    position, orientation = hanging_root(original(), np.zeros(2), lying, idle_joints())
    assert np.isfinite(position).all()
    np.testing.assert_allclose(orientation, lying)


@pytest.mark.parametrize("index", [0, 1])
def test_a_held_root_keeps_its_place_and_is_free_after_the_release(index):
    """Two characters hang; one is let go: it falls to the floor by gravity alone, the other hangs on."""
    world = World([original()] * 2, Settings())
    world.meter.active = False
    for each, place in enumerate(((0.0, 0.0), (2.0, 0.0))):
        position, orientation = hanging_root(original(), np.array(place), TILTED, LEANING)
        position[2] += 0.05  # these feet are not held flat: their toes shall be free too
        world.place(each, position, orientation, LEANING)
        hold_root(world.model, world.data, each, position, orientation)
    start = [body.configuration[:7] for body in world.characters]

    def pose(body, _step):
        return hold(body, LEANING)

    run(world, 480, pose)
    for body, before in zip(world.characters, start, strict=True):
        now = body.configuration[:7]
        assert np.linalg.norm(now[:3] - before[:3]) < 0.005
        assert np.linalg.norm(rotation.log(rotation.multiply(rotation.conjugate(before[3:]), now[3:]))) < 0.02
    release_root(world.model, world.data, index)
    world.meter.active = True
    run(world, 48, pose)
    fallen, held = world.characters[index], world.characters[1 - index]
    assert fallen.configuration[2] < start[index][2] - 0.01
    assert abs(held.configuration[2] - start[1 - index][2]) < 0.005
    assert world.meter.unexplained_force_n[index] < 1e-6 and world.meter.unexplained_torque_nm[index] < 1e-6
    assert unexplained(world)[0] > 500.0, "the one that still hangs is not honest, and the meter says so"
