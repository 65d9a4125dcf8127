"""The vocabulary of a sensed body: the Kinect SDK's twenty joints, its bones, the floor plane, one frame.

Sensor frame, as in the Kinect SDK: x to the sensor's left, y up, z away from the sensor; metres.

            y (up)
            |  z (away, into the room)
            | /
    x ------+          seen from behind the sensor; a person who faces it
   (left)              has the right hand at larger x, the left hand at smaller x
"""

from dataclasses import dataclass
from enum import IntEnum
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Joint(IntEnum):
    """The 20 joints of the Kinect SDK 1.x, in its order. Left and right are the person's own."""

    HIP_CENTER = 0
    SPINE = 1
    SHOULDER_CENTER = 2
    HEAD = 3
    SHOULDER_LEFT = 4
    ELBOW_LEFT = 5
    WRIST_LEFT = 6
    HAND_LEFT = 7
    SHOULDER_RIGHT = 8
    ELBOW_RIGHT = 9
    WRIST_RIGHT = 10
    HAND_RIGHT = 11
    HIP_LEFT = 12
    KNEE_LEFT = 13
    ANKLE_LEFT = 14
    FOOT_LEFT = 15
    HIP_RIGHT = 16
    KNEE_RIGHT = 17
    ANKLE_RIGHT = 18
    FOOT_RIGHT = 19


JOINT_COUNT: Final = len(Joint)

BONES: Final[tuple[tuple[Joint, Joint], ...]] = (
    (Joint.HIP_CENTER, Joint.SPINE),
    (Joint.SPINE, Joint.SHOULDER_CENTER),
    (Joint.SHOULDER_CENTER, Joint.HEAD),
    (Joint.SHOULDER_CENTER, Joint.SHOULDER_LEFT),
    (Joint.SHOULDER_LEFT, Joint.ELBOW_LEFT),
    (Joint.ELBOW_LEFT, Joint.WRIST_LEFT),
    (Joint.WRIST_LEFT, Joint.HAND_LEFT),
    (Joint.SHOULDER_CENTER, Joint.SHOULDER_RIGHT),
    (Joint.SHOULDER_RIGHT, Joint.ELBOW_RIGHT),
    (Joint.ELBOW_RIGHT, Joint.WRIST_RIGHT),
    (Joint.WRIST_RIGHT, Joint.HAND_RIGHT),
    (Joint.HIP_CENTER, Joint.HIP_LEFT),
    (Joint.HIP_LEFT, Joint.KNEE_LEFT),
    (Joint.KNEE_LEFT, Joint.ANKLE_LEFT),
    (Joint.ANKLE_LEFT, Joint.FOOT_LEFT),
    (Joint.HIP_CENTER, Joint.HIP_RIGHT),
    (Joint.HIP_RIGHT, Joint.KNEE_RIGHT),
    (Joint.KNEE_RIGHT, Joint.ANKLE_RIGHT),
    (Joint.ANKLE_RIGHT, Joint.FOOT_RIGHT),
)
"""(parent, child) pairs, 19 of them, root first."""

LOST: Final = 0.0
INFERRED: Final = 0.5
TRACKED: Final = 1.0


class Floor(NamedTuple):
    """The plane a x + b y + c z + d = 0 in the sensor frame; (a, b, c) is unit and points up, d is the sensor's height (m)."""

    a: float
    b: float
    c: float
    d: float


@dataclass(frozen=True)
class BodyFrame:
    """One person as seen at one instant.

    time_s: capture time, seconds on the source's clock.
    positions: (20, 3) joint positions, metres, sensor frame, `Joint` order. May hold NaN where nothing was seen.
    confidence: (20,) 0 lost, 0.5 inferred, 1 tracked.
    player: which person, 0 for the first.
    floor: the floor plane in the sensor frame, or None where the sensor has not seen one.
    metric: False where the scale is a guess (a webcam).
    """

    time_s: float
    positions: Floats
    confidence: Floats
    player: int = 0
    floor: Floor | None = None
    metric: bool = True
