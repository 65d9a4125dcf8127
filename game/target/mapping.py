"""From twenty sensed joints to the character's joint orientations: parent-child pairs with fixed offsets (thesis 3.3.2)."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.skeleton import PARENT, PART_COUNT, PARTS
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
# pelvis and trunk are sensed by themselves, so the limbs hang on two known parts: three steps instead of four
_SWINGING = [
    (np.array([PARTS.index(name) for name in level]), np.array([PARENT[PARTS.index(name)] for name in level]))
    for level in (
        ("head", "upper_arm_left", "upper_arm_right", "upper_leg_left", "upper_leg_right"),
        ("lower_arm_left", "lower_arm_right", "lower_leg_left", "lower_leg_right"),
        ("hand_left", "hand_right", "foot_left", "foot_right"),
    )
]


def bone_directions(joints: Floats) -> Floats:
    """(15, 3) unit direction of the sensed bone that stands for each part; joints (20, 3)."""
    d = joints[_TO] - joints[_FROM]
    return d / np.maximum(np.sqrt(np.sum(d * d, axis=1, keepdims=True)), 1e-9)


def pelvis_orientation(joints: Floats) -> Floats:
    """(4,) orientation of the sensed pelvis: y from the right to the left hip exactly, up towards the spine."""
    y = joints[Joint.HIP_LEFT] - joints[Joint.HIP_RIGHT]
    up = joints[Joint.SPINE] - 0.5 * (joints[Joint.HIP_LEFT] + joints[Joint.HIP_RIGHT])
    y = y / max(float(np.sqrt(y @ y)), 1e-9)
    return rotation.from_axes(y, up - (up @ y) * y)


def trunk_orientation(joints: Floats) -> Floats:
    """(4,) orientation of the sensed trunk: up from spine to shoulder centre exactly, y towards the left shoulder."""
    y = joints[Joint.SHOULDER_LEFT] - joints[Joint.SHOULDER_RIGHT]
    return rotation.from_axes(y, joints[Joint.SHOULDER_CENTER] - joints[Joint.SPINE])


def map_orientations(joints: Floats, calibration: "Calibration") -> tuple[Floats, Floats]:
    """Root orientation (4,) and joint rotations (14, 4), child in parent frame, from joints (20, 3) in the world frame.

    Pelvis and trunk follow two directions each; every other part swings its idle direction to the sensed bone, without twist.
    """
    direction = bone_directions(joints)
    root = rotation.multiply(pelvis_orientation(joints), calibration.pelvis)
    trunk = rotation.multiply(trunk_orientation(joints), calibration.trunk)
    turn = np.empty((PART_COUNT, 3, 3))
    turn[:2] = rotation.matrix(np.array((root, trunk)))
    # where each bone points in its parent's frame; parents first
    seen = np.empty((PART_COUNT, 3))
    for parts, parents in _SWINGING:
        of_parent = turn[parents]
        seen[parts] = rotation.turn_back(of_parent, direction[parts])
        turn[parts] = of_parent @ rotation.swing_matrix(calibration.idle_direction[parts], seen[parts])
    local = np.empty((PART_COUNT - 1, 4))
    local[0] = rotation.multiply(rotation.conjugate(root), trunk)
    local[1:] = rotation.between(calibration.idle_direction[2:], seen[2:])
    return root, local


def map_positions(joints: Floats, calibration: "Calibration") -> Floats:
    """Sensed joints (20, 3), world frame, scaled to the character's size, its floor and its starting place."""
    placed = calibration.scale * (joints - calibration.origin)
    placed[:, 2] += calibration.rise_m
    return placed
