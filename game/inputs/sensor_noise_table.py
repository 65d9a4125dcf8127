"""What a Kinect v1 with the Microsoft SDK does to a body, joint by joint and bone by bone.

Facts measured on the Kinder-Gator recordings of adults (579 clips, 57 minutes): `BONE_CV` is the median over clips of
a bone length's standard deviation over its mean; `JITTER_MM` the median length of the second difference of a resting
joint, one frame apart; `RESTING_LAG1` the lag-1 autocorrelation of a resting joint over one second, its mean removed.
Tracking states come from one recording of 81 s with states (45 joint-minutes): share of frames inferred, and
`RUN_FRAMES`, `RETURN_STEP_MM`: 50th and 90th percentile of a run's frames and of the step by which a joint comes back.
"""

from typing import Final

import numpy as np

from kinect.body import BONES, Floats, Joint

# joint: (jitter mm, lag-1 autocorrelation, share of frames inferred)
_JOINTS: Final[dict[Joint, tuple[float, float, float]]] = {
    Joint.HIP_CENTER: (0.75, 0.89, 0.0),
    Joint.SPINE: (0.75, 0.90, 0.0),
    Joint.SHOULDER_CENTER: (1.15, 0.88, 0.0),
    Joint.HEAD: (1.47, 0.87, 0.037),
    Joint.SHOULDER_LEFT: (1.12, 0.86, 0.108),
    Joint.ELBOW_LEFT: (1.98, 0.80, 0.117),
    Joint.WRIST_LEFT: (2.94, 0.78, 0.375),
    Joint.HAND_LEFT: (4.16, 0.76, 0.489),
    Joint.SHOULDER_RIGHT: (1.31, 0.85, 0.024),
    Joint.ELBOW_RIGHT: (1.95, 0.78, 0.194),
    Joint.WRIST_RIGHT: (3.02, 0.74, 0.327),
    Joint.HAND_RIGHT: (4.14, 0.71, 0.471),
    Joint.HIP_LEFT: (0.85, 0.90, 0.0),
    Joint.KNEE_LEFT: (1.50, 0.78, 0.075),
    Joint.ANKLE_LEFT: (2.25, 0.69, 0.063),
    Joint.FOOT_LEFT: (5.42, 0.53, 0.053),
    Joint.HIP_RIGHT: (0.85, 0.90, 0.0),
    Joint.KNEE_RIGHT: (1.59, 0.78, 0.064),
    Joint.ANKLE_RIGHT: (2.05, 0.70, 0.063),
    Joint.FOOT_RIGHT: (4.62, 0.55, 0.061),
}

# in the order of BONES, per cent
_BONES_CV_PCT: Final = (3.58, 3.06, 3.10, 4.56, 6.79, 7.05, 15.79, 4.79, 7.21, 7.81, 18.23, 3.92, 3.27, 2.83, 7.04, 3.93, 3.05, 2.72, 6.84)

JITTER_MM: Final[Floats] = np.array([_JOINTS[joint][0] for joint in Joint])
"""(20,) median second difference at rest, mm."""
RESTING_LAG1: Final[Floats] = np.array([_JOINTS[joint][1] for joint in Joint])
"""(20,) lag-1 autocorrelation at rest, windows of 30 frames."""
INFERRED_SHARE: Final[Floats] = np.array([_JOINTS[joint][2] for joint in Joint])
"""(20,) share of frames in which the joint is inferred."""
BONE_CV: Final[Floats] = np.array(_BONES_CV_PCT) / 100.0
"""(19,) coefficient of variation of each bone of `BONES` in a moving person."""
RUN_FRAMES: Final = (1.0, 15.6)
RETURN_STEP_MM: Final = (32.7, 126.4)

assert len(BONE_CV) == len(BONES)
