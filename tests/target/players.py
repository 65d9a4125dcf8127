"""Players who are copies of a character, of any size and standing anywhere, and what a sensor sees of them."""

from dataclasses import dataclass

import numpy as np

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import JOINTS, PARTS
from game.rotation import Floats
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from kinect.body import Joint

_SENSED = {
    Joint.HIP_CENTER: "pelvis",
    Joint.SPINE: "trunk",
    Joint.SHOULDER_CENTER: "head",
    **{
        Joint[f"{joint}_{side.upper()}"]: f"{part}_{side}"
        for side in ("left", "right")
        for joint, part in (
            ("SHOULDER", "upper_arm"),
            ("ELBOW", "lower_arm"),
            ("WRIST", "hand"),
            ("HIP", "upper_leg"),
            ("KNEE", "lower_leg"),
            ("ANKLE", "foot"),
        )
    },
}
_TIPS = {
    Joint.HEAD: ("head", (0.0, 0.0, 0.2)),
    Joint.HAND_LEFT: ("hand_left", (0.0, 0.0, -0.1)),
    Joint.HAND_RIGHT: ("hand_right", (0.0, 0.0, -0.1)),
    Joint.FOOT_LEFT: ("foot_left", (0.15, 0.0, 0.0)),
    Joint.FOOT_RIGHT: ("foot_right", (0.15, 0.0, 0.0)),
}
NO_TURN: Floats = np.tile(rotation.IDENTITY, (len(JOINTS), 1))


def seen_joints(pose: PosedSkeleton) -> Floats:
    """(20, 3) world places of the twenty sensed joints of a posed character, metres."""
    joints = np.empty((20, 3))
    for joint, part in _SENSED.items():
        joints[joint] = pose.joint[PARTS.index(part)]
    for joint, (part, tip) in _TIPS.items():
        i = PARTS.index(part)
        joints[joint] = pose.joint[i] + pose.turn[i] @ np.array(tip)
    return joints


@dataclass(frozen=True)
class Player:
    """A copy of a character `size` times as large, who came to stand at `place` (2,) m, turned by heading_rad."""

    plan: BodyPlan
    size: float = 1.0
    heading_rad: float = 0.0
    place: tuple[float, float] = (0.0, 0.0)

    def joints(self, pose: PosedSkeleton) -> Floats:
        """(20, 3) what is seen of the player in a pose of the character."""
        turned = rotation.rotate(rotation.about_z(self.heading_rad), self.size * seen_joints(pose))
        return turned + np.array([*self.place, 0.0])

    def standing(self) -> Floats:
        """(15, 20, 3) half a second of quiet standing."""
        return np.repeat(self.joints(idle(self.plan))[None], 15, axis=0)


def idle(plan: BodyPlan) -> PosedSkeleton:
    return pose_skeleton(plan, plan.joint[0], rotation.IDENTITY, NO_TURN)


def any_pose(plan: BodyPlan, seed: int, wildness: float = 0.5) -> PosedSkeleton:
    """A random pose about a random root; joint rotation vectors have `wildness` rad standard deviation an axis."""
    rng = np.random.default_rng(seed)
    root = rotation.exp(rng.normal(scale=0.4, size=3))
    return pose_skeleton(plan, plan.joint[0] + rng.normal(scale=0.2, size=3), root, rotation.exp(rng.normal(scale=wildness, size=(14, 3))))


def untwisted(pose: PosedSkeleton, plan: BodyPlan) -> PosedSkeleton:
    """The pose with no limb or head turned about its own length against its parent; pelvis and trunk as they are."""
    rotations = pose.joint_rotation.copy()
    for i, name in enumerate(JOINTS):
        if name != "spine":
            bone = np.array([1.0, 0.0, 0.0] if name.startswith("ankle") else [0.0, 0.0, 1.0 if name == "neck" else -1.0])
            rotations[i] = rotation.between(bone, rotation.rotate(rotations[i], bone))
    return pose_skeleton(plan, pose.joint[0], pose.root_orientation, rotations)
