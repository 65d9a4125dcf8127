"""How far joints go: knees do not bend backwards, left is like right, and what real players do lies inside."""

from pathlib import Path

import numpy as np
import pytest

from game import rotation
from game.characters.joint_limits import HIGH, LOW, in_range_of
from game.characters.skeleton import JOINTS
from game.scenes.fighter import Fighter
from game.tunables import Settings
from tests.scenes.staged import make_scene

FORWARD, LEFT, UP = range(3)
CLIPS = Path(__file__).resolve().parents[2] / ".." / "shared" / "data" / "clips"
NEAR_RAD = 0.2


def degrees(joint, axis):
    row = JOINTS.index(joint)
    return np.degrees(LOW[row, axis]), np.degrees(HIGH[row, axis])


def targets(spec: str) -> np.ndarray:
    """(n, 14, 3) rotation vectors of the targets that an input leads to."""
    scene = make_scene("mirror", spec, Settings())
    scene.enter()
    fighter: Fighter = scene.simulation.fighters[0]  # type: ignore[attr-defined]
    seen = [rotation.log(fighter.target.joint_rotation)]
    for k in range(int(30 * (fighter.source.length_s or 0.0))):
        fighter.watch(k / 30.0)
        seen.append(rotation.log(fighter.target.joint_rotation))
    scene.leave()
    return np.array(seen)


def beyond(angles: np.ndarray) -> np.ndarray:
    """How far (rad) each angle lies outside its range."""
    return np.maximum(np.maximum(LOW - angles, angles - HIGH), 0.0)


def test_a_straight_body_is_inside_every_range():
    assert np.all(LOW < 0.0) and np.all(HIGH > 0.0)


def test_a_knee_bends_backwards_by_next_to_nothing():
    for knee in ("knee_left", "knee_right"):
        least, most = degrees(knee, LEFT)
        assert -5.0 <= least < 0.0 and 130.0 <= most <= 150.0
        assert max(abs(a) for a in degrees(knee, FORWARD)) <= 15.0 and max(abs(a) for a in degrees(knee, UP)) <= 15.0


def test_thighs_shins_and_arms_go_further_the_way_they_do_in_a_human():
    assert degrees("hip_left", LEFT)[0] < -120.0 and degrees("hip_left", LEFT)[1] < 40.0, "forward more than back"
    assert degrees("hip_left", FORWARD)[1] > -degrees("hip_left", FORWARD)[0], "outward more than across"
    assert degrees("hip_right", FORWARD)[1] < -degrees("hip_right", FORWARD)[0], "on the right too"
    assert degrees("shoulder_left", LEFT)[0] < -150.0 and degrees("shoulder_left", LEFT)[1] < 70.0
    assert degrees("spine", LEFT)[1] > -degrees("spine", LEFT)[0], "bowing more than leaning back"


def test_an_elbow_bends_as_far_to_every_side_since_the_upper_arm_shows_no_twist():
    assert degrees("elbow_left", LEFT) == degrees("elbow_left", FORWARD) == pytest.approx((-150.0, 150.0))


def test_left_and_right_mirror_each_other():
    for joint in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle"):
        for axis, swapped in ((FORWARD, True), (LEFT, False), (UP, True)):
            low, high = degrees(f"{joint}_left", axis)
            assert degrees(f"{joint}_right", axis) == pytest.approx((-high, -low) if swapped else (low, high))


@pytest.mark.parametrize("motion", ["waving", "bowing", "stepping", "balancing", "boxing", "jump"])
def test_what_the_performers_do_is_within_reach_of_a_human(motion):
    assert (beyond(targets(f"performer:{motion}")) < NEAR_RAD).mean() > 0.99


@pytest.mark.shared_data
@pytest.mark.parametrize("clip", ["v1_kg934_bowing_Bow", "v1_kg934_waving_Waveyourotherhand", "v1_kg976_STITCHED_waving", "v1_msrc12_p21"])
def test_what_real_players_do_is_within_reach_of_a_human(clip):
    path = CLIPS / f"{clip}.npz"
    if not path.exists():
        pytest.skip(f"{path} is not there: the recordings lie beside the project")
    assert (beyond(targets(f"clip:{path}")) < NEAR_RAD).mean() > 0.99


def test_an_arm_raised_past_straight_up_has_not_been_lowered():
    row = JOINTS.index("shoulder_left")
    raised = rotation.exp(np.radians([0.0, -190.0, 0.0]))
    assert np.degrees(rotation.log(raised))[LEFT] == pytest.approx(170.0)
    assert np.degrees(in_range_of(raised, LOW[row], HIGH[row])) == pytest.approx([0.0, -190.0, 0.0])


def test_whatever_lies_in_its_range_or_near_it_is_told_as_it_is():
    rng = np.random.default_rng(2)
    for row in range(len(JOINTS)):
        for share in rng.uniform(-0.1, 1.1, (20, 3)):
            angle = LOW[row] + share * (HIGH[row] - LOW[row])
            told = in_range_of(rotation.exp(angle), LOW[row], HIGH[row])
            # another vector of the same turn may be told only where it is no farther out
            assert np.allclose(rotation.matrix(rotation.exp(told)), rotation.matrix(rotation.exp(angle)))
            out, told_out = (np.maximum(LOW[row] - a, a - HIGH[row]).max() for a in (angle, told))
            assert told_out <= max(out, 0.0) + 1e-9
