"""Where every part of a posed skeleton is, and its centre of mass."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game import rotation_compiled as one
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import PARENT, PART_COUNT
from game.compiled import compiled

Floats = NDArray[np.float64]

_PARENT = np.array(PARENT)


@dataclass(frozen=True)
class PosedSkeleton:
    """World pose of the parts: turn (15, 3, 3) part to world, joint (15, 3) joint centres (row 0 the root point), metres.

    root_orientation (4,) and joint_rotation (14, 4), child in parent frame, are what it was posed from.
    """

    turn: Floats
    joint: Floats
    root_orientation: Floats
    joint_rotation: Floats

    @cached_property
    def orientation(self) -> Floats:
        """(15, 4) quaternions of the parts, world frame."""
        return part_orientations(self.root_orientation, self.joint_rotation)

    def box_centres(self, plan: BodyPlan) -> Floats:
        """(15, 3) centres of the boxes, world frame."""
        return self.joint + rotation.turn(self.turn, plan.centre_offset)

    def centre_of_mass(self, plan: BodyPlan) -> Floats:
        """(3,) centre of mass, world frame."""
        return _centre_of_mass(self.turn, self.joint, plan.centre_offset, plan.mass)


@compiled
def _centre_of_mass(turn: Floats, joint: Floats, centre_offset: Floats, mass: Floats) -> Floats:
    out, total = np.zeros(3), 0.0
    for part in range(PART_COUNT):
        out += mass[part] * (joint[part] + one.turn(turn[part], centre_offset[part]))
        total += mass[part]
    return out / total


def pose_skeleton(plan: BodyPlan, root_position: Floats, root_orientation: Floats, joint_rotation: Floats) -> PosedSkeleton:
    """Forward kinematics: joint_rotation (14, 4) turns each part against its parent (child in parent frame)."""
    turn, joint = _pose(plan.joint_offset, root_position, root_orientation, joint_rotation)
    return PosedSkeleton(turn, joint, root_orientation, joint_rotation)


@compiled
def _pose(offset: Floats, root_position: Floats, root_orientation: Floats, joint_rotation: Floats) -> tuple[Floats, Floats]:
    turn = np.empty((PART_COUNT, 3, 3))
    joint = np.empty((PART_COUNT, 3))
    turn[0] = one.matrix(root_orientation)
    joint[0] = root_position
    for part in range(1, PART_COUNT):
        parent = _PARENT[part]
        turn[part] = one.product(turn[parent], one.matrix(joint_rotation[part - 1]))
        joint[part] = joint[parent] + one.turn(turn[parent], offset[part])
    return turn, joint


@compiled
def part_orientations(root_orientation: Floats, joint_rotation: Floats) -> Floats:
    """(15, 4) world orientations of the parts of a posed skeleton; joint_rotation (14, 4), child in parent frame."""
    orientation = np.empty((PART_COUNT, 4))
    orientation[0] = root_orientation
    for part in range(1, PART_COUNT):
        orientation[part] = one.multiply(orientation[_PARENT[part]], joint_rotation[part - 1])
    return orientation
