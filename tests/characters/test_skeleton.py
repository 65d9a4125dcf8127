"""The skeleton is a tree of fifteen parts on fourteen ball joints, listed root first."""

from game.characters.skeleton import DOF_COUNT, END_EFFECTOR_PARTS, JOINTS, LEVELS, PARENT, PARTS, is_ancestor


def test_fifteen_parts_hang_on_fourteen_ball_joints_with_48_degrees_of_freedom():
    assert len(PARTS) == len(PARENT) == 15 and len(JOINTS) == 14 and DOF_COUNT == 48


def test_every_part_comes_after_its_parent_and_ends_at_the_pelvis():
    assert PARENT[0] == -1
    for part in range(1, 15):
        assert 0 <= PARENT[part] < part
        assert is_ancestor(0, part) and is_ancestor(part, part) and not is_ancestor(part, 0)


def test_parts_are_listed_depth_first_as_mujoco_numbers_its_bodies():
    def walk(part: int) -> list[int]:
        return [part, *(below for child in range(15) if PARENT[child] == part for below in walk(child))]

    assert walk(0) == list(range(15))


def test_the_levels_hold_every_part_but_the_root_once_each_after_its_parent():
    placed = {0}
    for parts, parents in LEVELS:
        assert set(parents.tolist()) <= placed
        assert [PARENT[p] for p in parts] == parents.tolist()
        assert placed.isdisjoint(parts.tolist())
        placed |= set(parts.tolist())
    assert placed == set(range(15))


def test_the_end_effectors_are_ankles_wrists_and_neck():
    assert [PARTS[part] for part in END_EFFECTOR_PARTS] == ["foot_left", "foot_right", "hand_left", "hand_right", "head"]


def test_a_leg_carries_its_own_foot_only():
    assert is_ancestor(PARTS.index("upper_leg_left"), PARTS.index("foot_left"))
    assert not is_ancestor(PARTS.index("upper_leg_left"), PARTS.index("foot_right"))
    assert not is_ancestor(PARTS.index("trunk"), PARTS.index("foot_left"))
