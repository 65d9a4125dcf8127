"""A Kinect v1 laid over a true pose: what a performer or a puppet would look like through the real sensor.

At scale 1 the errors have the size measured on real recordings (`sensor_noise_table`); every amplitude grows
linearly with the scale. Streaming, causal, and equal for equal seeds.
"""

from collections import deque
from typing import Final

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled
from game.inputs.sensor_noise_bones import BoneLengthBias
from game.inputs.sensor_noise_bow import hip_drop
from game.inputs.sensor_noise_jitter import RestingJitter
from game.inputs.sensor_noise_states import InferredRuns, Leaps
from kinect.body import INFERRED, JOINT_COUNT, BodyFrame, Floats, Floor
from kinect.source import BodySource

_PITCH_RAD: Final = np.radians(2.0)  # standard deviation of the sensor's tilt, as estimated floors of recordings show
_ROLL_RAD: Final = np.radians(0.5)
_UP: Final = np.array([0.0, 1.0, 0.0])


class SensorNoise:
    """Wraps a source of true poses. `scale`, `latency_s` and `outliers` may be changed at any time.

    scale: 0 none, 1 a real sensor: bone lengths that vary with the pose, resting jitter, runs of inferred joints,
    hips that sink in a bow, and a tilted sensor, whose floor plane the frames report exactly.
    outliers: 0 none, 1 a real sensor: leaps of hands and feet, inferred joints that go astray and snap back.
    latency_s: frames keep their capture time and are handed out this much later.
    With all three at 0 the frames of the source pass through untouched.
    """

    def __init__(self, source: BodySource, scale: float = 0.0, latency_s: float = 0.0, outliers: float = 0.0, seed: int = 0) -> None:
        self.source = source
        self.scale = scale
        self.latency_s = latency_s
        self.outliers = outliers
        rngs = [np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(5)]
        self._bones = BoneLengthBias(rngs[0])
        self._jitter = RestingJitter(rngs[1])
        self._inferred = InferredRuns(rngs[2])
        self._leaps = Leaps(rngs[3])
        self._tilt = np.clip(rngs[4].standard_normal(2), -2.0, 2.0) * (_PITCH_RAD, _ROLL_RAD)
        self._turn_scale, self._turn = 0.0, np.eye(3)
        self._floors: tuple[Floor, Floats, Floor] | None = None
        self._waiting: deque[BodyFrame] = deque()

    @property
    def status(self) -> str:
        """The source's words and what the sensor model adds."""
        parts = [f"noise {self.scale:g}"] if self.scale > 0.0 else []
        parts += [f"outliers {self.outliers:g}"] if self.outliers > 0.0 else []
        parts += [f"{1000.0 * self.latency_s:.0f} ms late"] if self.latency_s > 0.0 else []
        return f"{self.source.status} Seen by a simulated Kinect: {', '.join(parts)}." if parts else self.source.status

    @property
    def length_s(self) -> float | None:
        """Length of the source plus the latency, seconds."""
        return None if self.source.length_s is None else self.source.length_s + self.latency_s

    def poll(self, until_s: float) -> list[BodyFrame]:
        """Every frame captured at least `latency_s` before `until_s` and not yet handed out, oldest first."""
        self._waiting.extend(self._seen(frame) for frame in self.source.poll(until_s))
        ready: list[BodyFrame] = []
        while self._waiting and self._waiting[0].time_s + self.latency_s <= until_s:
            ready.append(self._waiting.popleft())
        return ready

    def close(self) -> None:
        """Close the source and forget the frames under way."""
        self._waiting.clear()
        self.source.close()

    def _seen(self, frame: BodyFrame) -> BodyFrame:
        scale, outliers = max(0.0, self.scale), max(0.0, self.outliers)
        if scale == 0.0 and outliers == 0.0:
            return frame
        true = frame.positions
        up = _UP if frame.floor is None else np.array(frame.floor[:3])
        shown, astray = self._inferred.step(max(scale, min(outliers, 1.0)))
        turn = self._turned(scale)
        positions, confidence = _laid_over(
            true, frame.confidence, shown, self._jitter.step(), astray, self._leaps.step(), hip_drop(true, up),
            self._bones.displacement(true, scale), scale, outliers, turn,
        )  # fmt: skip
        return BodyFrame(frame.time_s, positions, confidence, frame.player, self._tilted(frame.floor, turn), frame.metric)

    def _tilted(self, floor: Floor | None, turn: Floats) -> Floor | None:
        """The floor as the tilted sensor sees it, worked out anew only where it or the tilt has changed."""
        if floor is None:
            return None
        if self._floors is None or self._floors[0] != floor or self._floors[1] is not turn:
            self._floors = floor, turn, Floor._make([*(turn @ np.array(floor[:3])).tolist(), floor.d])
        return self._floors[2]

    def _turned(self, scale: float) -> Floats:
        """(3, 3) of the tilt at `scale`, made anew only where the scale was changed."""
        if scale != self._turn_scale:
            self._turn_scale, self._turn = scale, _tilt(scale * self._tilt[0], scale * self._tilt[1])
        return self._turn


@compiled
def _laid_over(
    true: Floats, confidence: Floats, shown: NDArray[np.bool_], jitter: Floats, astray: Floats, leap: Floats, drop: Floats,
    bones: Floats, scale: float, outliers: float, turn: Floats,
) -> tuple[Floats, Floats]:  # fmt: skip
    """Joints (20, 3) m with all their errors, (20, 3) each, in the tilted sensor's frame, and their confidence (20,)."""
    out, sure = np.empty((JOINT_COUNT, 3)), np.empty(JOINT_COUNT)
    seen = np.empty(3)
    for joint in range(JOINT_COUNT):
        for axis in range(3):
            error = scale * jitter[joint, axis] + outliers * (astray[joint, axis] + leap[joint, axis])
            seen[axis] = true[joint, axis] + (error + scale * drop[joint, axis] + bones[joint, axis])
        out[joint] = one.turn(turn, seen)
        sure[joint] = min(confidence[joint], INFERRED) if shown[joint] else confidence[joint]
    return out, sure


def _tilt(pitch: float, roll: float) -> Floats:
    """Rotation about the sensor's x by pitch, then about its z by roll, (3, 3)."""
    cp, sp, cr, sr = np.cos(pitch), np.sin(pitch), np.cos(roll), np.sin(roll)
    return np.array([[cr, -sr, 0.0], [sr, cr, 0.0], [0.0, 0.0, 1.0]]) @ np.array([[1.0, 0.0, 0.0], [0.0, cp, -sp], [0.0, sp, cp]])
