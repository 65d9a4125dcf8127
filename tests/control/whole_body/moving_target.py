"""Kinematic targets made from plain motions: the character's skeleton put where the caller says."""

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import JOINT_COUNT
from game.intake.foot_contacts import STANDING, FootContacts
from game.target.forward_kinematics import pose_skeleton
from game.target.kinematic_target import KinematicTarget, MappedInput
from tests.physics.standing import idle_joints, original

Floats = NDArray[np.float64]


def target_at(
    time_s: float, root: Floats, facing: Floats | None = None, joints: Floats | None = None, contacts: FootContacts = STANDING
) -> KinematicTarget:
    """The original character, root point at `root` (3,), turned by `facing` (4,), in the pose `joints` (14, 4); idle unless given."""
    facing = np.array(rotation.IDENTITY) if facing is None else facing
    joints = idle_joints() if joints is None else joints
    pose = pose_skeleton(original(), root, facing, joints)
    mapped = MappedInput(root, facing, joints, np.zeros((5, 3)))
    return KinematicTarget(time_s, root, facing, joints, np.zeros(3 * JOINT_COUNT), pose, pose.centre_of_mass(original()), mapped, contacts)


def standing_at(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Floats:
    """(3,) root of a character that stands idle at (x, y), its soles z above the floor."""
    return original().joint[0] + np.array([x, y, z])
