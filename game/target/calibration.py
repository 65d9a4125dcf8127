"""Fitting the character's skeleton to a player who stands quietly for half a second (thesis 3.3.2: fixed angular offsets)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import PARTS
from game.target.mapping import bone_directions, pelvis_orientation, trunk_orientation
from kinect.body import Joint

Floats = NDArray[np.float64]

QUIET_S = 0.5
STRAIGHT_RAD = 0.35
"""A calibrated leg direction farther than this from straight down is not quiet standing and is left uncalibrated."""

OFFSET_LIMIT_M = 0.12
"""A sensed hip or shoulder centre farther than this from the character's is not a matter of build; the rest stays."""

_STEADY = [Joint.HIP_CENTER, Joint.SPINE, Joint.SHOULDER_CENTER, Joint.KNEE_LEFT, Joint.KNEE_RIGHT, Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]


@dataclass(frozen=True)
class Calibration:
    """What turns a player's joints into the character's pose.

    scale: character metres per player metre; pelvis, trunk (4,): offsets from measured to part orientation;
    idle_direction (15, 3): the measured bone direction, in the parent's frame, that stands for the idle pose;
    origin (3,): the player's place on the floor, world metres before scaling; rise_m: added to scaled heights;
    root_offset (3,): from the scaled hip centre to the character's root point, in the pelvis frame;
    neck_offset, shoulder_offset (3,), (2, 3): from the scaled shoulder centre to the character's neck joint, and from each
    scaled shoulder to the character's (left, right), in the trunk frame: the wrists' targets move along with their shoulders.
    """

    scale: float
    pelvis: Floats
    trunk: Floats
    idle_direction: Floats
    origin: Floats
    rise_m: float
    root_offset: Floats
    neck_offset: Floats
    shoulder_offset: Floats


def quietest_stretch(time_s: Floats, positions: Floats, length_s: float = QUIET_S) -> slice:
    """The frames of the stretch of `length_s` in which an upright player (T, 20, 3, world frame) moves least.

    Trunk and legs decide; stretches with a bent trunk, bent knees or lifted feet are passed over while better ones exist.
    """
    count = len(time_s)
    span = max(2, round(length_s / max(float(np.median(np.diff(time_s))), 1e-3))) if count > 2 else count
    if count <= span:
        return slice(0, count)
    steady = positions[:, _STEADY]
    speed = np.sqrt(np.sum(np.diff(steady, axis=0) ** 2, axis=2)).mean(axis=1)
    cost = np.append(speed, speed[-1]) / 0.005 + _bent(positions)
    cost = np.where(np.isfinite(cost), cost, 1e6)
    running = np.convolve(cost, np.ones(span) / span, mode="valid")
    start = int(np.argmin(running))
    return slice(start, start + span)


def _bent(positions: Floats) -> Floats:
    """(T,) how far each frame is from upright standing, in arbitrary units: 0.1 rad or 2 cm count 1."""

    def lean(top: Joint, bottom: Joint) -> Floats:
        d = positions[:, top] - positions[:, bottom]
        return np.arccos(np.clip(d[:, 2] / np.maximum(np.linalg.norm(d, axis=1), 1e-9), -1.0, 1.0))

    angles = (
        lean(Joint.SHOULDER_CENTER, Joint.HIP_CENTER)
        + lean(Joint.HIP_LEFT, Joint.KNEE_LEFT)
        + lean(Joint.HIP_RIGHT, Joint.KNEE_RIGHT)
        + lean(Joint.KNEE_LEFT, Joint.ANKLE_LEFT)
        + lean(Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT)
    )
    lifted = np.abs(positions[:, Joint.ANKLE_LEFT, 2] - positions[:, Joint.ANKLE_RIGHT, 2])
    return angles / 0.1 + lifted / 0.02


def calibrate(plan: BodyPlan, standing: Floats) -> Calibration:
    """Calibration from frames of quiet standing, (T, 20, 3) world frame; their median is taken."""
    joints = np.median(standing, axis=0)

    def bone(a: Joint, b: Joint) -> float:
        return float(np.median(np.linalg.norm(standing[:, a] - standing[:, b], axis=1)))

    leg = 0.5 * (
        bone(Joint.HIP_LEFT, Joint.KNEE_LEFT)
        + bone(Joint.KNEE_LEFT, Joint.ANKLE_LEFT)
        + bone(Joint.HIP_RIGHT, Joint.KNEE_RIGHT)
        + bone(Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT)
    )
    hip, ankle = PARTS.index("upper_leg_left"), PARTS.index("foot_left")
    own_leg = float(plan.joint[hip, 2] - plan.joint[ankle, 2])
    scale = own_leg / max(leg, 0.2)

    measured_pelvis = pelvis_orientation(joints)
    upright = rotation.about_z(rotation.yaw(measured_pelvis))
    pelvis = rotation.multiply(rotation.conjugate(measured_pelvis), upright)
    trunk = rotation.multiply(rotation.conjugate(trunk_orientation(joints)), upright)

    idle = _idle_directions(plan)
    measured = bone_directions(joints)
    legs = [i for i, name in enumerate(PARTS) if "leg" in name or "foot" in name or name == "head"]
    seen = rotation.unrotate(upright, measured[legs])
    # a standing foot is flat, however steeply the sensor sees the line from ankle to toes
    limit = np.where([PARTS[i].startswith("foot") for i in legs], np.pi, STRAIGHT_RAD)
    near = np.sum(seen * idle[legs], axis=1) > np.cos(limit)
    calibrated = idle.copy()
    calibrated[legs] = np.where(near[:, None], seen, idle[legs])

    ankles = joints[[Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]]
    rise = float(plan.joint[ankle, 2]) - scale * float(ankles[:, 2].mean())
    origin = np.array([*ankles[:, :2].mean(axis=0), 0.0])

    def offset(part: str, sensed: Joint) -> Floats:
        mapped = scale * (joints[sensed] - origin) + np.array([0.0, 0.0, rise])
        idle_place = rotation.rotate(upright, plan.joint[PARTS.index(part)])
        return _clamped(rotation.unrotate(upright, idle_place - mapped), OFFSET_LIMIT_M)

    root_offset = offset("pelvis", Joint.HIP_CENTER)
    neck_offset = offset("head", Joint.SHOULDER_CENTER)
    shoulders = np.stack((offset("upper_arm_left", Joint.SHOULDER_LEFT), offset("upper_arm_right", Joint.SHOULDER_RIGHT)))
    return Calibration(scale, pelvis, trunk, calibrated, origin, rise, root_offset, neck_offset, shoulders)


def _clamped(offset: Floats, limit_m: float) -> Floats:
    return np.clip(offset, -limit_m, limit_m)


def _idle_directions(plan: BodyPlan) -> Floats:
    """(15, 3) direction of each part's bone in the idle pose: straight down, the head up, the feet forward."""
    idle = np.tile([0.0, 0.0, -1.0], (len(PARTS), 1))
    for i, name in enumerate(PARTS):
        if name in ("pelvis", "trunk", "head"):
            idle[i] = (0.0, 0.0, 1.0)
        elif name.startswith("foot"):
            idle[i] = (1.0, 0.0, 0.0)
    return idle
