"""Where every part of a posed skeleton is, and its centre of mass."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import LEVELS, PART_COUNT

Floats = NDArray[np.float64]


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
        orientation = np.empty((PART_COUNT, 4))
        orientation[0] = self.root_orientation
        for parts, parents in LEVELS:
            orientation[parts] = rotation.multiply(orientation[parents], self.joint_rotation[parts - 1])
        return orientation

    def box_centres(self, plan: BodyPlan) -> Floats:
        """(15, 3) centres of the boxes, world frame."""
        return self.joint + rotation.turn(self.turn, plan.centre_offset)

    def centre_of_mass(self, plan: BodyPlan) -> Floats:
        """(3,) centre of mass, world frame."""
        return plan.mass @ self.box_centres(plan) / plan.total_mass


def pose_skeleton(plan: BodyPlan, root_position: Floats, root_orientation: Floats, joint_rotation: Floats) -> PosedSkeleton:
    """Forward kinematics: joint_rotation (14, 4) turns each part against its parent (child in parent frame)."""
    local = rotation.matrix(joint_rotation)
    turn = np.empty((PART_COUNT, 3, 3))
    joint = np.empty((PART_COUNT, 3))
    turn[0] = rotation.matrix(root_orientation)
    joint[0] = root_position
    for parts, parents in LEVELS:
        of_parent = turn[parents]
        turn[parts] = of_parent @ local[parts - 1]
        joint[parts] = joint[parents] + rotation.turn(of_parent, plan.joint_offset[parts])
    return PosedSkeleton(turn, joint, root_orientation, joint_rotation)
