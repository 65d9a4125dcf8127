"""When the sensor only infers a joint, and where it then puts it; and the leaps of hands and feet it believes to see."""

from typing import Final

import numpy as np

from game.inputs.sensor_noise_table import INFERRED_SHARE
from kinect.body import JOINT_COUNT, Floats, Joint

# a run of inferred frames is a flicker of one, a glance away, or a limb that stays hidden: (probability, mean frames)
_RUNS: Final = ((0.55, 1.0), (0.37, 7.0), (0.08, 85.0))
_KINDS: Final = tuple(share for share, _ in _RUNS)
_MEAN_RUN: Final = sum(share * mean for share, mean in _RUNS)
_START: Final[Floats] = INFERRED_SHARE / ((1.0 - INFERRED_SHARE) * _MEAN_RUN)
# an inferred joint starts beside its place and drifts away from it; where it ends is log-normal
_ASTRAY_MEDIAN_M: Final = 0.046
_ASTRAY_SPREAD: Final = 1.05
_ASTRAY_LARGEST_M: Final = 0.5
_FIRST_SHARE: Final = 0.6
_DRIFT: Final = 0.85

_LEAP_START: Final = 1.0 / 70.0
_LEAP_FRAMES: Final = 3.0
_LEAP_M: Final = (0.05, 0.15)


class InferredRuns:
    """Runs of inferred frames of every joint, and the offset of the joint while they last."""

    def __init__(self, rng: np.random.Generator) -> None:
        self._rng = rng
        self._left = np.zeros(JOINT_COUNT, dtype=int)
        self._gate = np.ones(JOINT_COUNT)
        self._target = np.zeros((JOINT_COUNT, 3))
        self._reached = np.zeros(JOINT_COUNT)

    def step(self, scale: float) -> tuple[np.ndarray, Floats]:
        """Which joints are inferred in the next frame, (20,) bool, and their offset, (20, 3) metres at outlier scale 1.

        `scale` up to 1 is the share of the real sensor's runs that happen; more than 1 adds none.
        """
        start = np.flatnonzero((self._left < 0) & (self._rng.random(JOINT_COUNT) < _START))
        self._left = np.maximum(self._left, 0)
        self._reached = 1.0 - _DRIFT * (1.0 - self._reached)
        for joint in start.tolist():
            self._begin(joint)
        running = self._left > 0
        self._left = self._left - 1  # -1: tracked for at least one frame, free to start again
        shown = running & (self._gate < scale)
        return shown, np.where(shown[:, None], self._target * self._reached[:, None], 0.0)

    def _begin(self, joint: int) -> None:
        rng = self._rng
        kind = rng.choice(len(_RUNS), p=_KINDS)
        self._left[joint] = rng.geometric(1.0 / _RUNS[kind][1])
        way = rng.standard_normal(3)
        astray = min(_ASTRAY_MEDIAN_M * np.exp(_ASTRAY_SPREAD * rng.standard_normal()), _ASTRAY_LARGEST_M)
        self._target[joint] = way * astray / np.linalg.norm(way)
        self._reached[joint] = _FIRST_SHARE
        self._gate[joint] = rng.random()


class Leaps:
    """Hands and feet that leap by 50 to 150 mm for some frames while the sensor calls them tracked; wrists follow halfway."""

    def __init__(self, rng: np.random.Generator) -> None:
        self._rng = rng
        self._left = np.zeros(4, dtype=int)
        self._leap = np.zeros((4, 3))

    def step(self) -> Floats:
        """The next offset of every joint, (20, 3) metres at outlier scale 1."""
        rng = self._rng
        for limb in np.flatnonzero((self._left == 0) & (rng.random(4) < _LEAP_START)):
            way = rng.standard_normal(3)
            self._left[limb] = rng.geometric(1.0 / _LEAP_FRAMES)
            self._leap[limb] = way * rng.uniform(*_LEAP_M) / np.linalg.norm(way)
        now = np.where((self._left > 0)[:, None], self._leap, 0.0)
        self._left = np.maximum(self._left - 1, 0)
        offset = np.zeros((JOINT_COUNT, 3))
        offset[[Joint.HAND_LEFT, Joint.HAND_RIGHT, Joint.FOOT_LEFT, Joint.FOOT_RIGHT]] = now
        offset[[Joint.WRIST_LEFT, Joint.WRIST_RIGHT]] = 0.5 * now[:2]
        return offset
