"""Loads of the feet, the force between two bodies and the use of torques, from numbers that can be checked by hand."""

import numpy as np
import pytest

from game.characters.skeleton import FEET, PART_COUNT, PARTS
from game.physics.contacts import ContactForces
from game.scenes.duel_plots import force_between
from game.scenes.foot_loads import ground_loads
from game.scenes.torque_use import MOST_SHOWN, note_torques

FIRST = 1 + PART_COUNT
"""MuJoCo id of the second character's root."""

LEFT, RIGHT, HAND = FIRST + FEET[0], FIRST + FEET[1], FIRST + PARTS.index("hand_left")


def contacts(*rows: tuple[tuple[int, int], tuple[float, float, float], float]) -> ContactForces:
    """Each row: the partners' ids, the point, and the vertical force on the second partner."""
    body = np.array([partners for partners, _, _ in rows])
    point = np.array([place for _, place, _ in rows])
    force = np.array([[0.0, 0.0, lift] for _, _, lift in rows])
    return ContactForces(point, force, np.zeros((len(rows), 6)), np.ones(len(rows)), body)


def test_each_foot_gets_what_the_floor_gives_it_whichever_partner_comes_first() -> None:
    found = contacts(((0, LEFT), (0.1, 0.2, 0.0), 300.0), ((RIGHT, 0), (0.3, -0.2, 0.0), -100.0))
    left, right, whole, x, y = ground_loads(found, FIRST)
    assert (left, right, whole) == (300.0, 100.0, 400.0)
    assert (x, y) == pytest.approx((0.15, 0.1)), "the centre of pressure is nearer to the foot that bears more"


def test_a_hand_on_the_floor_bears_but_is_no_foot() -> None:
    left, right, whole, x, _ = ground_loads(contacts(((0, HAND), (0.5, 0.0, 0.0), 50.0), ((0, LEFT), (0.0, 0.0, 0.0), 50.0)), FIRST)
    assert (left, right, whole, x) == (50.0, 0.0, 100.0, 0.25)


def test_what_others_stand_on_and_what_two_do_to_each_other_is_no_load() -> None:
    others_foot = 1 + FEET[0]
    assert ground_loads(contacts(((0, others_foot), (0.0, 0.0, 0.0), 700.0), ((others_foot, LEFT), (0.0, 0.0, 0.0), 40.0)), FIRST)[2] == 0.0


def test_in_flight_there_is_no_load_and_no_centre_of_pressure() -> None:
    loads = ground_loads(None, FIRST)
    assert loads[:3].tolist() == [0.0, 0.0, 0.0] and np.isnan(loads[3:]).all()


def test_forces_between_two_add_up_as_on_the_second_of_them() -> None:
    rows = contacts(
        ((1, HAND), (0.0, 0.0, 1.0), 30.0),
        ((HAND, 2), (0.0, 0.0, 1.0), -12.0),
        ((0, LEFT), (0.0, 0.0, 0.0), 800.0),
        ((1, 3), (0.0, 0.0, 1.0), 9.0),
    )
    assert force_between(rows.force, rows.body) == pytest.approx(42.0)


def test_a_joint_uses_the_share_of_its_hardest_axis_in_the_direction_it_turns() -> None:
    torque = np.array([10.0, -10.0, 0.0, 5.0, 0.0, 0.0])
    low, high = np.array([-20.0, -40.0, -1.0, -1.0, -1.0, -1.0]), np.array([20.0, 11.0, 1.0, 50.0, 1.0, 1.0])
    use, most = np.empty(2), np.array([0.9, 0.0])
    assert note_torques(torque, low, high, use, most) == 10.0
    assert use == pytest.approx([0.5, 0.1])
    assert most == pytest.approx([0.9, 0.1]), "the most of late stays until it is exceeded"


def test_a_joint_without_strength_left_uses_a_share_that_can_still_be_drawn() -> None:
    use, most = np.empty(1), np.zeros(1)
    note_torques(np.array([3.0, 0.0, 0.0]), np.zeros(3), np.zeros(3), use, most)
    assert use[0] == most[0] == MOST_SHOWN
