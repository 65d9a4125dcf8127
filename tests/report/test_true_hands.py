"""The hands are compared with the clean performer's, and the delay is found; feet that slide are seen to."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from game.characters.body_plan import load_body_plan
from game.characters.skeleton import FEET
from game.report.foot_slide import FootSlide
from game.report.true_hands import TrueHands

PLAN = load_body_plan("original")


def follower(hands: TrueHands, t: float, delay_s: float, off_m: float) -> Any:
    """A body at the origin whose wrists are where the performer's were so long ago, `off_m` too high."""
    wrists = np.array([np.interp(t - delay_s, hands._time, column) for column in hands._true.T]).reshape(2, 3)
    joint = np.zeros((15, 3))
    from game.report.true_hands import HANDS

    joint[HANDS] = wrists + [0.0, 0.0, off_m]
    orientation = np.zeros((15, 4))
    orientation[:, 0] = 1.0
    return SimpleNamespace(joint=joint, orientation=orientation)


@pytest.mark.parametrize("delay_s", [0.0, 0.08, 0.2])
def test_delay_and_distance_of_a_follower_are_found(delay_s):
    hands = TrueHands("boxing", PLAN)
    for k in range(30, 300):
        hands.sample(k / 30.0, follower(hands, k / 30.0, delay_s, 0.03))
    assert hands.best_delay_s() == pytest.approx(delay_s, abs=0.011)
    assert hands.error_m(delay_s) == pytest.approx(0.03, abs=1e-6)
    later = hands.error_m(delay_s + 0.1)
    assert later is not None and later > 0.05


def test_nothing_sampled_is_no_error():
    assert TrueHands("standing", PLAN).error_m(0.1) is None


def foot_at(x: float, touches: tuple[bool, bool]) -> Any:
    centre = np.zeros((15, 3))
    centre[FEET[0], 0] = x
    return SimpleNamespace(box_centre=centre, foot_contact=touches)


def test_a_sliding_foot_is_measured_only_while_it_bears():
    slide = FootSlide()
    for k in range(31):
        slide.sample(k / 30.0, foot_at(0.06 * k / 30.0, (True, False)))
    assert slide.speed_m_s == pytest.approx(0.06)
    swung = FootSlide()
    for k in range(31):
        swung.sample(k / 30.0, foot_at(0.5 * k / 30.0, (False, True)))
    assert swung.speed_m_s == 0.0
    assert FootSlide().speed_m_s is None
