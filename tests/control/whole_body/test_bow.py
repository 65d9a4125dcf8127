"""The bow of a step is farthest out where it is to be, at rest at both ends, and its derivatives are those of its place."""

import numpy as np
import pytest

from game.control.whole_body.bow import NO_BOW, Farthest, bow

OUT = np.array([0.18, -0.07, 0.0])


def turned(farthest):
    yaw = 0.6
    c, s = np.cos(yaw), np.sin(yaw)
    return bow(yaw, c * OUT[0] + s * OUT[1], c * OUT[1] - s * OUT[0], farthest)


@pytest.mark.parametrize("farthest", Farthest)
def test_it_begins_and_ends_at_rest_on_the_straight_way(farthest):
    for end in (0.0, 1.0):
        place, rate, _ = turned(farthest).motion(end)
        np.testing.assert_allclose(place, 0.0, atol=1e-15)
        np.testing.assert_allclose(rate, 0.0, atol=1e-15)


@pytest.mark.parametrize(("farthest", "share"), [(Farthest.EARLY, 0.4), (Farthest.HALF_WAY, 0.5), (Farthest.LATE, 0.6)])
def test_it_is_farthest_out_at_its_time_and_no_farther_than_asked(farthest, share):
    place, rate, _ = turned(farthest).motion(share)
    np.testing.assert_allclose(place, OUT, rtol=1e-12)
    np.testing.assert_allclose(rate, 0.0, atol=1e-12)
    sizes = [np.linalg.norm(turned(farthest).motion(s)[0]) for s in np.linspace(0.0, 1.0, 41)]
    assert max(sizes) <= np.linalg.norm(OUT) * (1.0 + 1e-12)


@pytest.mark.parametrize("farthest", Farthest)
@pytest.mark.parametrize("s", [0.1, 0.45, 0.8])
def test_rate_and_surge_are_the_derivatives_of_the_place(farthest, s):
    h = 1e-5
    before, here, after = (turned(farthest).motion(s + d) for d in (-h, 0.0, h))
    np.testing.assert_allclose((after[0] - before[0]) / (2 * h), here[1], atol=1e-8)
    np.testing.assert_allclose((after[1] - before[1]) / (2 * h), here[2], atol=1e-7)


def test_a_straight_step_has_none():
    assert not any(part.any() for part in NO_BOW.motion(0.3))
