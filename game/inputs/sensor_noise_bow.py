"""The hips sink in a bow: a trunk bent over hides them, and the sensor's skeleton follows the folded silhouette.

Measured in real bows: with the trunk at 60 to 100 degrees HipCenter, Spine and both hips sink together by 0.13 to
0.5 m although the knees are nearly straight; the knees sink by a third of that, ankles and shoulders stay.
"""

import math
from typing import Final

import numpy as np

from game import rotation_compiled as one
from game.compiled import compiled
from kinect.body import JOINT_COUNT, Floats, Joint

_STARTS_RAD: Final = math.radians(40.0)
_DROP_M_PER_RAD: Final = 0.40
_LEAST_THIGH: Final = 0.35  # hips never sink below this share of their height above the knees


_ROOT, _NECK = int(Joint.HIP_CENTER), int(Joint.SHOULDER_CENTER)
_HIPS = (int(Joint.HIP_LEFT), int(Joint.HIP_RIGHT))
_KNEES = (int(Joint.KNEE_LEFT), int(Joint.KNEE_RIGHT))


def _shares() -> Floats:
    shares = np.zeros(JOINT_COUNT)
    shares[[Joint.HIP_CENTER, Joint.SPINE, Joint.HIP_LEFT, Joint.HIP_RIGHT]] = 1.0
    shares[[Joint.KNEE_LEFT, Joint.KNEE_RIGHT]] = 0.3
    return shares


_SHARES: Final[Floats] = _shares()


@compiled
def hip_drop(positions: Floats, up: Floats) -> Floats:
    """Displacement of every joint at scale 1, (20, 3) metres, from the true pose (20, 3) and the unit up direction (3,)."""
    out = np.zeros((JOINT_COUNT, 3))
    trunk = positions[_NECK] - positions[_ROOT]
    length = one.length(trunk)
    if not length > 1e-6:
        return out
    pitch = math.acos(min(max(one.dot(trunk, up) / length, -1.0), 1.0))
    if pitch <= _STARTS_RAD:
        return out
    hips = 0.5 * (positions[_HIPS[0]] + positions[_HIPS[1]])
    knees = 0.5 * (positions[_KNEES[0]] + positions[_KNEES[1]])
    room = (1.0 - _LEAST_THIGH) * max(0.0, one.dot(hips - knees, up))
    drop = min(_DROP_M_PER_RAD * (pitch - _STARTS_RAD), room / (1.0 - _SHARES[_KNEES[0]]))
    for joint in range(JOINT_COUNT):
        for axis in range(3):
            out[joint, axis] = -drop * _SHARES[joint] * up[axis]
    return out
