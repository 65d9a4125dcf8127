"""Gains by Eq. 3.8, reckoned by hand on the idle original character."""

import numpy as np
import pytest

from game.characters.body_plan import load_body_plan
from game.characters.skeleton import JOINTS
from game.control.gains import LEAST_RADIUS_SHARE, MANUAL_RATIO, T0_KG_M, dynamic_ratio, gains
from tests.physics.standing import bent, hold, run, world_of

ARM = {"upper": (4.198, 1.350), "lower": (2.797, 1.050), "hand": (1.200, 0.825)}
HEAD_KG, HEAD = 5.904, (0.01, 1.680)
LEG_KG, TOTAL_KG = {"upper": 9.799, "lower": 4.800, "foot": 4.500}, 94.536


@pytest.fixture(scope="module")
def idle():
    return world_of((0, 0, 0)).characters[0]


def ratio_of(body, joint: str, axis: str) -> float:
    return float(dynamic_ratio(body).reshape(14, 3)[JOINTS.index(joint), "xyz".index(axis)])


def test_the_spine_s_first_axis_is_the_unit():
    """t_0 = r_c m_c: trunk, head and arms on the spine's x axis; their centre is 20-30 cm above the joint."""
    mass = 23.805 + HEAD_KG + 2 * sum(kg for kg, _ in ARM.values())
    height = (23.805 * 1.310 + HEAD_KG * HEAD[1] + 2 * sum(kg * z for kg, z in ARM.values())) / mass - 1.090
    assert mass * height == pytest.approx(T0_KG_M, rel=0.01)


def test_the_spine(idle):
    mass = 23.805 + HEAD_KG + 2 * sum(kg for kg, _ in ARM.values())
    height = (23.805 * 1.310 + HEAD_KG * HEAD[1] + 2 * sum(kg * z for kg, z in ARM.values())) / mass - 1.090
    ahead = HEAD_KG * HEAD[0] / mass
    assert ratio_of(idle, "spine", "x") == pytest.approx(mass * height / T0_KG_M)
    assert ratio_of(idle, "spine", "y") == pytest.approx(mass * np.hypot(height, ahead) / T0_KG_M)
    assert ratio_of(idle, "spine", "z") == pytest.approx(LEAST_RADIUS_SHARE * mass * np.hypot(height, ahead) / T0_KG_M), "the floor"


def test_the_neck(idle):
    assert ratio_of(idle, "neck", "x") == pytest.approx(HEAD_KG * (1.680 - 1.530) / T0_KG_M)
    assert ratio_of(idle, "neck", "y") == pytest.approx(HEAD_KG * np.hypot(0.15, 0.01) / T0_KG_M)


def test_the_shoulder_moves_the_whole_arm(idle):
    moment = sum(kg * (1.470 - z) for kg, z in ARM.values())
    assert ratio_of(idle, "shoulder_left", "x") == pytest.approx(moment / T0_KG_M)
    assert ratio_of(idle, "shoulder_right", "y") == pytest.approx(moment / T0_KG_M)


def test_the_ankle_moves_all_the_rest_of_the_body(idle):
    """All parts but the one foot, about the ankle at (0, 0.095, 0.080)."""
    plan = load_body_plan("original")
    foot = 11
    rest = np.delete(np.arange(15), foot)
    mass = plan.mass[rest].sum()
    arm = plan.mass[rest] @ plan.centre[rest] / mass - [0.0, 0.095, 0.080]
    assert mass == pytest.approx(TOTAL_KG - LEG_KG["foot"], abs=0.01)
    assert ratio_of(idle, "ankle_left", "x") == pytest.approx(mass * np.hypot(arm[1], arm[2]) / T0_KG_M)
    assert ratio_of(idle, "ankle_left", "y") == pytest.approx(mass * np.hypot(arm[0], arm[2]) / T0_KG_M)
    assert 7.5 < ratio_of(idle, "ankle_left", "x") < 9.0


def test_left_and_right_are_alike_when_standing(idle):
    table: dict[str, np.ndarray] = dict(zip(JOINTS, dynamic_ratio(idle).reshape(14, 3), strict=True))
    for joint in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle"):
        np.testing.assert_allclose(table[f"{joint}_left"], table[f"{joint}_right"], rtol=1e-9)


def test_no_axis_is_without_stiffness(idle):
    assert (dynamic_ratio(idle) > 0.0).all()


def test_gains_follow_stiffness_and_ratio(idle):
    for name, ratio in (("dynamic", dynamic_ratio(idle)), ("manual", MANUAL_RATIO)):
        kp, kd = gains(idle, 640.0, name)
        np.testing.assert_allclose(kp, 640.0 * ratio)
        np.testing.assert_allclose(kd, 2.0 * np.sqrt(kp))


def test_manual_ratios_are_the_standing_ones_within_a_fifth_and_do_not_follow_the_pose(idle):
    """They were set to the standing body: the large axes agree with the dynamic ratio there."""
    dynamic = dynamic_ratio(idle).reshape(14, 3)[:, :2]
    manual = MANUAL_RATIO.reshape(14, 3)[:, :2]
    away_from_hips = [j for j, name in enumerate(JOINTS) if not name.startswith("hip")]
    np.testing.assert_allclose(manual[away_from_hips], dynamic[away_from_hips], rtol=0.35)
    np.testing.assert_array_equal(gains(idle, 100.0, "manual")[0], 100.0 * MANUAL_RATIO)


def test_a_raised_arm_is_stiffer_where_it_has_the_longer_lever():
    world = world_of((0, 0, 0))
    run(world, 240, lambda body, _: hold(body, bent(shoulder_left=(-1.5, 0.0, 0.0), shoulder_right=(1.5, 0.0, 0.0))))
    world.refresh()
    idle = world_of((0, 0, 0)).characters[0]
    assert ratio_of(world.characters[0], "spine", "x") > 1.1 * ratio_of(idle, "spine", "x")
