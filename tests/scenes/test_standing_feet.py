"""Feet of a person who stands: flat in the target, flat in the hang, however the sensor sees them."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import ANKLES, FEET
from game.physics.hang import SOLE_CLEARANCE_M, hanging_root, level_feet
from game.scenes.simulation import HANG_FRAMES
from game.target.calibration import calibrate
from game.target.forward_kinematics import pose_skeleton
from game.target.mapping import map_orientations
from game.tunables import Settings
from kinect.body import Joint
from tests.inputs.performer_ground import performed
from tests.physics.standing import bent
from tests.scenes.test_simulation import WAVING, advance, simulation_of


@pytest.mark.parametrize("drop_m", [0.0, 0.08, 0.3])
def test_a_standing_person_s_feet_are_flat_in_the_target_however_far_the_toes_seem_below_the_ankle(drop_m):
    joints = performed("standing")[1][:1].copy()
    joints[:, [Joint.FOOT_LEFT, Joint.FOOT_RIGHT], 2] -= drop_m
    _, local = map_orientations(joints[0], calibrate(load_body_plan("original"), joints))
    np.testing.assert_allclose(rotation.log(local[list(ANKLES)]), 0.0, atol=0.05)


def test_a_body_that_is_hung_up_has_level_feet_two_centimetres_above_the_floor():
    plan = load_body_plan("original")
    joints = bent(hip_left=(0.0, -0.3, 0.1), knee_left=(0.0, 0.5, 0.0), ankle_left=(0.0, 1.2, 0.3), ankle_right=(0.2, 0.9, 0.0))
    position, orientation = hanging_root(plan, np.zeros(2), rotation.about_z(0.4), joints)
    pose = pose_skeleton(plan, position, orientation, level_feet(plan, orientation, joints))
    np.testing.assert_allclose(pose.turn[list(FEET)][:, 2], [[0.0, 0.0, 1.0]] * 2, atol=1e-9)
    soles = pose.box_centres(plan)[list(FEET), 2] - 0.5 * plan.size[list(FEET), 2]
    assert soles.min() == pytest.approx(SOLE_CLEARANCE_M, abs=1e-9)


def test_nothing_touches_the_floor_while_it_hangs():
    simulation = simulation_of(WAVING)
    for _ in range(HANG_FRAMES):
        assert simulation.world.data.ncon == 0
        simulation.advance()


def test_without_balance_a_standing_body_is_not_thrown_into_the_air():
    """Ankles that track feet seen at a slant press the toes down and the body up."""
    simulation = advance(simulation_of("performer:standing", settings=Settings({"balance.strategy": "none"})), HANG_FRAMES)
    highest = 0.0
    for _ in range(60):
        simulation.advance()
        highest = max(highest, simulation.world.characters[0].com_height())
    assert highest < 1.03 * load_body_plan("original").idle_com_height
