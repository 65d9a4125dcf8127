"""Characters and their targets as the reports see them, made of poses alone."""

from dataclasses import dataclass

import numpy as np

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import END_EFFECTOR_PARTS
from game.rotation import Floats
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from game.target.kinematic_target import KinematicTarget, MappedInput


@dataclass(frozen=True)
class Body:
    """What is measured of a character: orientation (15, 4), joint (15, 3), world frame."""

    orientation: Floats
    joint: Floats


def body_in(pose: PosedSkeleton) -> Body:
    return Body(pose.orientation, pose.joint)


def target_of(plan: BodyPlan, pose: PosedSkeleton, mapped: PosedSkeleton | None = None) -> KinematicTarget:
    """The target that asks for `pose`, made of an input that is mapped to `mapped` (the same if None)."""
    seen = pose if mapped is None else mapped
    effector = seen.joint[list(END_EFFECTOR_PARTS)]
    mapped_input = MappedInput(seen.joint[0], seen.root_orientation, seen.joint_rotation, effector)
    com = pose.centre_of_mass(plan)
    return KinematicTarget(0.0, pose.joint[0], pose.root_orientation, pose.joint_rotation, np.zeros(42), pose, com, mapped_input)


def elsewhere(plan: BodyPlan, pose: PosedSkeleton, heading_rad: float, shift: tuple[float, float, float]) -> PosedSkeleton:
    """The same pose turned about the vertical and moved."""
    root = rotation.multiply(rotation.about_z(heading_rad), pose.root_orientation)
    return pose_skeleton(plan, pose.joint[0] + np.array(shift), root, pose.joint_rotation)
