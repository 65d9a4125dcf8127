"""Poses to go through on the way up from the floor: a data file that a search writes, read once."""

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.assets import asset
from game.characters.joint_limits import HIGH, LOW
from game.characters.skeleton import JOINT_COUNT, JOINTS

Floats = NDArray[np.float64]

ROUTES = "side", "supine", "prone"
"""From the right side and from the back over to the front, and from there up."""

KEY_POSES = "getting_up.toml"


@dataclass(frozen=True)
class KeyPose:
    """joints (14, 3) rad, rotation vectors child in parent; seconds: how long the way there takes."""

    joints: Floats
    seconds: float


_OTHER = [JOINTS.index(j.replace("left", "RIGHT").replace("right", "left").replace("RIGHT", "right")) for j in JOINTS]
_IN_MIRROR = np.array([-1.0, 1.0, -1.0])


def in_mirror(joints: Floats) -> Floats:
    """The pose (14, 3) of a body's mirror image."""
    return _IN_MIRROR * joints[_OTHER]


def pose_of(**turned: Sequence[float]) -> Floats:
    """(14, 3) in the unit given; `shoulder=` turns the left one, and the right one as in a mirror; `shoulder_right=` that one alone.

    What is not named is straight.
    """
    out = np.zeros((JOINT_COUNT, 3))
    for row, joint in enumerate(JOINTS):
        name, _, side = joint.partition("_")
        if name in turned:
            out[row] = turned[name]
            if side == "right":
                out[row] *= _IN_MIRROR
        if joint in turned:
            out[row] = turned[joint]
    return out


@cache
def key_poses() -> Mapping[str, tuple[KeyPose, ...]]:
    """Of each of the ROUTES, in order; every joint within its range."""
    with asset(KEY_POSES).open("rb") as file:
        rows = tomllib.load(file)
    return {route: tuple(_key_pose(dict(row)) for row in rows[route]) for route in ROUTES}


def _key_pose(row: dict[str, Any]) -> KeyPose:
    seconds = float(row.pop("seconds"))
    return KeyPose(np.clip(np.radians(pose_of(**row)), LOW, HIGH), seconds)
