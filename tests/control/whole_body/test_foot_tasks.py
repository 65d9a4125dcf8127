"""What a standing foot is asked for."""

import numpy as np
import pytest

from game.control.whole_body.foot_tasks import EDGE_RAD, RISE_M_S, STANCE_WEIGHT, stance
from game.rotation import exp, matrix


def asked(tilt_rad: float, touches: bool = True, rises_m_s: float = 0.0):
    """(weight, goal) (6,) each of a foot that has stood for a while, tilted about x, at rest or rising."""
    weight, goal, twist = np.empty(6), np.empty(6), np.zeros(6)
    twist[2] = rises_m_s
    stance(twist, matrix(exp(np.array([tilt_rad, 0.0, 0.0]))), 0.0, touches, 1.0, weight, goal)
    return weight, goal


def test_a_flat_sole_is_asked_to_stay_so_with_all_weight():
    weight, goal = asked(0.0)
    np.testing.assert_array_equal(weight, STANCE_WEIGHT)
    np.testing.assert_array_equal(goal, 0.0)


def test_a_sole_on_its_edge_keeps_its_place_and_is_asked_less_to_lie_flat():
    """Its ankle can do no more: what the plan counts on there does not come."""
    weight, goal = asked(EDGE_RAD)
    np.testing.assert_array_equal(weight[[0, 1, 2, 5]], STANCE_WEIGHT)
    assert weight[3] == weight[4] == pytest.approx(0.5 * STANCE_WEIGHT, rel=1e-2)
    assert goal[3] < 0.0, "back to flat"
    shares = [asked(tilt)[0][3] for tilt in np.linspace(0.0, 0.4, 9)]
    assert np.all(np.diff(shares) < 0.0) and shares[-1] < 1e-3 * STANCE_WEIGHT


def test_a_sole_that_its_leg_lifts_off_the_floor_is_asked_less_to_stay_down():
    """The leg is at its end: to keep that foot down, the whole body would have to fall with it."""
    weight, goal = asked(0.0, rises_m_s=RISE_M_S)
    np.testing.assert_array_equal(weight[[0, 1, 3, 4, 5]], STANCE_WEIGHT)
    assert weight[2] == pytest.approx(0.5 * STANCE_WEIGHT)
    assert goal[2] < 0.0, "back down"
    shares = [asked(0.0, rises_m_s=speed)[0][2] for speed in np.linspace(0.0, 2.0, 9)]
    assert np.all(np.diff(shares) < 0.0)


def test_a_sole_that_comes_down_is_stopped_with_all_weight():
    np.testing.assert_array_equal(asked(0.0, rises_m_s=-1.0)[0], STANCE_WEIGHT)
