"""The bow of a step is farthest out where it is to be, at rest at both ends, and its derivatives are those of its place."""

import numpy as np
import pytest

from game.control.whole_body.bow import STRAIGHT, bow

OUT = np.array([0.18, -0.07, 0.0])


def turned(late):
    yaw = 0.6
    c, s = np.cos(yaw), np.sin(yaw)
    return bow(yaw, c * OUT[0] + s * OUT[1], c * OUT[1] - s * OUT[0], late)


@pytest.mark.parametrize("late", [False, True])
def test_it_begins_and_ends_at_rest_on_the_straight_way(late):
    for end in (0.0, 1.0):
        place, rate, _ = turned(late).motion(end)
        np.testing.assert_allclose(place, 0.0, atol=1e-15)
        np.testing.assert_allclose(rate, 0.0, atol=1e-15)


@pytest.mark.parametrize(("late", "farthest"), [(False, 0.5), (True, 0.6)])
def test_it_is_farthest_out_at_its_time_and_no_farther_than_asked(late, farthest):
    place, rate, _ = turned(late).motion(farthest)
    np.testing.assert_allclose(place, OUT, rtol=1e-12)
    np.testing.assert_allclose(rate, 0.0, atol=1e-12)
    sizes = [np.linalg.norm(turned(late).motion(s)[0]) for s in np.linspace(0.0, 1.0, 41)]
    assert max(sizes) <= np.linalg.norm(OUT) * (1.0 + 1e-12)


@pytest.mark.parametrize("late", [False, True])
@pytest.mark.parametrize("s", [0.1, 0.45, 0.8])
def test_rate_and_surge_are_the_derivatives_of_the_place(late, s):
    h = 1e-5
    before, here, after = (turned(late).motion(s + d) for d in (-h, 0.0, h))
    np.testing.assert_allclose((after[0] - before[0]) / (2 * h), here[1], atol=1e-8)
    np.testing.assert_allclose((after[1] - before[1]) / (2 * h), here[2], atol=1e-7)


def test_a_straight_step_has_none():
    assert not any(part.any() for part in STRAIGHT.motion(0.3))
