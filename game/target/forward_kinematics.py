"""Where every part of a posed skeleton is, and its centre of mass."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import LEVELS, PART_COUNT

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class PosedSkeleton:
    """World pose of the parts: orientation (15, 4), joint (15, 3) joint centres (row 0 the root point), metres."""

    orientation: Floats
    joint: Floats

    def box_centres(self, plan: BodyPlan) -> Floats:
        """(15, 3) centres of the boxes, world frame."""
        return self.joint + rotation.rotate(self.orientation, plan.centre_offset)

    def centre_of_mass(self, plan: BodyPlan) -> Floats:
        """(3,) centre of mass, world frame."""
        return plan.mass @ self.box_centres(plan) / plan.total_mass


def pose_skeleton(plan: BodyPlan, root_position: Floats, root_orientation: Floats, joint_rotation: Floats) -> PosedSkeleton:
    """Forward kinematics: joint_rotation (14, 4) turns each part against its parent (child in parent frame)."""
    orientation = np.empty((PART_COUNT, 4))
    joint = np.empty((PART_COUNT, 3))
    orientation[0] = root_orientation
    joint[0] = root_position
    for parts, parents in LEVELS:
        of_parent = orientation[parents]
        orientation[parts] = rotation.multiply(of_parent, joint_rotation[parts - 1])
        joint[parts] = joint[parents] + rotation.rotate(of_parent, plan.joint_offset[parts])
    return PosedSkeleton(orientation, joint)
