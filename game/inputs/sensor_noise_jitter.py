"""How a resting joint moves in the sensor's eyes: a slow wander and a fast, heavy-tailed jitter."""

from typing import Final

import numpy as np

from game.compiled import compiled
from game.inputs.sensor_noise_table import JITTER_MM, RESTING_LAG1
from kinect.body import BONES, JOINT_COUNT, Floats

_POLE: Final = float(np.exp(-1.0 / 15.0))  # wander: critically damped, half a second at 30 frames a second
_GAIN: Final = float(np.sqrt((1.0 - _POLE**2) ** 3 / (1.0 + _POLE**2)))  # unit variance
_BURST_SHARE: Final = 0.12
_BURST: Final = 3.0  # a burst is this much larger than the ordinary jitter
_FAST_VARIANCE: Final = 1.0 + _BURST_SHARE * (_BURST**2 - 1.0)
_SECOND_DIFFERENCE: Final = 4.42  # its median length in standard deviations of the ordinary jitter, three axes
# over one second with the mean removed: share of the wander's variance that remains, lag-1 of wander and of jitter
_WANDER_LEFT: Final = 0.155
_WANDER_LAG1: Final = 0.915
_JITTER_LAG1: Final = -0.03
_SHARED: Final = 0.97  # correlation of the wander across a bone, so that resting bones keep their length

_FAST_M: Final[Floats] = JITTER_MM / 1000.0 / _SECOND_DIFFERENCE
_WANDER_M: Final[Floats] = _FAST_M * np.sqrt(
    _FAST_VARIANCE * (RESTING_LAG1 - _JITTER_LAG1) / (_WANDER_LEFT * (_WANDER_LAG1 - RESTING_LAG1))
)


def _along_bones() -> Floats:
    """(20, 20) mixing of independent wanders into unit ones with correlation `_SHARED` across each bone."""
    mixing = np.eye(JOINT_COUNT)
    for parent, child in BONES:
        mixing[child] = _SHARED * mixing[parent]
        mixing[child, child] = np.sqrt(1.0 - _SHARED**2)
    return mixing


_ALONG_BONES: Final[Floats] = _along_bones()


class RestingJitter:
    """Displacement of every joint, frame by frame; one frame is 1/30 s."""

    def __init__(self, rng: np.random.Generator) -> None:
        self._rng = rng
        self._past = np.zeros((JOINT_COUNT, 3)), np.zeros((JOINT_COUNT, 3))
        self._settled = False

    def step(self) -> Floats:
        """The next displacement, (20, 3) metres at scale 1."""
        if not self._settled:  # not before: most inputs are never shaken
            self._settled = True
            for _ in range(90):  # three seconds reach the stationary spread
                self._wander()
        mixed = _ALONG_BONES @ self._wander()
        return _wander_and_jitter(mixed, self._rng.random(JOINT_COUNT), self._rng.standard_normal((JOINT_COUNT, 3)))

    def _wander(self) -> Floats:
        before, last = self._past
        new = _next_wander(before, last, self._rng.standard_normal((JOINT_COUNT, 3)))
        self._past = last, new
        return new


@compiled
def _next_wander(before: Floats, last: Floats, push: Floats) -> Floats:
    """(20, 3) of a critically damped walk, from its last two places and the random push."""
    return 2.0 * _POLE * last - _POLE**2 * before + _GAIN * push


@compiled
def _wander_and_jitter(mixed: Floats, draw: Floats, fast: Floats) -> Floats:
    """(20, 3) m: the wander and the jitter, which some draws (20,) make a burst."""
    out = np.empty((JOINT_COUNT, 3))
    for joint in range(JOINT_COUNT):
        burst = _BURST if draw[joint] < _BURST_SHARE else 1.0
        for axis in range(3):
            out[joint, axis] = _WANDER_M[joint] * mixed[joint, axis] + _FAST_M[joint] * burst * fast[joint, axis]
    return out
