"""A floor plane for recordings that brought none: from the height of the ankles while they rest."""

from typing import Final

import numpy as np

from kinect.body import Floor, Joint
from kinect.clip_format import Clip

ANKLE_HEIGHT_M: Final = 0.08
RESTING_SPEED_M_S: Final = 0.15  # slower than any swinging foot, faster than a still ankle's jitter


def floor_from_resting_ankles(clip: Clip) -> Floor | None:
    """The level plane one ankle's height below the lower ankle's median height while it rests; None where no ankle was seen.

    Level, because a standing person's own lean (3 to 5 degrees on average) hides a small tilt of the sensor.
    """
    ankles = clip.positions[:, [Joint.ANKLE_LEFT, Joint.ANKLE_RIGHT]]
    seen = np.any(np.isfinite(ankles[:, :, 1]), axis=1)
    if not np.any(seen):
        return None
    ankles, t = ankles[seen], clip.t[seen]
    lower = np.nanargmin(ankles[:, :, 1], axis=1)
    heights = ankles[np.arange(len(t)), lower, 1]
    if len(t) > 2:
        speed = np.linalg.norm(np.gradient(ankles, t, axis=0), axis=2)[np.arange(len(t)), lower]
        resting = speed < RESTING_SPEED_M_S  # NaN beside a lost frame counts as moving
        if np.count_nonzero(resting) >= 10:
            heights = heights[resting]
    return Floor(0.0, 1.0, 0.0, float(ANKLE_HEIGHT_M - np.median(heights)))
