"""The skeleton's vocabulary: fifteen parts, fourteen ball joints, five end-effectors (thesis Fig. 3 and section 3.3.3)."""

from typing import Final

import numpy as np

PARTS: Final = (
    "pelvis",
    "trunk",
    "head",
    "upper_arm_left",
    "lower_arm_left",
    "hand_left",
    "upper_arm_right",
    "lower_arm_right",
    "hand_right",
    "upper_leg_left",
    "lower_leg_left",
    "foot_left",
    "upper_leg_right",
    "lower_leg_right",
    "foot_right",
)
"""Depth first, root first: also the order of MuJoCo's bodies and degrees of freedom."""

PARENT: Final = (-1, 0, 1, 1, 3, 4, 1, 6, 7, 0, 9, 10, 0, 12, 13)
"""Index of each part's parent; -1 for the root."""

JOINTS: Final = (
    "spine",
    "neck",
    "shoulder_left",
    "elbow_left",
    "wrist_left",
    "shoulder_right",
    "elbow_right",
    "wrist_right",
    "hip_left",
    "knee_left",
    "ankle_left",
    "hip_right",
    "knee_right",
    "ankle_right",
)
"""Joint j carries part j + 1."""

PART_COUNT: Final = len(PARTS)
JOINT_COUNT: Final = len(JOINTS)
DOF_COUNT: Final = 6 + 3 * JOINT_COUNT

SPINE: Final = JOINTS.index("spine")
ANKLES: Final = (JOINTS.index("ankle_left"), JOINTS.index("ankle_right"))
WRISTS: Final = (JOINTS.index("wrist_left"), JOINTS.index("wrist_right"))
LEG_JOINTS: Final = tuple(JOINTS.index(f"{joint}_{side}") for side in ("left", "right") for joint in ("hip", "knee", "ankle"))
FEET: Final = (PARTS.index("foot_left"), PARTS.index("foot_right"))

END_EFFECTORS: Final = ("ankle_left", "ankle_right", "wrist_left", "wrist_right", "neck")
"""Joint centres whose place the inverse kinematics tracks."""

END_EFFECTOR_PARTS: Final = tuple(JOINTS.index(name) + 1 for name in END_EFFECTORS)
"""The part that hangs on each end-effector's joint: the joint centre is that part's origin."""


def _levels() -> tuple[tuple[np.ndarray, np.ndarray], ...]:
    depth = [0] * PART_COUNT
    for part in range(1, PART_COUNT):
        depth[part] = depth[PARENT[part]] + 1
    rows = []
    for level in range(1, max(depth) + 1):
        parts = np.array([p for p in range(PART_COUNT) if depth[p] == level])
        rows.append((parts, np.array([PARENT[p] for p in parts])))
    return tuple(rows)


LEVELS: Final = _levels()
"""(parts, their parents) level by level from the root outwards: forward kinematics in four vectorised steps."""


def is_ancestor(part: int, of: int) -> bool:
    """True where `part` lies on the way from the root to `of`, `of` included."""
    while of >= 0:
        if of == part:
            return True
        of = PARENT[of]
    return False
