"""How late the hands are and how much of the way they go, found again from motions whose delay and reach are known."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import JOINTS
from game.report.wrist_following import WristFollowing
from game.rotation import Floats
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from tests.report.observed import body_in, elsewhere, target_of
from tests.target.players import NO_TURN

PLAN = load_body_plan("original")
SHOULDERS = [JOINTS.index("shoulder_left"), JOINTS.index("shoulder_right")]
T = np.arange(300) / 30.0


def arms(swing: Floats) -> PosedSkeleton:
    """Standing with the arms swung (2,) rad about the left-right axis."""
    rotations = NO_TURN.copy()
    rotations[SHOULDERS] = rotation.exp(np.outer(swing, [0.0, -1.0, 0.0]))
    return pose_skeleton(PLAN, PLAN.joint[0], rotation.IDENTITY, rotations)


def wave(t: float) -> Floats:
    """A wave of both arms that is not periodic."""
    return np.array([0.6 * np.sin(6.0 * t) + 0.3 * np.sin(2.3 * t + 0.4), 0.5 * np.sin(4.1 * t + 1.0)])


def punches(t: float) -> Floats:
    """The arms thrust forward one after the other, 0.15 s each."""
    return np.array([np.exp(-(((t - k) % 1.7 - 0.8) ** 2) / (2.0 * 0.15**2)) for k in (0.0, 0.7)])


def following(motion, lag_s: float, reach: float = 1.0, walking: bool = False, times: Floats = T) -> WristFollowing:
    wrists = WristFollowing(30.0)
    for t in times:
        own = arms(reach * motion(t - lag_s))
        if walking:
            own = elsewhere(PLAN, own, 0.5 * t, (0.7 * t, 0.1 * np.sin(3.0 * t), 0.0))
        wrists.sample(body_in(own), target_of(PLAN, arms(motion(t))))
    return wrists


@pytest.mark.parametrize("motion", [wave, punches])
@pytest.mark.parametrize("lag_s", [0.0, 0.02, 0.05, 1.0 / 30.0, 0.08, 0.1, 0.21, -0.04])
def test_a_known_lag_is_found_within_five_milliseconds(motion, lag_s):
    assert following(motion, lag_s).lag_s() == pytest.approx(lag_s, abs=0.005)


@pytest.mark.parametrize("reach", [0.5, 1.0, 1.2])
def test_the_reach_does_not_change_the_lag(reach):
    assert following(wave, 0.07, reach).lag_s() == pytest.approx(0.07, abs=0.006)


def test_hands_that_follow_exactly_go_the_whole_way():
    assert following(wave, 0.0).path_ratio() == pytest.approx(1.0)


def test_hands_that_are_late_still_go_the_whole_way():
    assert following(wave, 0.05).path_ratio() == pytest.approx(1.0, abs=0.01)


def test_hands_that_go_half_of_the_way_are_told_so():
    assert following(wave, 0.0, reach=0.5).path_ratio() == pytest.approx(0.5, abs=0.02)


def test_walking_and_turning_are_no_motion_of_the_hands():
    wrists = following(wave, 0.05, walking=True)
    assert wrists.lag_s() == pytest.approx(following(wave, 0.05).lag_s(), abs=1e-9)
    assert wrists.path_ratio() == pytest.approx(following(wave, 0.05).path_ratio(), abs=1e-9)


def test_too_short_a_time_tells_no_lag_and_no_sample_no_path():
    assert following(wave, 0.0, times=T[:30]).lag_s() is None
    assert WristFollowing(30.0).lag_s() is None and WristFollowing(30.0).path_ratio() is None


def test_hands_that_never_move_tell_neither():
    still = following(lambda _t: np.zeros(2), 0.0)
    assert still.lag_s() is None and still.path_ratio() is None
