"""A player who is a scaled copy of the character is mapped back to the character's pose, up to twists that joints do not show."""

from dataclasses import fields

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game import rotation
from game.characters.body_plan import BUILT_IN, load_body_plan
from game.characters.skeleton import END_EFFECTOR_PARTS, JOINTS, PARTS
from game.intake.mirror import mirror
from game.rotation import Floats
from game.target.calibration import Calibration, calibrate
from game.target.forward_kinematics import pose_skeleton
from game.target.kinematic_target import map_input
from game.target.mapping import bone_directions
from tests.target.players import NO_TURN, Player, any_pose, idle, seen_joints, untwisted

FEW = settings(max_examples=40)
PLAN = load_body_plan("original")
PLAYER = st.builds(
    Player,
    st.just(PLAN),
    st.floats(0.6, 1.4),
    st.floats(-3.1, 3.1),
    st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)),
)


def same_turns(a: Floats, b: Floats, atol: float = 1e-7) -> None:
    np.testing.assert_allclose(rotation.matrix(a), rotation.matrix(b), atol=atol)


@FEW
@given(player=PLAYER)
def test_the_size_and_the_place_of_a_copy_are_recovered_exactly(player):
    calibration = calibrate(PLAN, player.standing())
    assert calibration.scale == pytest.approx(1.0 / player.size, rel=1e-12)
    np.testing.assert_allclose(calibration.origin, [*player.place, 0.0], atol=1e-12)
    assert calibration.rise_m == pytest.approx(0.0, abs=1e-12)
    for offset in (calibration.root_offset, calibration.neck_offset, calibration.shoulder_offset):
        np.testing.assert_allclose(offset, 0.0, atol=1e-12)


@FEW
@given(player=PLAYER)
def test_a_copy_that_stands_idle_is_mapped_to_no_turn_at_all(player):
    mapped = map_input(player.joints(idle(PLAN)), calibrate(PLAN, player.standing()))
    np.testing.assert_allclose(rotation.log(mapped.joint_rotation), 0.0, atol=1e-7)
    same_turns(mapped.root_orientation, rotation.about_z(player.heading_rad))
    np.testing.assert_allclose(mapped.root_position, PLAN.joint[0], atol=1e-9)


@pytest.mark.parametrize("name", BUILT_IN)
def test_every_character_has_the_idle_pose_as_its_identity(name):
    plan = load_body_plan(name)
    player = Player(plan, 1.1, 0.5, (0.3, -0.2))
    mapped = map_input(player.joints(idle(plan)), calibrate(plan, player.standing()))
    np.testing.assert_allclose(rotation.log(mapped.joint_rotation), 0.0, atol=1e-7)


@FEW
@given(player=PLAYER, seed=st.integers(0, 10_000), wildness=st.floats(0.0, 0.8))
def test_a_copy_in_any_pose_is_mapped_to_that_pose_up_to_twists(player, seed, wildness):
    pose = any_pose(PLAN, seed, wildness)
    mapped = map_input(player.joints(pose), calibrate(PLAN, player.standing()))
    back = pose_skeleton(PLAN, mapped.root_position, mapped.root_orientation, mapped.joint_rotation)
    turn = rotation.about_z(player.heading_rad)
    # every joint a sensor sees is where the player has it, pelvis and trunk are turned as the player's
    np.testing.assert_allclose(seen_joints(back), rotation.rotate(turn, seen_joints(pose)), atol=1e-7)
    np.testing.assert_allclose(mapped.end_effector, back.joint[list(END_EFFECTOR_PARTS)], atol=1e-7)
    same_turns(back.orientation[:2], rotation.multiply(turn, pose.orientation[:2]))
    np.testing.assert_allclose(np.linalg.norm(mapped.joint_rotation, axis=1), 1.0)


@FEW
@given(player=PLAYER, seed=st.integers(0, 10_000))
def test_a_pose_without_twists_is_mapped_to_its_very_joint_rotations(player, seed):
    pose = untwisted(any_pose(PLAN, seed), PLAN)
    mapped = map_input(player.joints(pose), calibrate(PLAN, player.standing()))
    same_turns(mapped.joint_rotation, pose.joint_rotation)
    same_turns(mapped.root_orientation, rotation.multiply(rotation.about_z(player.heading_rad), pose.root_orientation))


@pytest.mark.parametrize("seed", range(5))
def test_limbs_are_swung_and_never_twisted(seed):
    player = Player(PLAN)
    mapped = map_input(player.joints(any_pose(PLAN, seed)), calibrate(PLAN, player.standing()))
    bones = bone_directions(seen_joints(idle(PLAN)))[1:]
    twist = np.abs(np.sum(rotation.log(mapped.joint_rotation) * bones, axis=1))
    np.testing.assert_allclose(twist[[i for i, name in enumerate(JOINTS) if name != "spine"]], 0.0, atol=1e-9)


def mirrored_turns(q: Floats) -> Floats:
    """Rotations seen in a mirror at the plane y = 0."""
    return q * np.array([1.0, -1.0, 1.0, -1.0])


def other_side(names: tuple[str, ...]) -> list[int]:
    return [names.index(name.replace("left", "?").replace("right", "left").replace("?", "right")) for name in names]


@pytest.mark.parametrize("seed", range(5))
def test_mirroring_the_player_mirrors_the_mapped_pose(seed):
    player = Player(PLAN, 0.9, 0.4, (0.2, 0.5))
    rng = np.random.default_rng(seed)
    standing = player.standing() + rng.normal(scale=0.02, size=(20, 3))
    joints = player.joints(any_pose(PLAN, seed))
    plain = map_input(joints, calibrate(PLAN, standing))
    seen = map_input(mirror(joints), calibrate(PLAN, mirror(standing)))
    same_turns(seen.root_orientation, mirrored_turns(plain.root_orientation), 1e-9)
    same_turns(seen.joint_rotation, mirrored_turns(plain.joint_rotation[other_side(JOINTS)]), 1e-9)
    np.testing.assert_allclose(seen.root_position, plain.root_position * [1.0, -1.0, 1.0], atol=1e-9)
    np.testing.assert_allclose(seen.end_effector, plain.end_effector[[1, 0, 3, 2, 4]] * [1.0, -1.0, 1.0], atol=1e-9)


def test_mirroring_commutes_with_calibration():
    standing = Player(PLAN, 1.2, -0.6, (0.1, 0.3)).standing() + np.random.default_rng(7).normal(scale=0.02, size=(20, 3))
    plain, seen = calibrate(PLAN, standing), calibrate(PLAN, mirror(standing))
    flip = np.array([1.0, -1.0, 1.0])
    expected = Calibration(
        scale=plain.scale,
        pelvis=mirrored_turns(plain.pelvis),
        trunk=mirrored_turns(plain.trunk),
        idle_direction=plain.idle_direction[other_side(PARTS)] * flip,
        origin=plain.origin * flip,
        rise_m=plain.rise_m,
        root_offset=plain.root_offset * flip,
        neck_offset=plain.neck_offset * flip,
        shoulder_offset=plain.shoulder_offset[::-1] * flip,
    )
    for field in fields(Calibration):
        np.testing.assert_allclose(getattr(seen, field.name), getattr(expected, field.name), atol=1e-9, err_msg=field.name)


def test_a_raised_left_arm_of_the_player_is_a_raised_left_arm_of_the_character():
    rotations = NO_TURN.copy()
    rotations[JOINTS.index("shoulder_left")] = rotation.exp(np.array([0.0, -1.5, 0.0]))
    player = Player(PLAN, 0.8)
    pose = pose_skeleton(PLAN, PLAN.joint[0], rotation.IDENTITY, rotations)
    mapped = map_input(player.joints(pose), calibrate(PLAN, player.standing()))
    same_turns(mapped.joint_rotation, rotations)
