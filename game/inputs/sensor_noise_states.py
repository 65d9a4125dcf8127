"""When the sensor only infers a joint, and where it then puts it; and the leaps of hands and feet it believes to see."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.inputs.sensor_noise_table import INFERRED_SHARE
from kinect.body import JOINT_COUNT, Floats, Joint

Runs = NDArray[np.int64]

# a run of inferred frames is a flicker of one, a glance away, or a limb that stays hidden: (probability, mean frames)
_RUNS: Final = ((0.55, 1.0), (0.37, 7.0), (0.08, 85.0))
_KINDS: Final[Floats] = np.cumsum([share for share, _ in _RUNS])
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
        self._left = np.zeros(JOINT_COUNT, dtype=np.int64)
        self._gate = np.ones(JOINT_COUNT)
        self._target = np.zeros((JOINT_COUNT, 3))
        self._reached = np.zeros(JOINT_COUNT)

    def step(self, scale: float) -> tuple[np.ndarray, Floats]:
        """Which joints are inferred in the next frame, (20,) bool, and their offset, (20, 3) metres at outlier scale 1.

        `scale` up to 1 is the share of the real sensor's runs that happen; more than 1 adds none.
        """
        start = np.empty(JOINT_COUNT, dtype=bool)
        if _drift(self._left, self._reached, self._rng.random(JOINT_COUNT), start):
            for joint in np.flatnonzero(start).tolist():
                self._begin(joint)
        shown, offset = np.empty(JOINT_COUNT, dtype=bool), np.empty((JOINT_COUNT, 3))
        _show(self._left, self._gate, scale, self._target, self._reached, shown, offset)
        return shown, offset

    def _begin(self, joint: int) -> None:
        rng = self._rng
        kind = int(np.searchsorted(_KINDS, rng.random(), side="right"))
        self._left[joint] = rng.geometric(1.0 / _RUNS[kind][1])
        way = rng.standard_normal(3)
        astray = min(_ASTRAY_MEDIAN_M * np.exp(_ASTRAY_SPREAD * rng.standard_normal()), _ASTRAY_LARGEST_M)
        self._target[joint] = way * astray / np.linalg.norm(way)
        self._reached[joint] = _FIRST_SHARE
        self._gate[joint] = rng.random()


@compiled
def _drift(left: Runs, reached: Floats, draw: Floats, start: NDArray[np.bool_]) -> bool:
    """One frame on: nothing is left below 0, and every joint nears the end of its way.

    Notes where the draws (20,) start a run; tells whether one does.
    """
    found = False
    for joint in range(len(left)):
        start[joint] = left[joint] < 0 and draw[joint] < _START[joint]
        found = found or start[joint]
        left[joint] = max(left[joint], 0)
        reached[joint] = 1.0 - _DRIFT * (1.0 - reached[joint])
    return found


@compiled
def _show(left: Runs, gate: Floats, scale: float, target: Floats, reached: Floats, shown: NDArray[np.bool_], offset: Floats) -> None:
    """Write which joints are inferred, (20,), and how far they are astray, (20, 3) m; then count the runs down."""
    for joint in range(len(left)):
        shown[joint] = left[joint] > 0 and gate[joint] < scale
        for axis in range(3):
            offset[joint, axis] = target[joint, axis] * reached[joint] if shown[joint] else 0.0
        left[joint] -= 1  # -1: tracked for at least one frame, free to start again


class Leaps:
    """Hands and feet that leap by 50 to 150 mm for some frames while the sensor calls them tracked; wrists follow halfway."""

    def __init__(self, rng: np.random.Generator) -> None:
        self._rng = rng
        self._left = [0, 0, 0, 0]
        self._leap = np.zeros((4, 3))

    def step(self) -> Floats:
        """The next offset of every joint, (20, 3) metres at outlier scale 1."""
        rng = self._rng
        for limb, draw in enumerate(rng.random(4).tolist()):
            if self._left[limb] == 0 and draw < _LEAP_START:
                way = rng.standard_normal(3)
                self._left[limb] = int(rng.geometric(1.0 / _LEAP_FRAMES))
                self._leap[limb] = way * rng.uniform(*_LEAP_M) / np.linalg.norm(way)
        offset = np.zeros((JOINT_COUNT, 3))
        if not any(self._left):
            return offset
        now = np.where((np.array(self._left) > 0)[:, None], self._leap, 0.0)
        self._left = [max(left - 1, 0) for left in self._left]
        offset[[Joint.HAND_LEFT, Joint.HAND_RIGHT, Joint.FOOT_LEFT, Joint.FOOT_RIGHT]] = now
        offset[[Joint.WRIST_LEFT, Joint.WRIST_RIGHT]] = 0.5 * now[:2]
        return offset
