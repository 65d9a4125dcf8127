"""The gate knows which of the player's feet bear, and when both leave the floor."""

import numpy as np
import pytest

from game.inputs.performance.repertoire import motion
from kinect.body import Joint
from tests.intake.gated_players import HZ, contacts, gated, joints, performed, standing, true_contacts

BOTH_LEGS = [Joint.KNEE_LEFT, Joint.ANKLE_LEFT, Joint.FOOT_LEFT, Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT, Joint.FOOT_RIGHT]
LEFT_FOOT = [Joint.ANKLE_LEFT, Joint.FOOT_LEFT]


def flights(frames) -> list[tuple[float, float]]:
    """(first, last) time of each flight, seconds."""
    flag = np.array([frame.contacts.flight for frame in frames])
    edges = np.diff(np.concatenate(([0], flag.astype(int), [0])))
    return [(frames[a].time_s, frames[b - 1].time_s) for a, b in zip(np.flatnonzero(edges == 1), np.flatnonzero(edges == -1), strict=True)]


@pytest.mark.parametrize(("noise", "outliers"), [(0.0, 0.0), (1.0 / 3.0, 0.0), (1.0, 1.0)])
def test_feet_of_performers_are_lifted_when_they_are_and_hardly_ever_else(noise, outliers):
    lifted = said = both = 0
    for name in ("stepping", "balancing", "jump", "leaning"):
        frames = performed(name, noise, outliers, seed=11)
        true, found = ~true_contacts(name, frames), ~contacts(frames)
        lifted, said, both = lifted + true.sum(), said + found.sum(), both + (true & found).sum()
    assert both / said > 0.98
    assert both / lifted > 0.82


@pytest.mark.parametrize("seed", [0, 21, 22])
def test_every_jump_of_the_performer_flies_and_nothing_else_does(seed):
    noise = 1.0 if seed else 0.0
    found = flights(performed("jump", noise, noise, seed))
    true = motion("jump").script.airborne["left"]
    assert len(found) == len(true)
    for (a, b), (leaves, lands) in zip(found, true, strict=True):
        assert leaves - 0.05 < a < lands and leaves < b < lands + 0.1
    for name in ("bowing", "reaching", "stepping", "boxing"):
        assert flights(performed(name, noise, noise, seed)) == []


def test_legs_that_are_drawn_up_under_a_still_trunk_are_no_jump():
    seen = np.tile(standing(), (90, 1, 1))
    seen[30:60, BOTH_LEGS, 2] += 0.3
    frames = gated(seen)
    assert contacts(frames).all() and flights(frames) == []
    ankles = joints(frames)[:, [Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT], 2]
    assert np.abs(ankles - ankles[0]).max() < 0.02
    assert np.abs(joints(frames)[:, Joint.HIP_CENTER, 2] - seen[0, Joint.HIP_CENTER, 2]).max() < 0.05
    # without the rule they fly
    assert flights(gated(seen, gate__jumps=False)) != []


def test_a_player_who_rises_as_a_whole_without_a_push_off_stays_on_the_floor():
    seen = np.tile(standing(), (90, 1, 1))
    seen[30:60, :, 2] += 0.2
    frames = gated(seen)
    assert flights(frames) == [] and contacts(frames).all()
    # the legs are as long as before, so the pelvis comes down to them
    assert joints(frames)[50, Joint.HIP_CENTER, 2] < seen[0, Joint.HIP_CENTER, 2] + 0.05


def leap(air_s: float) -> np.ndarray:
    """(T, 20, 3) a crouch, a push-off at 1.2 m/s and so long in the air."""
    t = np.arange(int(3 * HZ)) / HZ
    body, feet = np.zeros(len(t)), np.zeros(len(t))
    push = (t > 1.0) & (t <= 1.2)
    air = (t > 1.2) & (t <= 1.2 + air_s)
    body[push] = -0.12 + 1.2 * (t[push] - 1.0)
    body[(t > 0.5) & (t <= 1.0)] = -0.12
    body[air] = 0.12 + 0.1 * np.sin(np.pi * (t[air] - 1.2) / air_s)
    feet[air] = np.minimum(0.2, body[air] - 0.05)
    seen = np.tile(standing(), (len(t), 1, 1))
    upper = [j for j in Joint if j not in BOTH_LEGS]
    seen[:, upper, 2] += body[:, None]
    seen[:, [Joint.KNEE_LEFT, Joint.KNEE_RIGHT], 2] += 0.5 * (body + feet)[:, None]
    seen[:, LEFT_FOOT + [Joint.ANKLE_RIGHT, Joint.FOOT_RIGHT], 2] += feet[:, None]
    return seen


def test_a_flight_ends_at_its_limit_however_long_the_feet_seem_to_hang():
    (short,) = flights(gated(leap(0.4)))
    assert short[1] - short[0] == pytest.approx(0.4, abs=0.1)
    (cut,) = flights(gated(leap(1.5)))
    assert cut[1] - cut[0] < 0.6 + 1.5 / HZ
    (wide,) = flights(gated(leap(1.5), gate__flight_limit_s=1.0))
    assert wide[1] - wide[0] == pytest.approx(1.0, abs=0.1)


def test_a_harder_push_off_can_be_asked_for():
    assert len(flights(gated(leap(0.4)))) == 1
    assert flights(gated(leap(0.4), gate__push_off_m_s=2.0)) == []


def lifted(height: float, start: int = 30, end: int = 60) -> np.ndarray:
    """(90, 20, 3) somebody who has the left foot so high from frame `start` to `end`, rising within a quarter second."""
    seen = np.tile(standing(), (90, 1, 1))
    rise = np.interp(np.arange(90), [start, start + 8, end - 8, end], [0.0, height, height, 0.0])
    seen[:, LEFT_FOOT, 2] += rise[:, None]
    return seen


def test_a_foot_lifts_above_one_height_and_is_down_below_a_lower_one():
    planted = contacts(gated(lifted(0.12)))
    left = np.flatnonzero(~planted[:, 0])
    heights = lifted(0.12)[:, Joint.ANKLE_LEFT, 2] - lifted(0.12)[0, Joint.ANKLE_LEFT, 2]
    assert heights[left[0]] > 0.04 > heights[left[0] - 1]
    assert heights[left[-1]] > 0.022 > heights[left[-1] + 1]
    assert planted[:, 1].all()
    assert contacts(gated(lifted(0.035))).all()


def test_a_heel_that_rises_over_standing_toes_is_no_lifted_foot():
    seen = np.tile(standing(), (60, 1, 1))
    seen[20:40, Joint.ANKLE_LEFT, 2] += 0.1
    frames = gated(seen)
    assert contacts(frames).all()
    assert joints(frames)[35, Joint.ANKLE_LEFT, 2] > seen[0, Joint.ANKLE_LEFT, 2] + 0.05


def test_one_leg_stands_last_as_long_as_they_are_held():
    seen = np.tile(standing(), (900, 1, 1))
    seen[30:880, [Joint.KNEE_LEFT, *LEFT_FOOT], 2] += 0.3
    planted = contacts(gated(seen))
    assert not planted[33:878, 0].any() and planted[:, 1].all()


def test_a_quick_low_step_is_a_step():
    seen = np.tile(standing(), (90, 1, 1))
    ahead = np.interp(np.arange(90), [30, 40], [0.0, 0.5])
    seen[:, [Joint.KNEE_LEFT, *LEFT_FOOT], 0] += ahead[:, None]
    frames = gated(seen)
    planted = contacts(frames)
    assert not planted[36:40, 0].any() and planted[45:, 0].all() and planted[:, 1].all()
    assert joints(frames)[-1, Joint.ANKLE_LEFT, 0] == pytest.approx(seen[-1, Joint.ANKLE_LEFT, 0], abs=0.02)
