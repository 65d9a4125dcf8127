"""The puppet moves like a person who keeps the balance, and quickly enough to be steered."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from game.inputs.performance.balance import zero_moment_point
from game.inputs.performance.person import centre_of_mass
from game.inputs.performer import FLOOR, SENSOR_DISTANCE_M, SENSOR_HEIGHT_M
from game.inputs.puppet import Puppet
from game.inputs.puppet_controls import PuppetControls
from kinect.body import BONES, Floats, Joint

Plan = Iterable[tuple[float, float, Mapping[str, Any]]]
HEEL_M, TOE_M, OUTER_M = -0.115, 0.145, 0.15
"""Edges of the two soles together, world: x, x and |y|."""


def played(plan: Plan, seconds: float) -> Floats:
    """(T, 20, 3) world joints of a puppet whose controls follow (from, until, what) rows."""
    puppet, frames = Puppet(), []
    for k in range(round(30 * seconds) + 1):
        puppet.controls = PuppetControls()
        for start, end, asked in plan:
            if start <= k / 30 < end:
                puppet.controls = replace(puppet.controls, **asked)
        frames += puppet.poll(k / 30)
    sensed = np.array([frame.positions for frame in frames])
    return np.stack([SENSOR_DISTANCE_M - sensed[..., 2], -sensed[..., 0], sensed[..., 1] + SENSOR_HEIGHT_M], axis=-1)


def speed(path: Floats) -> Floats:
    return np.linalg.norm(np.gradient(path, 1.0 / 30.0, axis=0), axis=-1)


def soles(world: Floats) -> Floats:
    """(T, 2) height of each sole's ball, metres; left, right."""
    return world[:, [Joint.FOOT_LEFT, Joint.FOOT_RIGHT], 2] - 0.02


PLANS: dict[str, Plan] = {
    "lean forward": [(1.0, 3.0, {"lean_forward": 1.0})],
    "lean back": [(1.0, 3.0, {"lean_forward": -1.0})],
    "lean left": [(1.0, 3.0, {"lean_left": 1.0})],
    "lean right": [(1.0, 3.0, {"lean_left": -1.0})],
    "crouch": [(1.0, 3.0, {"crouch": 1.0})],
    "raise": [(1.0, 3.0, {"raise_left": 1.0, "raise_right": 1.0})],
    "guard and thrusts": [(0.5, 4.0, {"guard": True}), (1.5, 1.8, {"thrust_right": 1.0}), (2.2, 2.5, {"thrust_left": 1.0})],
    "wave": [(0.5, 4.0, {"wave": True})],
    "step": [(1.0, 1.1, {"step_left": True})],
    "march": [(1.0, 4.0, {"step_left": True, "step_right": True})],
    "kick": [(1.0, 1.1, {"kick_right": True})],
    "jump": [(1.0, 1.1, {"jump": True})],
}


@pytest.fixture(scope="module")
def motions() -> dict[str, Floats]:
    return {name: played(plan, 6.0) for name, plan in PLANS.items()}


@pytest.mark.parametrize("name", PLANS)
def test_bones_are_rigid_and_the_person_comes_back_to_quiet_standing(motions, name):
    world = motions[name]
    ends = np.array(BONES)
    lengths = np.linalg.norm(world[:, ends[:, 1]] - world[:, ends[:, 0]], axis=2)
    np.testing.assert_allclose(lengths, np.broadcast_to(lengths[0], lengths.shape), atol=1e-6)
    np.testing.assert_allclose(world[-1], world[0], atol=0.01)
    assert speed(world).max() < 5.0, "no joint of a person on strings leaps"


@pytest.mark.parametrize("name", [name for name in PLANS if name != "jump"])
def test_the_ground_can_hold_the_person(motions, name):
    world = motions[name]
    zmp = zero_moment_point(world, 1.0 / 30.0)[1:-1]
    assert zmp[:, 0].min() > HEEL_M - 0.02 and zmp[:, 0].max() < TOE_M + 0.02
    assert np.abs(zmp[:, 1]).max() < OUTER_M
    up = soles(world)[1:-1] > 0.02
    assert np.all(zmp[up[:, 0], 1] < -0.03), "on the right foot while the left is up"
    assert np.all(zmp[up[:, 1], 1] > 0.03)


@pytest.mark.parametrize("name", ["lean forward", "lean back", "lean left", "lean right", "crouch", "raise", "guard and thrusts", "wave"])
def test_planted_feet_do_not_move_at_all(motions, name):
    feet = motions[name][:, [Joint.ANKLE_LEFT, Joint.FOOT_LEFT, Joint.ANKLE_RIGHT, Joint.FOOT_RIGHT]]
    np.testing.assert_allclose(feet, np.broadcast_to(feet[0], feet.shape), atol=1e-9)


def test_leaning_bends_the_trunk_and_shifts_the_hips_the_other_way(motions):
    for name, axis, sign, least_deg in (
        ("lean forward", 0, 1, 30),
        ("lean back", 0, -1, 8),
        ("lean left", 1, 1, 22),
        ("lean right", 1, -1, 22),
    ):
        still, held = motions[name][0], motions[name][80]
        trunk = held[Joint.SHOULDER_CENTER] - held[Joint.SPINE]
        assert np.degrees(np.arctan2(sign * trunk[axis], trunk[2])) > least_deg, name
        hips = (held - still)[Joint.HIP_CENTER, axis] - (centre_of_mass(held[None]) - centre_of_mass(still[None]))[0, axis]
        assert sign * hips < -0.015, f"{name}: the hips give way under the trunk"


def test_a_crouch_lowers_the_hips_by_a_hand_and_more(motions):
    hips = motions["crouch"][:, Joint.HIP_CENTER, 2]
    assert hips[0] - hips.min() > 0.22


def test_a_thrust_reaches_ahead_at_a_fists_speed(motions):
    wrist = motions["guard and thrusts"][:, Joint.WRIST_RIGHT]
    assert 1.9 < speed(wrist)[40:60].max() < 3.0
    shoulder = motions["guard and thrusts"][:, Joint.SHOULDER_RIGHT]
    reach = (wrist - shoulder)[:, 0]
    assert reach[40:60].max() > 0.45
    assert reach[45] < 0.7 * reach[54], "it starts from the guard"
    assert 2.5 < speed(played([(1.0, 1.5, {"thrust_left": 1.0})], 2.0)[:, Joint.WRIST_LEFT]).max() < 4.0


def test_thrusts_go_straight_ahead_even_when_the_trunk_leans():
    world = played([(0.5, 2.0, {"lean_forward": 1.0, "thrust_left": 1.0, "thrust_right": 1.0})], 2.0)
    arm = (world[:, Joint.WRIST_LEFT] - world[:, Joint.SHOULDER_LEFT])[-1]
    assert abs(np.degrees(np.arctan2(arm[2], arm[0]))) < 20.0


def test_raised_arms_are_above_the_head_and_a_wave_swings_beside_it(motions):
    raised = motions["raise"][85]
    assert np.all(raised[[Joint.WRIST_LEFT, Joint.WRIST_RIGHT], 2] > raised[Joint.HEAD, 2])
    wrist = motions["wave"][45:105, Joint.WRIST_RIGHT]
    assert np.linalg.norm(np.ptp(wrist, axis=0)) > 0.3
    turns = np.count_nonzero(np.diff(np.sign(np.diff(wrist[:, 1]))))
    assert turns >= 4, "more than one swing a second for two seconds"
    np.testing.assert_allclose(motions["wave"][45:105, Joint.WRIST_LEFT, 2], 0.88, atol=0.05)


def test_a_step_shifts_the_weight_first_then_lifts_the_foot_and_sets_it_down_where_it_was(motions):
    world = motions["step"]
    left, right = soles(world).T
    assert 0.08 < left.max() < 0.16 and np.all(right < 1e-9)
    lifts = int(np.argmax(left > 1e-6))
    assert 33 <= lifts <= 45, "within half a second of the press at frame 30"
    com = centre_of_mass(world)[:, 1]
    capture = com + np.gradient(com, 1.0 / 30.0) / np.sqrt(9.81 / 0.95)
    assert capture[lifts] < -0.05, "the weight is on its way over the right foot before the left one lifts"
    np.testing.assert_allclose(world[-1, Joint.FOOT_LEFT], world[0, Joint.FOOT_LEFT], atol=1e-9)


def test_marching_lifts_the_feet_in_turn(motions):
    up = soles(motions["march"]) > 0.03
    assert not np.any(up.all(axis=1))
    starts = [int(np.count_nonzero(np.diff(up[:, side].astype(int)) == 1)) for side in (0, 1)]
    assert sum(starts) >= 4 and abs(starts[0] - starts[1]) <= 1


def test_a_kick_brings_the_foot_far_forward_and_back(motions):
    foot = motions["kick"][:, Joint.FOOT_RIGHT]
    assert (foot - foot[0])[:, 0].max() > 0.45
    assert foot[:, 2].max() > 0.35
    assert 2.0 < speed(foot).max() < 4.5


def test_a_jump_leaves_the_ground_as_a_falling_body_does(motions):
    world = motions["jump"]
    left, right = soles(world).T
    aloft = (left > 0.005) & (right > 0.005)
    assert left.max() >= 0.05 and right.max() >= 0.05
    assert 0.2 <= np.count_nonzero(aloft) / 30.0 + 2.0 / 30.0 < 0.4
    height = centre_of_mass(world)[:, 2]
    middle = np.flatnonzero(aloft)[1:-1]
    fall = (height[middle + 1] - 2.0 * height[middle] + height[middle - 1]) * 900.0
    np.testing.assert_allclose(fall, -9.81, atol=0.6)
    assert height.min() < height[0] - 0.1, "a crouch before and a soft landing after"


def test_off_balance_it_does_not_lean_or_start_something_else():
    world = played([(1.0, 3.0, {"kick_left": True, "jump": True, "lean_left": 1.0, "step_right": True})], 6.0)
    assert np.all(np.isfinite(world))
    together = (soles(world) > 0.02).all(axis=1)
    assert np.any(together), "the jump was first"
    np.testing.assert_allclose(world[-1], world[0], atol=0.02)


@pytest.mark.parametrize("seed", range(4))
def test_a_player_who_hammers_all_keys_never_breaks_the_body(seed):
    rng = np.random.default_rng(seed)
    puppet, frames = Puppet(), []
    for k in range(90):
        lean, aside, *amounts = (*rng.uniform(-1.0, 1.0, 2), *rng.uniform(0.0, 1.0, 5))
        puppet.controls = PuppetControls(lean, aside, *amounts, *(bool(v) for v in rng.random(7) < 0.25))
        frames += puppet.poll(0.2 * k)
    sensed = np.array([frame.positions for frame in frames])
    ends = np.array(BONES)
    lengths = np.linalg.norm(sensed[:, ends[:, 1]] - sensed[:, ends[:, 0]], axis=2)
    np.testing.assert_allclose(lengths, np.broadcast_to(lengths[0], lengths.shape), atol=2e-3)
    assert np.abs(sensed[:, Joint.HIP_CENTER, 0]).max() < 0.3 and np.abs(sensed[:, Joint.HIP_CENTER, 2] - 2.5).max() < 0.3
    assert sensed[:, [Joint.FOOT_LEFT, Joint.FOOT_RIGHT], 1].min() > -0.9, "no foot goes through the floor"
    assert speed(sensed).max() < 7.0


def test_frames_come_at_thirty_a_second_with_the_level_floor_whatever_the_polling():
    often, seldom = Puppet(), Puppet()
    often.controls.lean_forward = seldom.controls.lean_forward = 0.7
    bit_by_bit = [frame for k in range(200) for frame in often.poll(k / 100.0)]
    at_once = seldom.poll(1.99)
    np.testing.assert_allclose([frame.time_s for frame in at_once], np.arange(60) / 30.0)
    np.testing.assert_array_equal([f.positions for f in at_once], [f.positions for f in bit_by_bit])
    assert all(frame.floor == FLOOR and frame.confidence.min() == 1.0 for frame in at_once)


def test_a_wild_value_is_taken_as_the_nearest_valid_one():
    wild, full = Puppet(PuppetControls(lean_forward=7.0, crouch=float("nan"))), Puppet(PuppetControls(lean_forward=1.0))
    np.testing.assert_array_equal([f.positions for f in wild.poll(1.0)], [f.positions for f in full.poll(1.0)])


def test_a_closed_puppet_is_silent():
    puppet = Puppet()
    puppet.close()
    puppet.close()
    assert puppet.poll(1.0) == []
