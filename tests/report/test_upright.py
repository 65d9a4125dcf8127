"""Upright time by the strict rule: it ends at the first violation and never resumes (thesis 4.4)."""

import math

import numpy as np
import pytest

from game.report.upright import UprightClock


def watched(heights: list[float], target: float = 1.0) -> UprightClock:
    """A clock that saw one height every tenth of a second from 0.1 s on, over a character who stands at 1 m."""
    clock = UprightClock(1.0)
    for k, height in enumerate(heights):
        clock.observe(0.1 * (k + 1), height, target)
    return clock


def test_a_character_that_keeps_its_height_is_upright_to_the_end():
    clock = watched([1.0] * 20)
    assert clock.upright and clock.fell_at_s is None
    assert clock.upright_s == pytest.approx(2.0)


def test_standing_up_again_does_not_start_the_clock_again():
    clock = watched([1.0] * 4 + [0.5] + [1.0] * 20)
    assert not clock.upright
    assert clock.fell_at_s == pytest.approx(0.5)
    assert clock.upright_s == pytest.approx(0.4)


@pytest.mark.parametrize(("share", "upright"), [(0.8, True), (0.8001, True), (0.7999, False), (2.0, True), (math.nan, False)])
def test_eighty_percent_of_the_targets_height_is_just_enough(share, upright):
    assert watched([share]).upright is upright


def test_a_crouching_target_lets_the_character_crouch():
    assert watched([0.5], target=0.6).upright
    assert not watched([0.5], target=1.0).upright


def test_a_character_that_falls_at_once_was_never_upright():
    clock = watched([0.1, 1.0])
    assert clock.upright_s == 0.0 and clock.fell_at_s == pytest.approx(0.1)


def test_a_target_that_no_person_could_be_is_counted_as_the_targets_fault_before_and_after_the_fall():
    clock = UprightClock(0.93)
    for k, share in enumerate([0.34, 0.35001, 1.0, 1.2499, 1.26, math.nan]):
        clock.observe(float(k), 0.93, 0.93 * share)
    assert clock.target_fault_frames == 3


def test_the_time_only_ever_grows_until_the_fall():
    rng = np.random.default_rng(3)
    clock, last = UprightClock(1.0), 0.0
    for k in range(200):
        clock.observe((k + 1) / 60.0, rng.uniform(0.795, 1.1), 1.0)
        assert clock.upright_s >= last
        assert clock.fell_at_s is None or clock.upright_s < clock.fell_at_s
        last = clock.upright_s
    assert clock.fell_at_s is not None
