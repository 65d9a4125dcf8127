"""From posture channels and the pelvis path to the twenty joints: forward kinematics and the two-bone leg."""

import math
from dataclasses import dataclass

import numpy as np

from game import rotation_compiled as one
from game.compiled import compiled
from game.inputs.performance import person
from game.inputs.performance.script import ANKLE_X_M, SIDES, STANCE_Y_M, TOE_OUT_DEG, Side
from kinect.body import JOINT_COUNT, Floats, Joint

_LIMBS: dict[Side, tuple[float, tuple[Joint, ...], tuple[Joint, ...]]] = {
    "left": (
        1.0,
        (Joint.SHOULDER_LEFT, Joint.ELBOW_LEFT, Joint.WRIST_LEFT, Joint.HAND_LEFT),
        (Joint.HIP_LEFT, Joint.KNEE_LEFT, Joint.ANKLE_LEFT, Joint.FOOT_LEFT),
    ),
    "right": (
        -1.0,
        (Joint.SHOULDER_RIGHT, Joint.ELBOW_RIGHT, Joint.WRIST_RIGHT, Joint.HAND_RIGHT),
        (Joint.HIP_RIGHT, Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT, Joint.FOOT_RIGHT),
    ),
}


def rotation(axis: int, angle: Floats) -> Floats:
    """(T, 3, 3) rotations about x, y or z (0, 1, 2) by angle (T,), radians."""
    matrix = np.zeros((*np.shape(angle), 3, 3))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix[..., axis, axis] = 1.0
    matrix[..., i, i] = matrix[..., j, j] = np.cos(angle)
    matrix[..., j, i] = np.sin(angle)
    matrix[..., i, j] = -matrix[..., j, i]
    return matrix


def _orientation(channels: dict[str, Floats], part: str) -> Floats:
    yaw, pitch, roll = (rotation(axis, channels[f"{part}.{turn}"]) for axis, turn in ((2, "yaw"), (1, "pitch"), (0, "roll")))
    return yaw @ pitch @ roll


def _mirrored(vector: Floats, sign: float) -> Floats:
    return vector * np.array([1.0, sign, 1.0])


@dataclass(frozen=True)
class Figure:
    """A sampled posture whose pelvis has yet to be placed.

    body: (T, 20, 3) joints relative to HIP_CENTER, world axes, knees not filled in. feet: (T, 20, 3) ankles and feet in the world.
    knee_forward: (T, 2, 3) where each knee points, left first. pelvis_height: (T,).
    """

    body: Floats
    feet: Floats
    knee_forward: Floats
    pelvis_height: Floats

    def joints(self, pelvis: Floats) -> Floats:
        """(T, 20, 3) world joints for HIP_CENTER at pelvis (T, 3); legs by two-bone inverse kinematics; a leg out of reach is stretched."""
        world = self.body + pelvis[:, None, :]
        for index, side in enumerate(SIDES):
            hip, knee, ankle, foot = _LIMBS[side][2]
            world[:, ankle], world[:, foot] = self.feet[:, ankle], self.feet[:, foot]
            world[:, knee] = _knee(world[:, hip], world[:, ankle], self.knee_forward[:, index])
        return world


@compiled
def _knee(hip: Floats, ankle: Floats, forward: Floats) -> Floats:
    """(T, 3) knee of a leg of constant bone lengths, bent towards forward."""
    out, along, across = np.empty((len(hip), 3)), np.empty(3), np.empty(3)
    for t in range(len(hip)):
        for axis in range(3):
            along[axis] = ankle[t, axis] - hip[t, axis]
        reach = one.length(along)
        up_thigh = (reach * reach + person.THIGH_M**2 - person.SHIN_M**2) / (2.0 * reach)
        off_line = math.sqrt(max(person.THIGH_M**2 - up_thigh * up_thigh, 0.0))
        for axis in range(3):
            along[axis] /= reach
        ahead = one.dot(forward[t], along)
        for axis in range(3):
            across[axis] = forward[t, axis] - ahead * along[axis]
        size = one.length(across)
        for axis in range(3):
            out[t, axis] = hip[t, axis] + up_thigh * along[axis] + off_line * (across[axis] / size)
    return out


def pose_figure(channels: dict[str, Floats]) -> Figure:
    """The figure for sampled channels (`Script.sample`)."""
    count = len(channels["zmp.x"])
    body = np.zeros((count, JOINT_COUNT, 3))
    feet = np.zeros((count, JOINT_COUNT, 3))
    knee_forward = np.zeros((count, 2, 3))
    pelvis, trunk, head = (_orientation(channels, part) for part in ("pelvis", "trunk", "head"))
    spine = pelvis @ person.SPINE_IN_PELVIS
    body[:, Joint.SPINE] = spine
    body[:, Joint.SHOULDER_CENTER] = spine + trunk @ person.NECK_IN_TRUNK
    body[:, Joint.HEAD] = body[:, Joint.SHOULDER_CENTER] + head @ person.HEAD_ABOVE_NECK
    for index, side in enumerate(SIDES):
        sign, arm, leg = _LIMBS[side]
        body[:, arm[0]] = spine + trunk @ _mirrored(person.SHOULDER_IN_TRUNK, sign)
        _place_arm(body, channels, side, sign, trunk, arm)
        body[:, leg[0]] = pelvis @ _mirrored(person.HIP_IN_PELVIS, sign)
        foot = _place_foot(feet, channels, side, sign, leg)
        knee_forward[:, index] = 0.5 * (foot[..., 0] + pelvis[..., 0])
    return Figure(body, feet, knee_forward, channels["pelvis.height"])


def _place_arm(body: Floats, channels: dict[str, Floats], side: Side, sign: float, trunk: Floats, arm: tuple[Joint, ...]) -> None:
    flex, out, twist, bend = (channels[f"{side}.{turn}"] for turn in ("flex", "side", "twist", "elbow"))
    upper = trunk @ rotation(1, -flex) @ rotation(0, sign * out) @ rotation(2, sign * twist)
    lower = upper @ rotation(1, -bend)
    shoulder, elbow, wrist, hand = arm
    body[:, elbow] = body[:, shoulder] - person.UPPER_ARM_M * upper[..., 2]
    body[:, wrist] = body[:, elbow] - person.FOREARM_M * lower[..., 2]
    body[:, hand] = body[:, wrist] - person.HAND_M * lower[..., 2]


def ball_of_foot(channels: dict[str, Floats], side: Side) -> tuple[Floats, Floats]:
    """(T, 3) ball of the foot on the sole, world, and (T, 3, 3) the foot's orientation."""
    sign = _LIMBS[side][0]
    yaw = np.radians(-TOE_OUT_DEG) * -sign
    heading = np.array([np.cos(yaw), np.sin(yaw)])
    ball = np.stack(
        [
            ANKLE_X_M + person.BALL_AHEAD_M * heading[0] + channels[f"{side}.forward"],
            sign * (STANCE_Y_M + channels[f"{side}.out"]) + person.BALL_AHEAD_M * heading[1],
            channels[f"{side}.lift"],
        ],
        axis=-1,
    )
    return ball, rotation(2, np.full(len(ball), yaw)) @ rotation(1, channels[f"{side}.tilt"])


def _place_foot(feet: Floats, channels: dict[str, Floats], side: Side, sign: float, leg: tuple[Joint, ...]) -> Floats:
    ball, foot = ball_of_foot(channels, side)
    feet[:, leg[2]] = ball + foot @ np.array([-person.BALL_AHEAD_M, 0.0, person.ANKLE_HEIGHT_M])
    feet[:, leg[3]] = ball + foot @ np.array([0.0, 0.0, person.FOOT_JOINT_HEIGHT_M])
    return foot
