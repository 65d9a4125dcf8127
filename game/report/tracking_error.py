"""How far the character is from its target and from the input it was made of (thesis 4.2 and 4.3)."""

import math
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import END_EFFECTOR_PARTS, JOINTS
from game.compiled import compiled
from game.target.forward_kinematics import part_orientations
from game.target.kinematic_target import KinematicTarget

Floats = NDArray[np.float64]

_WITHOUT_WRISTS = np.array([not name.startswith("wrist") for name in JOINTS])
_WITHOUT_ENDS = np.array([not name.startswith(("wrist", "ankle")) for name in JOINTS])
_EFFECTORS = np.array(END_EFFECTOR_PARTS)


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
def _add_mean_angles(own: Floats, wanted: Floats, heading_rad: float, sums: Floats) -> None:
    """Add to `sums` (n,) the mean absolute angle of the three axes between orientations (n, 4), the wanted turned about the vertical."""
    c, s, turned = math.cos(0.5 * heading_rad), math.sin(0.5 * heading_rad), np.empty(4)
    for i in range(len(own)):
        q = wanted[i]
        turned[0], turned[1], turned[2], turned[3] = c * q[0] - s * q[3], c * q[1] - s * q[2], c * q[2] + s * q[1], c * q[3] + s * q[0]
        x, y, z = one.turn_to(own[i], turned)
        sums[i] += (abs(x) + abs(y) + abs(z)) / 3.0


@compiled
def _add_errors(
    orientation: Floats, joint: Floats, rotation: Floats, root_position: Floats, root_orientation: Floats, wanted_rotation: Floats,
    wanted_effector: Floats, angles: Floats, distances: Floats,
) -> None:  # fmt: skip
    """Add one sample to the sums of angles (2, 14), parent frame and world, and of end-effector distances (5,).

    The body's orientation (15, 4), joint (15, 3), rotation (14, 4); the root and joint rotations (14, 4) it is held against, and the
    places wanted of its end-effectors (5, 3).
    """
    _add_mean_angles(rotation, wanted_rotation, 0.0, angles[0])
    wanted = part_orientations(root_orientation, wanted_rotation)
    _add_mean_angles(orientation[1:], wanted[1:], one.yaw(orientation[0]) - one.yaw(wanted[0]), angles[1])
    own = in_heading(joint[_EFFECTORS], joint[0], orientation[0])
    place = in_heading(wanted_effector, root_position, root_orientation)
    for i in range(len(own)):
        distances[i] += one.length(own[i] - place[i])


class TrackingError:
    """Means over samples at 30 Hz while upright. Against the processed target wrists are left out of joint errors, as in the thesis;
    against the mapped input the ankles too, since the balance strategy owns them. End-effectors: all five, relative to the root."""

    def __init__(self) -> None:
        self._samples = 0
        self._sums = {"target": np.zeros((2, 14)), "mapped": np.zeros((2, 14))}
        self._effector = {"target": np.zeros(5), "mapped": np.zeros(5)}

    def sample(self, body: PosedBody, joint_rotation: Floats, target: KinematicTarget) -> None:
        """One frame of the character against its target; joint_rotation (14, 4) is the character's own."""
        self._samples += 1
        for key, pose, effector in (
            ("target", target, target.pose.joint[_EFFECTORS]),
            ("mapped", target.mapped, target.mapped.end_effector),
        ):
            _add_errors(
                body.orientation, body.joint, joint_rotation, pose.root_position, pose.root_orientation, pose.joint_rotation,
                effector, self._sums[key], self._effector[key],
            )  # fmt: skip

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
