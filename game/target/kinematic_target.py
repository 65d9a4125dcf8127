"""The kinematic target: what the character should look like at a frame of the input (thesis section 3.3)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import END_EFFECTOR_PARTS, JOINT_COUNT
from game.compiled import compiled
from game.intake.foot_contacts import STANDING, FootContacts
from game.target.calibration import Calibration
from game.target.flat_sole import FlatSoles
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from game.target.inverse_kinematics import SOLVERS, clamp_targets
from game.target.jacobian import jacobian_of
from game.target.mapping import mapped_orientations, mapped_positions
from game.tunables import Settings
from kinect.body import Joint

Floats = NDArray[np.float64]

_EFFECTOR_JOINTS = np.array([Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT, Joint.WRIST_LEFT, Joint.WRIST_RIGHT, Joint.SHOULDER_CENTER])
_EFFECTOR_PARTS = np.array(END_EFFECTOR_PARTS)
_ROOT = int(Joint.HIP_CENTER)


@dataclass(frozen=True)
class MappedInput:
    """The input on the character's skeleton before any processing.

    root_position (3,), root_orientation (4,), joint_rotation (14, 4) child in parent, end_effector (5, 3) world metres
    in the order of `END_EFFECTORS`: the sensed places, which the fixed skeleton need not reach.
    """

    root_position: Floats
    root_orientation: Floats
    joint_rotation: Floats
    end_effector: Floats


@dataclass(frozen=True)
class KinematicTarget:
    """The pose to be tracked. World frame, metres, radians, seconds.

    root_position (3,), root_orientation (4,); joint_rotation (14, 4) child in parent frame;
    joint_velocity (42,) rad/s in the child frame; pose: world pose of all parts; com (3,); mapped: the input it came from
    (unsmoothed); contacts: what the player's feet do.
    """

    time_s: float
    root_position: Floats
    root_orientation: Floats
    joint_rotation: Floats
    joint_velocity: Floats
    pose: PosedSkeleton
    com: Floats
    mapped: MappedInput
    contacts: FootContacts = STANDING


def map_input(joints: Floats, calibration: Calibration) -> MappedInput:
    """Sensed joints (20, 3), world frame, as a pose of the character with the sensed end-effector places."""
    c = calibration
    return MappedInput(
        *_mapped(joints, c.pelvis, c.trunk, c.idle_direction, c.scale, c.origin, c.rise_m, c.shoulder_offset, c.neck_offset, c.root_offset)
    )


@compiled
def _mapped(
    joints: Floats, pelvis: Floats, trunk: Floats, idle: Floats, scale: float, origin: Floats, rise_m: float, shoulder_offset: Floats,
    neck_offset: Floats, root_offset: Floats,
) -> tuple[Floats, Floats, Floats, Floats]:  # fmt: skip
    """The fields of a `MappedInput`, in their order."""
    root, joint_rotation = mapped_orientations(joints, pelvis, trunk, idle)
    placed = mapped_positions(joints, scale, origin, rise_m)
    trunk_turn = one.matrix(one.multiply(root, joint_rotation[0]))
    effector = placed[_EFFECTOR_JOINTS]
    effector[2] += one.turn(trunk_turn, shoulder_offset[0])
    effector[3] += one.turn(trunk_turn, shoulder_offset[1])
    effector[4] += one.turn(trunk_turn, neck_offset)
    position = placed[_ROOT] + one.turn(one.matrix(root), root_offset)
    return position, root, joint_rotation, effector


class TargetTracker:
    """Turns frames into kinematic targets: one step of inverse kinematics a frame, from the previous target's pose."""

    def __init__(self, plan: BodyPlan, calibration: Calibration, settings: Settings) -> None:
        self._plan = plan
        self._calibration = calibration
        self._settings = settings
        self._last: KinematicTarget | None = None
        self._soles = FlatSoles()

    def step(self, time_s: float, joints: Floats, raw: Floats, contacts: FootContacts = STANDING) -> KinematicTarget:
        """The target for joints (20, 3) in the world frame; `raw` are the same joints before smoothing."""
        mapped = map_input(joints, self._calibration)
        raw_mapped = mapped if raw is joints else map_input(raw, self._calibration)
        dt = 0.0 if self._last is None else time_s - self._last.time_s
        rotations = self._solve(mapped)
        if self._settings.switch("gate.on") and self._settings.switch("gate.flat"):
            rotations = self._soles.apply(mapped.root_orientation, rotations, contacts.planted, dt)
        pose = pose_skeleton(self._plan, mapped.root_position, mapped.root_orientation, rotations)
        velocity = np.zeros(3 * JOINT_COUNT)
        if self._last is not None and dt > 0.0:
            velocity = one.turns_to(self._last.joint_rotation, rotations) / dt
        com = pose.centre_of_mass(self._plan)
        root = mapped.root_position, mapped.root_orientation
        target = KinematicTarget(time_s, *root, rotations, velocity, pose, com, raw_mapped, contacts)
        self._last = target
        return target

    def _solve(self, mapped: MappedInput) -> Floats:
        method = self._settings.choice("ik.method")
        if method == "none":
            return mapped.joint_rotation
        if self._last is None:
            previous = mapped.joint_rotation
            pose = pose_skeleton(self._plan, mapped.root_position, mapped.root_orientation, previous)
        else:
            previous, pose = self._last.joint_rotation, self._last.pose
        number = self._settings.number
        step = SOLVERS[method](
            *_still_to_go(
                pose.turn, pose.joint, previous, mapped.root_position, mapped.root_orientation, mapped.joint_rotation,
                mapped.end_effector, number("ik.target_clamp_m"),
            ),
            number("ik.damping"),
            number("ik.pose_weight"),
        )  # fmt: skip
        return _turned_by(step, previous)


@compiled
def _still_to_go(
    turn: Floats, joint: Floats, rotation: Floats, root_position: Floats, root_orientation: Floats, wanted: Floats, effector: Floats,
    clamp_m: float,
) -> tuple[Floats, Floats, Floats]:  # fmt: skip
    """End-effector Jacobian (15, 42), clamped error (15,) m and phi (42,) rad, what is still to turn in the parents' frames.

    A pose, turn (15, 3, 3), joint (15, 3), rotation (14, 4), is taken as a rigid body onto the new root; from there to the `wanted`
    rotations (14, 4) and end-effectors (5, 3).
    """
    moved = one.product(one.matrix(root_orientation), np.ascontiguousarray(turn[0].T))
    new_turn, new_joint = np.empty_like(turn), np.empty_like(joint)
    for part in range(len(turn)):
        new_turn[part] = one.product(moved, turn[part])
        new_joint[part] = root_position + one.turn(moved, joint[part] - joint[0])
    error = clamp_targets(effector - new_joint[_EFFECTOR_PARTS], clamp_m)
    return jacobian_of(new_turn, new_joint), error.reshape(-1), _turned_in_parent(rotation, wanted)


@compiled
def _turned_in_parent(before: Floats, after: Floats) -> Floats:
    """(3 n,) rotation vectors from `before` to `after`, (n, 4), in the parent frame."""
    out = np.empty(3 * len(before))
    for j in range(len(before)):
        out[3 * j], out[3 * j + 1], out[3 * j + 2] = one.turn_by(before[j], after[j])
    return out


@compiled
def _turned_by(step: Floats, before: Floats) -> Floats:
    """(n, 4) rotations after turning by rotation vectors (3 n,) in the parent frame."""
    out = np.empty_like(before)
    for j in range(len(before)):
        out[j] = one.normalise(one.multiply(one.exp(step[3 * j : 3 * j + 3]), before[j]))
    return out
