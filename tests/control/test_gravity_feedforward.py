"""Gravity's joint torques against inverse dynamics and against the simulation."""

from dataclasses import replace

import mujoco as mj
import numpy as np
import pytest

from game.characters.skeleton import ANKLES, FEET, JOINTS
from game.control.gravity_feedforward import gravity_torque
from tests.physics.standing import bent, hold, original, run, thrash, world_of

ANKLE_ROWS = np.concatenate([np.arange(3 * a, 3 * a + 3) for a in ANKLES])
POSES = {
    "idle": bent(),
    "arms out, trunk bent": bent(shoulder_left=(-1.5, 0, 0), shoulder_right=(0, -1.5, 0), spine=(0.1, 0.3, 0.2), elbow_left=(0, -0.8, 0)),
    "crouched": bent(hip_left=(0, -0.8, 0), knee_left=(0, 1.5, 0), hip_right=(0.1, -0.7, 0.2), knee_right=(0, 1.4, 0), spine=(0, 0.5, 0)),
}


@pytest.mark.parametrize("joints", POSES.values(), ids=POSES.keys())
@pytest.mark.parametrize("left_share", [0.0, 0.3, 0.5, 1.0])
def test_it_is_the_inverse_dynamics_of_rest_with_the_weight_on_the_feet(joints, left_share):
    """At rest: torque = c(q) - J^T f on every joint but the ankles, f the weight shared by the middles of the feet."""
    world = world_of((0, 0, 0), joints=joints)
    body = world.characters[0]
    weight = float(body.subtree_mass[0]) * body.gravity
    needed = body.bias
    jacobian = np.zeros((3, world.model.nv))
    for foot, share in zip(FEET, (left_share, 1.0 - left_share), strict=True):
        mj.mj_jac(world.model, world.data, jacobian, None, body.box_centre[foot], body.root_body + foot)
        needed -= jacobian.T @ [0.0, 0.0, share * weight]
    torque = gravity_torque(body, left_share)
    others = np.delete(np.arange(42), ANKLE_ROWS)
    np.testing.assert_allclose(torque[others], needed[6:][others], atol=1e-9)
    assert not torque[ANKLE_ROWS].any()


def test_in_the_second_character_it_is_the_same_turned_about():
    world = world_of((0, 0, 0), (2, 1, 0), joints=POSES["arms out, trunk bent"])
    np.testing.assert_allclose(gravity_torque(world.characters[0], 0.4), gravity_torque(world.characters[1], 0.4), atol=1e-9)


def test_joints_held_by_it_alone_do_not_begin_to_move():
    """Standing over the middle of the feet, stiffness next to nothing: from rest only the ankles accelerate."""
    # the idle COM is 49 mm behind the middle of the feet, so the foot boxes are moved back under it
    plan = original()
    centre = plan.centre.copy()
    for foot in FEET:
        centre[foot, 0] = 0.0
    com = float(plan.mass @ centre[:, 0]) / plan.total_mass
    centre[list(FEET), 0] = com / (1.0 - 9.0 / plan.total_mass)
    balanced = replace(plan, centre=centre)
    world = world_of((0, 0, -0.0005), plan=balanced)
    body = world.characters[0]
    assert body.com[0] == pytest.approx(body.box_centre[FEET[0], 0], abs=1e-9)
    torque = gravity_torque(body, 0.5)

    def drop_after(feedforward: np.ndarray) -> float:
        world = world_of((0, 0, -0.0005), plan=balanced)

        def command(body, _step):
            stiff = hold(body)
            kp, kd = np.full(42, 1e-9), np.full(42, 1e-9)
            kp[ANKLE_ROWS], kd[ANKLE_ROWS] = stiff.kp[ANKLE_ROWS], stiff.kd[ANKLE_ROWS]
            return replace(stiff, kp=kp, kd=kd, feedforward=feedforward)

        states = run(world, 96, command)
        return float(np.abs(states[-1, 63 + 6 :]).max())

    with_it, without = drop_after(torque), drop_after(np.zeros(42))
    assert without > 0.02, "the body was to need it"
    assert with_it < 0.1 * without


def test_the_sag_of_a_pd_law_goes_when_it_is_added():
    arms = bent(shoulder_left=(0, -1.2, 0), shoulder_right=(0, -1.2, 0))
    shoulder = 3 * JOINTS.index("shoulder_left") + 1

    def sag(with_gravity: bool) -> float:
        world = world_of((0, 0, 0))

        def command(body, _step):
            held = hold(body, arms)
            return held if with_gravity else replace(held, feedforward=np.zeros(42))

        run(world, 960, command)
        return abs(float(world.actuation._error[6 + shoulder]))

    assert sag(True) < 0.3 * sag(False)


def test_it_acts_between_parts_only():
    world = world_of((0, 0, 2.0))
    run(world, 24, thrash)
    assert not world.actuation.torque[:6].any()
