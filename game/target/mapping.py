"""From twenty sensed joints to the character's joint orientations: parent-child pairs with fixed offsets (thesis 3.3.2)."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import PARENT, PART_COUNT, PARTS
from game.compiled import compiled
from kinect.body import Joint

if TYPE_CHECKING:
    from game.target.calibration import Calibration

Floats = NDArray[np.float64]

_BONE = {
    "pelvis": (Joint.HIP_CENTER, Joint.SPINE),
    "trunk": (Joint.SPINE, Joint.SHOULDER_CENTER),
    "head": (Joint.SHOULDER_CENTER, Joint.HEAD),
    "upper_arm_left": (Joint.SHOULDER_LEFT, Joint.ELBOW_LEFT),
    "lower_arm_left": (Joint.ELBOW_LEFT, Joint.WRIST_LEFT),
    "hand_left": (Joint.WRIST_LEFT, Joint.HAND_LEFT),
    "upper_arm_right": (Joint.SHOULDER_RIGHT, Joint.ELBOW_RIGHT),
    "lower_arm_right": (Joint.ELBOW_RIGHT, Joint.WRIST_RIGHT),
    "hand_right": (Joint.WRIST_RIGHT, Joint.HAND_RIGHT),
    "upper_leg_left": (Joint.HIP_LEFT, Joint.KNEE_LEFT),
    "lower_leg_left": (Joint.KNEE_LEFT, Joint.ANKLE_LEFT),
    "foot_left": (Joint.ANKLE_LEFT, Joint.FOOT_LEFT),
    "upper_leg_right": (Joint.HIP_RIGHT, Joint.KNEE_RIGHT),
    "lower_leg_right": (Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT),
    "foot_right": (Joint.ANKLE_RIGHT, Joint.FOOT_RIGHT),
}
_FROM = np.array([_BONE[name][0] for name in PARTS])
_TO = np.array([_BONE[name][1] for name in PARTS])
_HIP_LEFT, _HIP_RIGHT, _SPINE = int(Joint.HIP_LEFT), int(Joint.HIP_RIGHT), int(Joint.SPINE)
_SHOULDER_LEFT, _SHOULDER_RIGHT, _SHOULDER_CENTER = int(Joint.SHOULDER_LEFT), int(Joint.SHOULDER_RIGHT), int(Joint.SHOULDER_CENTER)
_PARENT = np.array(PARENT)


@compiled
def bone_directions(joints: Floats) -> Floats:
    """(15, 3) unit direction of the sensed bone that stands for each part; joints (20, 3)."""
    out = np.empty((PART_COUNT, 3))
    for part in range(PART_COUNT):
        out[part] = one.normalise(joints[_TO[part]] - joints[_FROM[part]])
    return out


@compiled
def pelvis_orientation(joints: Floats) -> Floats:
    """(4,) orientation of the sensed pelvis: y from the right to the left hip exactly, up towards the spine."""
    y = one.normalise(joints[_HIP_LEFT] - joints[_HIP_RIGHT])
    up = joints[_SPINE] - 0.5 * (joints[_HIP_LEFT] + joints[_HIP_RIGHT])
    return one.from_axes(y, up - one.dot(up, y) * y)


@compiled
def trunk_orientation(joints: Floats) -> Floats:
    """(4,) orientation of the sensed trunk: up from spine to shoulder centre exactly, y towards the left shoulder."""
    return one.from_axes(joints[_SHOULDER_LEFT] - joints[_SHOULDER_RIGHT], joints[_SHOULDER_CENTER] - joints[_SPINE])


def map_orientations(joints: Floats, calibration: "Calibration") -> tuple[Floats, Floats]:
    """Root orientation (4,) and joint rotations (14, 4), child in parent frame, from joints (20, 3) in the world frame.

    Pelvis and trunk follow two directions each; every other part swings its idle direction to the sensed bone, without twist.
    """
    return mapped_orientations(joints, calibration.pelvis, calibration.trunk, calibration.idle_direction)


@compiled
def mapped_orientations(joints: Floats, pelvis: Floats, trunk: Floats, idle: Floats) -> tuple[Floats, Floats]:
    """`map_orientations` with the fields of the calibration."""
    direction = bone_directions(joints)
    root = one.multiply(pelvis_orientation(joints), pelvis)
    local = np.empty((PART_COUNT - 1, 4))
    local[0] = one.multiply(one.conjugate(root), one.multiply(trunk_orientation(joints), trunk))
    turn = np.empty((PART_COUNT, 3, 3))
    turn[0] = one.matrix(root)
    turn[1] = one.product(turn[0], one.matrix(local[0]))
    for part in range(2, PART_COUNT):
        of_parent = turn[_PARENT[part]]
        local[part - 1] = one.between(idle[part], one.turn_back(of_parent, direction[part]))
        turn[part] = one.product(of_parent, one.matrix(local[part - 1]))
    return root, local


def map_positions(joints: Floats, calibration: "Calibration") -> Floats:
    """Sensed joints (20, 3), world frame, scaled to the character's size, its floor and its starting place."""
    return mapped_positions(joints, calibration.scale, calibration.origin, calibration.rise_m)


@compiled
def mapped_positions(joints: Floats, scale: float, origin: Floats, rise_m: float) -> Floats:
    """`map_positions` with the fields of the calibration."""
    placed = scale * (joints - origin)
    placed[:, 2] += rise_m
    return placed
