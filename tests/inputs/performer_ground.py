"""What the floor knows of a performer: where the soles are, which bear, and how far inside them a point lies."""

from functools import cache

import numpy as np

from game.inputs.performance import person
from game.inputs.performance.repertoire import motion
from game.inputs.performance.script import SIDES, Side
from kinect.body import Floats, Joint

STEP_S = 1.0 / 240.0
CLIPS = ("waving", "leaning", "bowing", "reaching", "boxing", "stepping", "balancing", "jump")
ALL = (*CLIPS, "standing")
ANKLES: dict[Side, Joint] = {"left": Joint.ANKLE_LEFT, "right": Joint.ANKLE_RIGHT}
FEET: dict[Side, Joint] = {"left": Joint.FOOT_LEFT, "right": Joint.FOOT_RIGHT}
HEEL_TO_BALL = (person.BALL_AHEAD_M + person.HEEL_BEHIND_M) / (person.TOE_AHEAD_M + person.HEEL_BEHIND_M)


@cache
def performed(name: str) -> tuple[Floats, Floats]:
    """Times and (T, 20, 3) joints of a whole clip, eight samples a frame, twice as fine as the grid the path was solved on."""
    t = np.arange(0.0, motion(name).length_s, STEP_S)
    return t, motion(name).joints(t)


def rate(values: Floats) -> Floats:
    return np.gradient(values, STEP_S, axis=0)


def acceleration(values: Floats) -> Floats:
    """Central second differences, without the first and the last sample."""
    return (values[2:] - 2.0 * values[1:-1] + values[:-2]) / STEP_S**2


def bearing(name: str, side: Side) -> np.ndarray:
    """True where the script has that foot on the floor."""
    return motion(name).script.on_floor(performed(name)[0], side)


def sole(joints: Floats, side: Side) -> Floats:
    """(T, 4, 3) corners of a rigid sole, heel to toe tip, told from ankle and foot joint alone."""
    ankle, foot = joints[:, ANKLES[side]], joints[:, FEET[side]]
    across = np.cross([0.0, 0.0, 1.0], foot - ankle)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    slope = np.arctan2(person.BALL_AHEAD_M, person.ANKLE_HEIGHT_M - person.FOOT_JOINT_HEIGHT_M)
    line = (foot - ankle) / np.linalg.norm(foot - ankle, axis=1, keepdims=True)
    down = np.cos(slope) * line + np.sin(slope) * np.cross(across, line)
    ahead = np.cross(across, -down)
    corners = [
        ankle + person.ANKLE_HEIGHT_M * down + reach * ahead + side_step * across
        for reach in (-person.HEEL_BEHIND_M, person.TOE_AHEAD_M)
        for side_step in (-person.SOLE_WIDTH_M / 2, person.SOLE_WIDTH_M / 2)
    ]
    return np.stack(corners, axis=1)


def tilt(joints: Floats, side: Side) -> Floats:
    """(T,) pitch of the sole, radians, heel up positive."""
    corners = sole(joints, side)
    rise = corners[:, 0, 2] - corners[:, 2, 2]
    return np.arcsin(rise / np.linalg.norm(corners[:, 0] - corners[:, 2], axis=1))


def contact_points(name: str) -> list[Floats]:
    """For each sample the (K, 2) corners of the ground under the feet; a foot with its heel up bears on the ball and the toes."""
    _, joints = performed(name)
    points: list[list[Floats]] = [[] for _ in joints]
    for side in SIDES:
        corners, lifted = sole(joints, side)[..., :2], np.abs(tilt(joints, side)) > np.radians(0.5)
        for k in np.nonzero(bearing(name, side))[0]:
            quad = corners[k].copy()
            if lifted[k]:
                quad[:2] += HEEL_TO_BALL * (quad[2:] - quad[:2])
            points[k].extend(quad)
    return [np.array(each) for each in points]


def margin_inside(point: Floats, corners: Floats) -> float:
    """Distance from point to the edge of the convex hull of corners, metres, negative outside: by the hull's supporting lines."""
    ways = np.linspace(0.0, 2.0 * np.pi, 360, endpoint=False)
    normals = np.column_stack([np.cos(ways), np.sin(ways)])
    return float(np.min(np.max(corners @ normals.T, axis=0) - normals @ point))
