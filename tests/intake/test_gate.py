"""The gate leaves true motion alone, keeps planted feet still, and puts a pelvis that has sunk back on its legs."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.inputs.performance.repertoire import SCRIPTS
from game.inputs.performer import performed_joints
from game.intake.gate_trunk import TrunkTilt
from game.intake.intake import Intake
from game.tunables import Settings
from kinect.body import Joint
from kinect.clip import ClipSource
from tests.intake.gated_players import HZ, contacts, gated, joints, performed, standing, true_contacts
from tests.kinect.recordings import SHARED

ANKLES = [Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]
TRUNK = [Joint.HIP_CENTER, Joint.SPINE, Joint.SHOULDER_CENTER, Joint.HEAD, Joint.WRIST_LEFT, Joint.WRIST_RIGHT]


@pytest.mark.parametrize("name", SCRIPTS)
def test_what_a_clean_performer_does_passes_almost_as_it_came(name):
    through, around = performed(name), performed(name, gate__on=False)
    assert [frame.time_s for frame in through] == [frame.time_s for frame in around]
    moved = np.linalg.norm(joints(through) - joints(around), axis=2)
    assert moved[:, TRUNK].mean() < 0.002 and moved[:, TRUNK].max() < 0.02
    assert moved[:, ANKLES].mean() < 0.01 and moved[:, ANKLES].max() < 0.07


def test_switched_off_it_tells_of_contacts_and_touches_nothing():
    frames = performed("stepping", 1.0, 1.0, gate__on=False)
    gate_free = performed("stepping", 1.0, 1.0, gate__on=False, gate__up_m=0.1)
    np.testing.assert_array_equal(joints(frames), joints(gate_free))
    assert not contacts(frames).all()


@pytest.mark.parametrize("name", ["stepping", "jump"])
def test_planted_feet_wander_less(name):
    through, around = performed(name, 1.0, 0.0, 5), performed(name, 1.0, 0.0, 5, gate__on=False)
    down = true_contacts(name, through)
    stays = down[1:] & down[:-1]
    way = [np.linalg.norm(np.diff(joints(f)[:, ANKLES, :2], axis=0), axis=2)[stays].sum() / (stays.sum() / HZ) for f in (through, around)]
    assert way[0] < 0.02 and way[0] < 0.75 * way[1]


def test_a_pelvis_that_sinks_in_a_bow_is_put_back_on_its_legs():
    errors = []
    for on in (True, False):
        frames = performed("bowing", 1.0, 0.0, 3, gate__on=on)
        true = performed_joints("bowing", [frame.time_s for frame in frames])
        errors.append(np.sqrt(np.mean((joints(frames) - true)[:, Joint.HIP_CENTER, 2] ** 2)))
    assert errors[1] > 0.08
    assert errors[0] < 0.6 * errors[1]


def test_a_crouch_with_bent_knees_is_believed():
    through, around = performed("reaching"), performed("reaching", gate__on=False)
    low = joints(around)[:, Joint.HIP_CENTER, 2]
    assert low.min() < 0.8 * low[0]
    np.testing.assert_allclose(joints(through)[:, Joint.HIP_CENTER, 2], low, atol=0.01)


def test_raised_hips_on_standing_feet_come_down_to_the_length_of_the_legs():
    seen = np.tile(standing(), (90, 1, 1))
    upper = [j for j in Joint if j < Joint.HIP_LEFT or j in (Joint.HIP_LEFT, Joint.HIP_RIGHT)]
    seen[30:, upper, 2] += 0.12
    pelvis = joints(gated(seen))[:, Joint.HIP_CENTER, 2]
    assert pelvis[-1] < pelvis[0] + 0.05
    assert joints(gated(seen, gate__pelvis=False))[-1, Joint.HIP_CENTER, 2] == pytest.approx(seen[-1, Joint.HIP_CENTER, 2])


def test_nothing_leaps_when_a_foot_lifts_or_lands():
    through, around = performed("stepping", 1.0, 0.0, 2), performed("stepping", 1.0, 0.0, 2, gate__on=False)
    steps = [np.linalg.norm(np.diff(joints(f)[:, ANKLES], axis=0), axis=2).max() for f in (through, around)]
    assert steps[0] < 1.5 * steps[1]


def test_the_trunk_tilts_no_faster_than_it_may_and_catches_up():
    folded, upright = standing(), standing()
    above = [j for j in Joint if Joint.SHOULDER_CENTER <= j < Joint.HIP_LEFT]
    folded[above, 0] += 0.4
    folded[above, 2] -= 0.4
    tilt, angles = TrunkTilt(), []
    for k in range(60):
        frame = (upright if k < 20 else folded).copy()
        tilt.apply(frame, 4.0 / HZ)
        trunk = frame[Joint.SHOULDER_CENTER] - frame[Joint.SPINE]
        angles.append(np.arccos(trunk[2] / np.linalg.norm(trunk)))
        wanted = np.linalg.norm((upright if k < 20 else folded)[Joint.SHOULDER_CENTER] - frame[Joint.SPINE])
        assert np.linalg.norm(trunk) == pytest.approx(wanted)
    assert np.abs(np.diff(angles)).max() < 4.0 / HZ + 1e-6
    np.testing.assert_allclose(frame, folded, atol=1e-9)


@pytest.mark.parametrize("buffer_s", [0.0, 1.0 / 30.0, 0.1])
def test_the_buffer_delays_by_its_length_and_no_more(buffer_s):
    seen = np.tile(standing(), (60, 1, 1))
    seen[:, :, 1] += np.linspace(0.0, 0.5, 60)[:, None]
    frames = gated(seen, gate__buffer_s=buffer_s)
    assert len(frames) == 60 - round(buffer_s * HZ)
    for frame in frames:
        assert frame.age_s == pytest.approx(buffer_s, abs=1e-6)
        assert frame.joints[Joint.HEAD, 1] == seen[round(frame.time_s * HZ), Joint.HEAD, 1]


def test_a_lift_shorter_than_the_buffer_is_not_believed():
    seen = np.tile(standing(), (60, 1, 1))
    seen[30:32, [Joint.ANKLE_LEFT, Joint.FOOT_LEFT], 2] += 0.2
    assert not contacts(gated(seen)).all()
    assert contacts(gated(seen, gate__buffer_s=0.1)).all()
    seen[30:40, [Joint.ANKLE_LEFT, Joint.FOOT_LEFT], 2] += 0.2
    assert not contacts(gated(seen, gate__buffer_s=0.1)).all()


@given(st.integers(0, 2**32 - 1))
def test_whatever_comes_in_finite_numbers_go_out(seed):
    rng = np.random.default_rng(seed)
    wild = np.tile(standing(), (40, 1, 1)) * rng.choice([0.0, 1.0, 1.0, 1.0], (40, 1, 1)) + rng.normal(0.0, rng.uniform(0, 1), (40, 20, 3))
    assert np.isfinite(joints(gated(wild))).all()


@pytest.mark.shared_data
@pytest.mark.skipif(not SHARED.is_dir(), reason=f"no recordings in {SHARED}")
@pytest.mark.parametrize(
    ("clip", "flies"),
    [
        ("v1_kg934_bowing_Bow", 0),
        ("v1_kg934_reaching_Touchyourtoes", 0),
        ("v1_gk_reaching_crouch", 0),
        ("v1_gk_profile", 0),
        ("v1_kg934_boxing_Punch", 0),
        ("v1_kg934_stepping_Walkinplace", 0),
        ("v1_kg934_jump_Jump", 1),
        ("mocap_cmu_02_04", 1),
    ],
)
def test_real_players_fly_when_they_jump_and_only_then(clip, flies):
    intake = Intake(Settings(), mirrored=False)
    frames = [intake.apply(frame) for frame in ClipSource(SHARED / f"{clip}.npz").poll(1e3)]
    flight = np.array([frame is not None and frame.contacts.flight for frame in frames])
    assert np.count_nonzero(np.diff(flight.astype(int)) == 1) == flies


@pytest.mark.shared_data
@pytest.mark.skipif(not SHARED.is_dir(), reason=f"no recordings in {SHARED}")
@pytest.mark.parametrize("clip", ["v1_kg934_bowing_Bow", "v1_kg934_reaching_Touchyourtoes"])
def test_a_real_bow_keeps_feet_and_pelvis(clip):
    intake = Intake(Settings(), mirrored=False)
    frames = [frame for frame in map(intake.apply, ClipSource(SHARED / f"{clip}.npz").poll(1e3)) if frame is not None]
    raw, out = np.array([frame.raw for frame in frames]), joints(frames)
    assert contacts(frames).all()
    assert raw[:, Joint.HIP_CENTER, 2].min() < raw[0, Joint.HIP_CENTER, 2] - 0.35
    assert out[:, Joint.HIP_CENTER, 2].min() > raw[0, Joint.HIP_CENTER, 2] - 0.3
    assert np.ptp(raw[:, ANKLES, 2], axis=0).min() > 0.1
    assert np.ptp(out[:, ANKLES, 2], axis=0).max() < 0.02
