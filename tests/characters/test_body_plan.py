"""The characters weigh and measure what the thesis says, and stand on the floor without cutting into themselves."""

from itertools import combinations

import numpy as np
import pytest

from game.characters.body_plan import BUILT_IN, BodyPlan, load_body_plan
from game.characters.skeleton import PARENT, PARTS

SIDED = ("upper_arm", "lower_arm", "hand", "upper_leg", "lower_leg", "foot")
# thesis Table 2, percent of the whole; the trunk's share is that of pelvis and trunk together
SIMULATED = {
    "head": 6.24,
    "trunk": 36.00,
    "upper_arm": 4.44,
    "lower_arm": 2.96,
    "hand": 1.27,
    "upper_leg": 10.37,
    "lower_leg": 5.08,
    "foot": 4.76,
}
HUMAN = {"head": 7.3, "trunk": 50.7, "upper_arm": 2.6, "lower_arm": 1.6, "hand": 0.7, "upper_leg": 10.3, "lower_leg": 4.3, "foot": 1.5}


def mass(plan: BodyPlan, part: str) -> float:
    return float(plan.mass[PARTS.index(part)])


def shares(plan: BodyPlan) -> dict[str, float]:
    """Percent of the whole by Table 2's rows, pelvis and trunk together, limbs by their left side."""
    rows = {"head": mass(plan, "head"), "trunk": mass(plan, "pelvis") + mass(plan, "trunk")}
    rows |= {part: mass(plan, f"{part}_left") for part in SIDED}
    return {row: 100.0 * kg / plan.total_mass for row, kg in rows.items()}


def overlapping(plan: BodyPlan) -> set[tuple[str, str]]:
    """Pairs of parts whose boxes share volume when standing idle."""
    low, high = plan.centre - 0.5 * plan.size, plan.centre + 0.5 * plan.size
    return {
        (PARTS[a], PARTS[b])
        for a, b in combinations(range(15), 2)
        if np.all(np.minimum(high[a], high[b]) - np.maximum(low[a], low[b]) > 1e-9)
    }


def test_the_thesis_character_weighs_94_5_kg_and_is_1_80_m_tall_with_its_com_at_0_93_m():
    plan = load_body_plan("original")
    assert plan.total_mass == pytest.approx(94.54, abs=0.01)
    assert (plan.centre[:, 2] + 0.5 * plan.size[:, 2]).max() == pytest.approx(1.80)
    assert (plan.centre[:, 2] - 0.5 * plan.size[:, 2]).min() == pytest.approx(0.0, abs=1e-9)
    assert plan.idle_com_height == pytest.approx(0.93, abs=0.005)


def test_the_thesis_character_has_the_shares_of_table_2():
    assert shares(load_body_plan("original")) == pytest.approx(SIMULATED, abs=0.02)


@pytest.mark.parametrize("name", ["original", "human-boxes"])
def test_boxes_have_the_density_of_water(name):
    plan = load_body_plan(name)
    np.testing.assert_allclose(plan.mass / plan.size.prod(axis=1), 1000.0, rtol=0.003)


@pytest.mark.parametrize("name", ["human", "human-boxes"])
def test_the_human_characters_have_the_human_shares_of_table_2(name):
    plan = load_body_plan(name)
    assert plan.total_mass == pytest.approx(94.5, abs=0.001)
    assert shares(plan) == pytest.approx(HUMAN, abs=0.001)
    assert mass(plan, "pelvis") / (mass(plan, "pelvis") + mass(plan, "trunk")) == pytest.approx(0.3, abs=1e-4)


def test_human_has_the_original_boxes_and_human_boxes_keeps_their_lengths():
    original, human, boxes = (load_body_plan(name) for name in ("original", "human", "human-boxes"))
    np.testing.assert_array_equal(human.size, original.size)
    np.testing.assert_array_equal(human.centre, original.centre)
    along = np.array([0 if part.startswith("foot") else 2 for part in PARTS])
    np.testing.assert_allclose(boxes.size[range(15), along], original.size[range(15), along])


def test_low_com_has_lower_legs_of_19_2_kg_and_a_lower_centre_of_mass():
    original, low = load_body_plan("original"), load_body_plan("low-com")
    changed = {part for part in PARTS if mass(low, part) != mass(original, part)}
    assert changed == {"lower_leg_left", "lower_leg_right"}
    assert mass(low, "lower_leg_left") == mass(low, "lower_leg_right") == pytest.approx(19.2)
    assert low.idle_com_height < original.idle_com_height - 0.1


def test_asymmetric_has_one_forearm_of_11_2_kg():
    original, odd = load_body_plan("original"), load_body_plan("asymmetric")
    assert [part for part in PARTS if mass(odd, part) != mass(original, part)] == ["lower_arm_right"]
    assert mass(odd, "lower_arm_right") == pytest.approx(11.2, abs=0.02)


@pytest.mark.parametrize("name", ["original", "human"])
def test_idle_boxes_overlap_only_with_the_neighbour_at_their_joint(name):
    neighbours = {(PARTS[min(i, p)], PARTS[max(i, p)]) for i, p in enumerate(PARENT) if p >= 0}
    assert overlapping(load_body_plan(name)) <= neighbours


@pytest.mark.parametrize("name", BUILT_IN)
def test_every_character_stands_idle_with_its_two_sides_alike_but_for_what_it_says(name):
    plan = load_body_plan(name)
    assert plan.name == name and plan.about
    for part in SIDED:
        left, right = PARTS.index(f"{part}_left"), PARTS.index(f"{part}_right")
        np.testing.assert_array_equal(plan.joint[right], plan.joint[left] * [1.0, -1.0, 1.0])
        np.testing.assert_array_equal(plan.centre[right], plan.centre[left] * [1.0, -1.0, 1.0])
        if (name, part) != ("asymmetric", "lower_arm"):
            assert plan.mass[left] == plan.mass[right]
            np.testing.assert_array_equal(plan.size[left], plan.size[right])


@pytest.mark.parametrize("name", BUILT_IN)
def test_offsets_add_up_to_the_idle_places(name):
    plan = load_body_plan(name)
    place = np.zeros((15, 3))
    for part, parent in enumerate(PARENT):
        place[part] = plan.joint[0] if parent < 0 else place[parent] + plan.joint_offset[part]
    np.testing.assert_allclose(place, plan.joint, atol=1e-12)
    np.testing.assert_allclose(place + plan.centre_offset, plan.centre, atol=1e-12)
    np.testing.assert_array_equal(plan.joint_offset[0], 0.0)
