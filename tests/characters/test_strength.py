"""How strong the joints are: whose muscle turns which way, left like right, and the sums that the sources promise."""

from dataclasses import replace

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import BUILT_IN, load_body_plan
from game.characters.skeleton import JOINTS
from game.characters.strength import PER_KG, joint_strength
from game.target.forward_kinematics import pose_skeleton
from tests.physics.standing import bent, original

FORWARD, LEFT, UP = range(3)


def of(joint, axis, plan=None):
    """(low, high) N m of one axis."""
    low, high = joint_strength(plan or original())
    return low[3 * JOINTS.index(joint) + axis], high[3 * JOINTS.index(joint) + axis]


def place(part, **angles):
    """(3,) of the joint centre of `part` of a body bent so, against the idle body."""
    plan = original()
    idle = pose_skeleton(plan, plan.joint[0], np.array(rotation.IDENTITY), bent())
    posed = pose_skeleton(plan, plan.joint[0], np.array(rotation.IDENTITY), bent(**angles))
    return posed.joint[part] - idle.joint[part]


@pytest.mark.parametrize("name", BUILT_IN)
def test_every_axis_can_push_both_ways(name):
    low, high = joint_strength(load_body_plan(name))
    assert low.shape == high.shape == (42,)
    assert np.all(low < 0.0) and np.all(high > 0.0)


def test_twice_the_body_is_twice_as_strong():
    low, high = joint_strength(original())
    heavy = joint_strength(replace(original(), mass=2.0 * original().mass))
    np.testing.assert_allclose(heavy, (2.0 * low, 2.0 * high))


def test_knees_and_hips_are_as_strong_as_anderson_measured():
    """Share of body weight times a height of 1.8 m."""
    weight_m = original().total_mass * 9.81 * 1.8
    assert of("knee_left", LEFT) == pytest.approx((-0.163 * weight_m, 0.087 * weight_m))
    assert of("hip_left", LEFT) == pytest.approx((-0.113 * weight_m, 0.161 * weight_m))
    assert of("ankle_left", LEFT) == pytest.approx((-0.033 * weight_m, 0.095 * weight_m))


def test_the_stronger_muscle_is_on_the_side_it_is_in_a_human():
    foot, hand = 11, 5
    assert place(foot, knee_left=(0.0, 0.5, 0.0))[0] < 0.0, "plus bends the knee"
    assert -of("knee_left", LEFT)[0] > of("knee_left", LEFT)[1], "and straightening is stronger"
    assert place(10, hip_left=(0.0, -0.5, 0.0))[0] > 0.0, "minus swings the thigh forward"
    assert of("hip_left", LEFT)[1] > -of("hip_left", LEFT)[0], "and swinging it back is stronger"
    assert place(2, spine=(0.0, 0.5, 0.0))[0] > 0.0, "plus bows"
    assert -of("spine", LEFT)[0] > of("spine", LEFT)[1], "and straightening up is stronger"
    assert place(hand, shoulder_left=(0.5, 0.0, 0.0))[1] > 0.0, "plus spreads the left arm"
    assert -of("shoulder_left", FORWARD)[0] > of("shoulder_left", FORWARD)[1], "and drawing it in is stronger"


def test_left_and_right_mirror_each_other():
    for joint in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle"):
        for axis, swapped in ((FORWARD, True), (LEFT, False), (UP, True)):
            low, high = of(f"{joint}_left", axis)
            assert of(f"{joint}_right", axis) == ((-high, -low) if swapped else (low, high))


def test_every_joint_has_its_numbers():
    assert set(PER_KG) == {joint.split("_")[0] for joint in JOINTS}
