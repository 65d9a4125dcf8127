"""How a resting joint moves in the sensor's eyes: a slow wander and a fast, heavy-tailed jitter."""

from typing import Final

import numpy as np

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
        self._past = np.zeros((2, JOINT_COUNT, 3))
        for _ in range(90):  # three seconds reach the stationary spread
            self._wander()

    def step(self) -> Floats:
        """The next displacement, (20, 3) metres at scale 1."""
        mixed = _ALONG_BONES @ self._wander()
        burst = np.where(self._rng.random((JOINT_COUNT, 1)) < _BURST_SHARE, _BURST, 1.0)
        return _WANDER_M[:, None] * mixed + _FAST_M[:, None] * burst * self._rng.standard_normal((JOINT_COUNT, 3))

    def _wander(self) -> Floats:
        new = 2.0 * _POLE * self._past[1] - _POLE**2 * self._past[0] + _GAIN * self._rng.standard_normal((JOINT_COUNT, 3))
        self._past = np.stack([self._past[1], new])
        return new
