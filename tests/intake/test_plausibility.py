"""What a sensor gets wrong is held, slowed or refused with a reason; what comes after is taken again."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from game.intake.intake import Intake
from game.intake.mirror import mirror
from game.intake.plausibility import GAP_S, INFERRED_SPEED_M_S, Plausibility
from game.rotation import Floats
from game.tunables import Settings
from kinect.body import BodyFrame, Floor, Joint
from tests.kinect.recordings import standing_joints

DT = 1.0 / 30.0
LIMIT_M = 0.35
HAND = Joint.HAND_LEFT


def frame(time_s: float, positions: Floats | None = None, confidence: Floats | None = None) -> BodyFrame:
    return BodyFrame(time_s, standing_joints() if positions is None else positions, np.ones(20) if confidence is None else confidence)


def with_joint(joint: Joint, place: object, confidence: float) -> tuple[Floats, Floats]:
    """Standing joints and confidences with one joint changed."""
    positions, sure = standing_joints(), np.ones(20)
    positions[joint], sure[joint] = place, confidence
    return positions, sure


def begun() -> Plausibility:
    """A gate that has seen one good frame at time 0."""
    gate = Plausibility()
    assert gate.apply(frame(0.0), LIMIT_M) is not None and gate.fault == ""
    return gate


def accepted(gate: Plausibility, seen: BodyFrame) -> Floats:
    good = gate.apply(seen, LIMIT_M)
    assert good is not None and gate.fault == "", gate.fault
    return good.positions


def refused(gate: Plausibility, seen: BodyFrame) -> str:
    before = gate.held_frames
    assert gate.apply(seen, LIMIT_M) is None
    assert gate.held_frames == before + 1
    return gate.fault


def test_what_is_tracked_passes_unchanged():
    gate, moved = begun(), standing_joints() + 0.02
    np.testing.assert_array_equal(accepted(gate, frame(DT, moved)), moved)


@pytest.mark.parametrize("place", [[5.0, 5.0, 5.0], [np.nan] * 3])
def test_a_lost_joint_stays_where_it_was_on_the_body(place):
    gate = begun()
    positions, confidence = with_joint(HAND, place, 0.0)
    walked = [0.05, 0.0, 0.02]
    out = accepted(gate, frame(DT, positions + walked, confidence))
    np.testing.assert_allclose(out[HAND], standing_joints()[HAND] + walked)
    np.testing.assert_array_equal(np.delete(out, HAND, axis=0), np.delete(positions + walked, HAND, axis=0))


def test_a_joint_that_is_not_a_number_is_lost_whatever_its_confidence():
    positions, confidence = with_joint(HAND, [np.nan, 0.0, 2.0], 1.0)
    np.testing.assert_allclose(accepted(begun(), frame(DT, positions, confidence))[HAND], standing_joints()[HAND])


def test_an_inferred_joint_goes_half_of_the_way():
    step = np.array([0.04, 0.0, 0.0])
    positions, confidence = with_joint(HAND, standing_joints()[HAND] + step, 0.5)
    np.testing.assert_allclose(accepted(begun(), frame(DT, positions, confidence))[HAND], standing_joints()[HAND] + 0.5 * step)


def test_an_inferred_joint_goes_no_faster_than_its_limit_but_arrives():
    gate = begun()
    there = standing_joints()[HAND] + [0.0, 0.9, 0.0]
    places = [standing_joints()[HAND]]
    for k in range(1, 60):
        positions, confidence = with_joint(HAND, there, 0.5)
        places.append(accepted(gate, frame(k * DT, positions, confidence))[HAND])
    speed = np.linalg.norm(np.diff(places, axis=0), axis=1) / DT
    assert speed.max() == pytest.approx(INFERRED_SPEED_M_S)
    np.testing.assert_allclose(places[-1], there, atol=1e-3)


def test_a_joint_that_is_tracked_again_is_believed_at_once():
    gate = begun()
    accepted(gate, frame(DT, *with_joint(HAND, [0.0, 9.0, 0.0], 0.0)))
    positions, confidence = with_joint(HAND, [0.3, 0.9, 2.0], 1.0)
    np.testing.assert_allclose(accepted(gate, frame(2 * DT, positions, confidence))[HAND], [0.3, 0.9, 2.0])


def test_a_frame_without_a_hip_centre_is_refused():
    assert "hip centre is lost" in refused(begun(), frame(DT, *with_joint(Joint.HIP_CENTER, np.nan, 1.0)))
    assert "hip centre is lost" in refused(begun(), frame(DT, *with_joint(Joint.HIP_CENTER, 0.0, 0.0)))


def test_a_frame_with_less_than_half_of_the_joints_is_refused():
    confidence = np.ones(20)
    confidence[9:] = 0.0
    assert "only 9 of 20 joints" in refused(begun(), frame(DT, None, confidence))


def test_a_player_who_is_not_wholly_seen_yet_is_asked_to_step_back():
    gate = Plausibility()
    assert "step back" in refused(gate, frame(0.0, *with_joint(Joint.FOOT_LEFT, np.nan, 0.0)))
    accepted(gate, frame(DT))


@pytest.mark.parametrize("shape", [(19, 3), (20, 2), (60,), (0, 3)])
def test_a_frame_of_another_shape_is_refused(shape):
    assert str(shape) in refused(begun(), frame(DT, np.zeros(shape)))


def test_a_frame_with_too_few_confidences_is_refused():
    assert "(19,)" in refused(begun(), frame(DT, None, np.ones(19)))


@pytest.mark.parametrize("time_s", [0.0, -1.0, math.nan, math.inf])
def test_a_frame_whose_time_does_not_advance_is_dropped(time_s):
    assert "time does not advance" in refused(begun(), frame(time_s))


def test_a_first_frame_without_a_time_is_dropped():
    assert "time" in refused(Plausibility(), frame(math.nan))


def test_a_teleporting_player_is_held_until_the_player_is_back():
    gate = begun()
    for k in range(1, 6):
        assert "jumps 2.00 m" in refused(gate, frame(k * DT, standing_joints() + [2.0, 0.0, 0.0]))
    assert gate.held_frames == 5
    accepted(gate, frame(6 * DT))


def test_after_a_gap_the_player_may_be_anywhere():
    gate, elsewhere = begun(), standing_joints() + [2.0, 0.0, 0.0]
    refused(gate, frame(GAP_S - 0.01, elsewhere))
    np.testing.assert_array_equal(accepted(gate, frame(GAP_S + 0.01, elsewhere)), elsewhere)


def test_repairing_does_not_write_into_the_frame():
    gate = begun()
    positions, confidence = with_joint(HAND, [0.0, 9.0, 0.0], 0.5)
    kept = positions.copy()
    accepted(gate, frame(DT, positions, confidence))
    np.testing.assert_array_equal(positions, kept)


@settings(max_examples=60)
@given(
    rows=st.lists(
        st.tuples(
            st.floats(width=32),
            hnp.arrays(
                np.float64, (20, 3), elements=st.floats(-3.0, 3.0) | st.just(math.nan) | st.just(math.inf), fill=st.floats(-1.0, 1.0)
            ),
            hnp.arrays(np.float64, 20, elements=st.sampled_from([0.0, 0.5, 1.0, math.nan]), fill=st.just(1.0)),
        ),
        max_size=5,
    )
)
def test_whatever_comes_what_passes_is_finite_and_advances_in_time(rows):
    gate, last = begun(), 0.0
    for time_s, positions, confidence in rows:
        good = gate.apply(BodyFrame(time_s, positions, confidence), LIMIT_M)
        assert (good is None) == (gate.fault != "")
        if good is not None:
            assert np.all(np.isfinite(good.positions)) and good.time_s > last
            last = good.time_s


def levelled(positions: Floats, time_s: float = 0.0) -> BodyFrame:
    return BodyFrame(time_s, positions, np.ones(20), floor=Floor(0.0, 1.0, 0.0, 0.9))


def test_the_whole_intake_puts_a_frame_on_the_floor_and_refuses_the_next_bad_one():
    intake = Intake(Settings(), mirrored=False)
    seen = intake.apply(levelled(standing_joints()))
    assert seen is not None and intake.fault == ""
    assert seen.joints[Joint.ANKLE_LEFT, 2] == pytest.approx(0.08)
    assert intake.apply(levelled(np.full((20, 3), np.nan), DT)) is None
    assert "hip centre" in intake.fault and intake.held_frames == 1


def test_mirroring_needs_both_a_scene_that_mirrors_and_the_players_wish():
    plain = Intake(Settings(), mirrored=False).apply(levelled(standing_joints()))
    shown = Intake(Settings(), mirrored=True).apply(levelled(standing_joints()))
    unwanted = Intake(Settings({"intake.mirror": False}), mirrored=True).apply(levelled(standing_joints()))
    assert plain is not None and shown is not None and unwanted is not None
    np.testing.assert_array_equal(shown.joints, mirror(plain.joints))
    np.testing.assert_array_equal(unwanted.joints, plain.joints)


def test_smoothing_leaves_the_raw_joints_beside_the_smoothed():
    intake = Intake(Settings({"intake.smoothing": 1.0}), mirrored=False)
    intake.apply(levelled(standing_joints()))
    seen = intake.apply(levelled(standing_joints() + 0.1, DT))
    plain = Intake(Settings(), mirrored=False).apply(levelled(standing_joints() + 0.1))
    assert seen is not None and plain is not None
    np.testing.assert_array_equal(seen.raw, plain.raw)
    assert np.linalg.norm(seen.joints - seen.raw, axis=1).min() > 0.01
