"""What control is told of a body, against finite differences and plain sums."""

import mujoco as mj
import numpy as np
import pytest

from game import rotation
from game.characters.skeleton import PARENT, PART_COUNT, is_ancestor
from tests.physics.standing import original, run, thrash, world_of


@pytest.fixture
def pair():
    """Two bodies in wild poses, in motion; the second is looked at, so that offsets by character matter."""
    world = world_of((0, 0, 2.0), (3.0, 0, 2.0))
    run(world, 60, thrash)
    world.refresh()
    return world, world.characters[1]


def test_the_centre_of_mass_is_the_weighted_mean_of_the_boxes(pair):
    _, body = pair
    plan = original()
    np.testing.assert_allclose(body.com, plan.mass @ body.box_centre / plan.total_mass, atol=1e-12)
    assert body.com_height() == body.com[2]


def test_each_subtree_is_the_part_and_all_that_hangs_on_it(pair):
    _, body = pair
    plan = original()
    for part in range(PART_COUNT):
        below = [p for p in range(PART_COUNT) if is_ancestor(part, p)]
        assert body.subtree_mass[part] == pytest.approx(plan.mass[below].sum())
        np.testing.assert_allclose(body.subtree_com[part], plan.mass[below] @ body.box_centre[below] / plan.mass[below].sum(), atol=1e-12)


def test_the_com_jacobian_is_the_finite_difference_of_the_com(pair):
    world, body = pair
    base, step = world.data.qpos.copy(), 1e-6
    jacobian = body.com_jacobian
    for row in range(48):
        ends = []
        for sign in (1.0, -1.0):
            axis = np.zeros(world.model.nv)
            axis[body.dofs.start + row] = sign
            world.data.qpos[:] = base
            mj.mj_integratePos(world.model, world.data.qpos, axis, step)
            world.refresh()
            ends.append(body.com.copy())
        np.testing.assert_allclose(jacobian[:, row], (ends[0] - ends[1]) / (2 * step), atol=1e-8)


def test_the_com_velocity_is_its_rate_of_change(pair):
    world, body = pair
    velocity, before = body.com_velocity, body.com.copy()
    mj.mj_integratePos(world.model, world.data.qpos, world.data.qvel, 1e-7)
    world.refresh()
    np.testing.assert_allclose((body.com - before) / 1e-7, velocity, atol=1e-5)


def test_the_spin_of_the_root_is_in_world_axes(pair):
    world, body = pair
    before, spin = body.orientation[0].copy(), body.root_spin
    mj.mj_integratePos(world.model, world.data.qpos, world.data.qvel, 1e-7)
    world.refresh()
    turned = rotation.log(rotation.multiply(body.orientation[0], rotation.conjugate(before))) / 1e-7
    np.testing.assert_allclose(turned, spin, atol=1e-5)


def test_the_mass_matrix_holds_the_kinetic_energy(pair):
    world, body = pair
    world.model.opt.enableflags |= mj.mjtEnableBit.mjENBL_ENERGY
    mj.mj_forward(world.model, world.data)
    energy = sum(0.5 * float(b.velocity @ b.mass_matrix @ b.velocity) for b in world.characters)
    assert energy == pytest.approx(world.data.energy[1], rel=1e-9)
    np.testing.assert_allclose(body.mass_matrix, body.mass_matrix.T)


def test_orientations_follow_the_joints(pair):
    _, body = pair
    for part in range(1, PART_COUNT):
        expected = rotation.multiply(body.orientation[PARENT[part]], body.joint_rotation[part - 1])
        np.testing.assert_allclose(np.abs(expected @ body.orientation[part]), 1.0, atol=1e-12)
    np.testing.assert_allclose(rotation.matrix(body.orientation), body.turn, atol=1e-12)


def test_what_control_was_told_does_not_change_under_its_hands(pair):
    world, body = pair
    told = (body.com, body.box_centre, body.orientation, body.subtree_com, body.joint)
    copies = [array.copy() for array in told]
    run(world, 4, thrash)
    for array, copy in zip(told, copies, strict=True):
        np.testing.assert_array_equal(array, copy)


def test_bias_at_rest_is_gravity():
    world = world_of((0, 0, 1.0))
    bias = world.characters[0].bias
    assert bias[2] == pytest.approx(9.81 * original().total_mass)
    assert world.characters[0].gravity == 9.81
