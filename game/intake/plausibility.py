"""What a sensor may have got wrong: lost joints are held, inferred ones slowed, impossible frames refused with a reason."""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from kinect.body import JOINT_COUNT, BodyFrame, Joint

Floats = NDArray[np.float64]

_ROOT = int(Joint.HIP_CENTER)

INFERRED_BLEND = 0.5
INFERRED_SPEED_M_S = 2.5
"""An inferred joint moves half of the way to its guess, and no faster than this against the hip centre."""

GAP_S = 0.5
"""After a gap this long the player may have walked: the root may be anywhere."""


class Plausibility:
    """Repairs frames one by one; `fault` says in words what the last frame lacked, "" if nothing."""

    def __init__(self) -> None:
        self._last: BodyFrame | None = None
        self.fault = ""
        self.held_frames = 0

    def apply(self, frame: BodyFrame, jump_limit_m: float) -> BodyFrame | None:
        """The frame with every joint finite, or None where it is refused (the caller holds its last target)."""
        self.fault = self._misshapen(frame)
        if not self.fault:
            count, whole, root_seen = _seen(frame.positions, frame.confidence)
            self.fault = self._reason(frame, jump_limit_m, count, root_seen)
            if not self.fault:
                self._last = frame if whole else self._repair(frame)
                return self._last
        self.held_frames += 1
        return None

    def _misshapen(self, frame: BodyFrame) -> str:
        if frame.positions.shape != (JOINT_COUNT, 3):
            return f"a frame has joints of shape {frame.positions.shape}, not (20, 3): the last pose is held"
        if frame.confidence.shape != (JOINT_COUNT,):
            return f"a frame has confidences of shape {frame.confidence.shape}, not (20,): the last pose is held"
        return ""

    def _reason(self, frame: BodyFrame, jump_limit_m: float, count: int, root_seen: bool) -> str:
        last = self._last
        if not math.isfinite(frame.time_s) or (last is not None and frame.time_s <= last.time_s):
            return f"a frame's time does not advance ({frame.time_s:.3f} s): it is dropped"
        if not root_seen:
            return "the hip centre is lost: the last pose is held"
        if last is None and count < JOINT_COUNT:
            return "not all joints are seen yet: step back until your whole body is in view"
        if count < JOINT_COUNT // 2:
            return f"only {count} of 20 joints are seen: the last pose is held"
        return "" if last is None else self._jump(frame, last, jump_limit_m)

    def _jump(self, frame: BodyFrame, last: BodyFrame, jump_limit_m: float) -> str:
        if frame.time_s - last.time_s < GAP_S:
            jump = math.dist(frame.positions[_ROOT].tolist(), last.positions[_ROOT].tolist())
            if jump > jump_limit_m:
                return f"the hip centre jumps {jump:.2f} m between two frames: the last pose is held"
        return ""

    def _repair(self, frame: BodyFrame) -> BodyFrame:
        if self._last is None:
            return frame
        reach = INFERRED_SPEED_M_S * (frame.time_s - self._last.time_s)
        positions, confidence = np.empty_like(frame.positions), np.empty_like(frame.confidence)
        _mend(frame.positions, frame.confidence, self._last.positions, reach, positions, confidence)
        return BodyFrame(frame.time_s, positions, confidence, frame.player, frame.floor, frame.metric)


@compiled
def _seen(positions: Floats, confidence: Floats) -> tuple[int, bool, bool]:
    """How many joints are finite and not lost, whether all are and are tracked, so that nothing is to repair; whether the hip centre is."""
    count, whole, root = 0, True, False
    for joint in range(len(positions)):
        finite = math.isfinite(positions[joint, 0]) and math.isfinite(positions[joint, 1]) and math.isfinite(positions[joint, 2])
        if finite and confidence[joint] > 0.0:
            count += 1
            root = root or joint == _ROOT
        whole = whole and finite and confidence[joint] >= 1.0
    return count, whole, root


@compiled
def _mend(positions: Floats, confidence: Floats, last: Floats, reach_m: float, out: Floats, sure: Floats) -> None:
    """Fill joints `out` (20, 3) and their confidence `sure` (20,): a lost one stays where it was against the hip centre in `last` (20, 3),
    an inferred one goes half of the way from there, at most `reach_m`."""
    held, step = np.empty(3), np.empty(3)
    for joint in range(len(positions)):
        finite = math.isfinite(positions[joint, 0]) and math.isfinite(positions[joint, 1]) and math.isfinite(positions[joint, 2])
        sure[joint] = confidence[joint] if finite and not math.isnan(confidence[joint]) else 0.0
        total = 0.0
        for axis in range(3):
            held[axis] = last[joint, axis] + (positions[_ROOT, axis] - last[_ROOT, axis])
            step[axis] = positions[joint, axis] - held[axis] if finite else 0.0
            total += step[axis] * step[axis]
        share = min(INFERRED_BLEND, reach_m / max(math.sqrt(total), 1e-9)) if sure[joint] > 0.0 else 0.0
        if sure[joint] >= 1.0:
            share = 1.0
        for axis in range(3):
            out[joint, axis] = held[axis] + share * step[axis]
