"""What a body feels of a push, told by its COM and the forces that were planned for the floor."""

import math

import numpy as np
import pytest

from game.control.whole_body.felt_push import MEMORY_S, NOW_S, THROWN_M_S, UNFELT_M_S, FeltPush

DT, MASS_KG = 1.0 / 240.0, 70.0


def moved(felt: FeltPush, floor_n, push_n, seconds: float) -> FeltPush:
    """Two feet that share the floor's force (2,) N, and somebody who pushes with (2,) N besides; velocity goes on from rest."""
    force = np.asarray(floor_n, dtype=float) + push_n
    wrench = np.tile([0.5 * floor_n[0], 0.5 * floor_n[1], 400.0, 3.0, -5.0, 1.0], 2)
    for k in range(round(seconds / DT) + 1):
        felt.feel(np.array([*(k * DT * force / MASS_KG), 0.0]), wrench, MASS_KG, DT)
    return felt


def test_what_the_floor_was_asked_for_is_no_push():
    felt = moved(FeltPush(), (300.0, -120.0), (0.0, 0.0), 0.5)
    assert felt.speed == pytest.approx(0.0, abs=1e-9) and not felt.thrown


@pytest.mark.parametrize("floor_n", [(0.0, 0.0), (-200.0, 50.0)])
def test_a_push_is_felt_as_the_speed_it_gives_whatever_the_floor_does_meanwhile(floor_n):
    felt = moved(FeltPush(), floor_n, (0.0, 250.0), 0.2)
    # 250 N for 0.2 s, faded with the time constant that is as long
    assert felt.speed == pytest.approx(250.0 * MEMORY_S * (1.0 - math.exp(-1.0)) / MASS_KG, rel=0.03)
    assert felt.thrown


def test_a_push_is_forgotten():
    felt = moved(FeltPush(), (0.0, 0.0), (300.0, 0.0), 0.2)
    after, still = felt.speed, np.array([300.0 * 0.2 / MASS_KG, 0.0, 0.0])
    for _ in range(round(3.0 * MEMORY_S / DT)):
        felt.feel(still, np.zeros(0), MASS_KG, DT)
    assert felt.speed == pytest.approx(after * math.exp(-3.0), rel=0.05) and felt.speed < THROWN_M_S


def test_what_pushes_now_is_told_soon_and_forgotten_soon():
    felt = moved(FeltPush(), (40.0, 0.0), (300.0, 0.0), 3.0 * NOW_S)
    least, most = 300.0 * (1.0 - math.exp(-3.0)) / MASS_KG - UNFELT_M_S / NOW_S, 300.0 / MASS_KG
    assert least * 0.9 < felt.acceleration[0] < most and felt.acceleration[1] == pytest.approx(0.0, abs=1e-9)
    there = np.array([340.0 * 3.0 * NOW_S / MASS_KG, 0.0, 0.0])
    for _ in range(round(6.0 * NOW_S / DT)):
        felt.feel(there, np.zeros(0), MASS_KG, DT)
    assert not felt.acceleration.any()


def test_a_motion_of_the_bodys_own_pushes_nobody():
    """What the floor does differently from the plan for a moment stays below what counts."""
    assert not moved(FeltPush(), (200.0, 0.0), (60.0, 0.0), 0.1).acceleration.any()


def test_it_knows_how_long_ago_it_was_thrown():
    felt = FeltPush()
    assert felt.thrown_s > 1.0
    moved(felt, (0.0, 0.0), (300.0, 0.0), 0.2)
    assert felt.thrown_s == 0.0
    still = np.array([300.0 * 0.2 / MASS_KG, 0.0, 0.0])
    for _ in range(round(1.0 / DT)):
        felt.feel(still, np.zeros(0), MASS_KG, DT)
    assert 0.5 < felt.thrown_s < 1.0


def test_a_light_touch_throws_nobody():
    assert not moved(FeltPush(), (0.0, 0.0), (50.0, 0.0), 0.2).thrown
