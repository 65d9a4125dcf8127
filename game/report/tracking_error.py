"""How far the character is from its target and from the input it was made of (thesis 4.2 and 4.3)."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game import rotation_compiled as one
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import END_EFFECTOR_PARTS, JOINTS
from game.compiled import compiled
from game.target.forward_kinematics import PosedSkeleton, pose_skeleton
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

_WITHOUT_WRISTS = np.array([not name.startswith("wrist") for name in JOINTS])
_WITHOUT_ENDS = np.array([not name.startswith(("wrist", "ankle")) for name in JOINTS])
_EFFECTORS = list(END_EFFECTOR_PARTS)


class PosedBody(Protocol):
    """What is measured of a character, world frame; physics implements it as `BodyDynamics`."""

    @property
    def orientation(self) -> Floats:
        """(15, 4) of the parts."""
        ...

    @property
    def joint(self) -> Floats:
        """(15, 3) joint centres, row 0 the root point, metres."""
        ...


@compiled
def in_heading(points: Floats, root_position: Floats, root_orientation: Floats) -> Floats:
    """Points (n, 3) relative to the root, turned so that its heading is along x: neither place nor direction in the room counts."""
    heading = one.matrix(one.about_z(one.yaw(root_orientation)))
    out = np.empty((len(points), 3))
    for i in range(len(points)):
        out[i] = one.turn_back(heading, points[i] - root_position)
    return out


@compiled
def _mean_angles(own: Floats, wanted: Floats, heading_rad: float) -> Floats:
    """(n,) mean absolute angle of the three axes between orientations (n, 4), the wanted ones first turned about the vertical."""
    heading = one.about_z(heading_rad)
    out = np.empty(len(own))
    for i in range(len(own)):
        error = one.log(one.multiply(one.conjugate(own[i]), one.multiply(heading, wanted[i])))
        out[i] = (abs(error[0]) + abs(error[1]) + abs(error[2])) / 3.0
    return out


class TrackingError:
    """Means over samples at 30 Hz while upright. Against the processed target wrists are left out of joint errors, as in the thesis;
    against the mapped input the ankles too, since the balance strategy owns them. End-effectors: all five, relative to the root."""

    def __init__(self, plan: BodyPlan) -> None:
        self._plan = plan
        self._samples = 0
        self._sums = {"target": np.zeros((2, 14)), "mapped": np.zeros((2, 14))}
        self._effector = {"target": np.zeros(5), "mapped": np.zeros(5)}

    def sample(self, body: PosedBody, joint_rotation: Floats, target: KinematicTarget) -> None:
        """One frame of the character against its target; joint_rotation (14, 4) is the character's own."""
        self._samples += 1
        mapped = target.mapped
        mapped_pose = pose_skeleton(self._plan, mapped.root_position, mapped.root_orientation, mapped.joint_rotation)
        own = in_heading(body.joint[_EFFECTORS], body.joint[0], body.orientation[0])
        self._add("target", body, joint_rotation, target.pose, target.joint_rotation)
        self._add("mapped", body, joint_rotation, mapped_pose, mapped.joint_rotation)
        at_target = in_heading(target.pose.joint[_EFFECTORS], target.root_position, target.root_orientation)
        at_input = in_heading(mapped.end_effector, mapped.root_position, mapped.root_orientation)
        for key, place in (("target", at_target), ("mapped", at_input)):
            self._effector[key] += np.sqrt(np.sum((own - place) ** 2, axis=1))

    def _add(self, key: str, body: PosedBody, joint_rotation: Floats, pose: PosedSkeleton, rotations: Floats) -> None:
        self._sums[key][0] += _mean_angles(joint_rotation, rotations, 0.0)
        heading = rotation.yaw(body.orientation[0]) - rotation.yaw(pose.orientation[0])
        self._sums[key][1] += _mean_angles(body.orientation[1:], pose.orientation[1:], heading)

    def summary(self) -> dict[str, float | str | None]:
        """The report's entries; None where nothing was sampled."""
        out: dict[str, float | str | None] = {}
        for key, counted, suffix in (("target", _WITHOUT_WRISTS, ""), ("mapped", _WITHOUT_ENDS, "_vs_mapped")):
            if self._samples == 0:
                out |= dict.fromkeys((f"joint_error_parent_rad{suffix}", f"joint_error_world_rad{suffix}", f"end_effector_error_m{suffix}"))
                out[f"worst_joint{suffix}"] = None
                continue
            parent, world = self._sums[key] / self._samples
            out[f"joint_error_parent_rad{suffix}"] = float(parent[counted].mean())
            out[f"joint_error_world_rad{suffix}"] = float(world[counted].mean())
            out[f"worst_joint{suffix}"] = JOINTS[int(np.argmax(np.where(counted, parent, -1.0)))]
            out[f"end_effector_error_m{suffix}"] = float(self._effector[key].mean() / self._samples)
        return out
