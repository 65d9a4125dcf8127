"""What a sensor may have got wrong: lost joints are held, inferred ones slowed, impossible frames refused with a reason."""

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from kinect.body import JOINT_COUNT, BodyFrame, Joint

Floats = NDArray[np.float64]

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
        self.fault = self._reason(frame, jump_limit_m)
        if self.fault:
            self.held_frames += 1
            return None
        repaired = self._repair(frame)
        self._last = repaired
        return repaired

    def _reason(self, frame: BodyFrame, jump_limit_m: float) -> str:
        if frame.positions.shape != (JOINT_COUNT, 3):
            return f"a frame has joints of shape {frame.positions.shape}, not (20, 3): the last pose is held"
        if frame.confidence.shape != (JOINT_COUNT,):
            return f"a frame has confidences of shape {frame.confidence.shape}, not (20,): the last pose is held"
        last = self._last
        if not np.isfinite(frame.time_s) or (last is not None and frame.time_s <= last.time_s):
            return f"a frame's time does not advance ({frame.time_s:.3f} s): it is dropped"
        if last is not None and _all_seen(frame.positions, frame.confidence):
            return self._jump(frame, last, jump_limit_m)
        seen = np.logical_and.reduce(np.isfinite(frame.positions), axis=1) & (frame.confidence > 0.0)
        if not seen[Joint.HIP_CENTER]:
            return "the hip centre is lost: the last pose is held"
        if last is None and not seen.all():
            return "not all joints are seen yet: step back until your whole body is in view"
        if seen.sum() < JOINT_COUNT // 2:
            return f"only {int(seen.sum())} of 20 joints are seen: the last pose is held"
        return "" if last is None else self._jump(frame, last, jump_limit_m)

    def _jump(self, frame: BodyFrame, last: BodyFrame, jump_limit_m: float) -> str:
        if frame.time_s - last.time_s < GAP_S:
            jump = math.dist(frame.positions[Joint.HIP_CENTER], last.positions[Joint.HIP_CENTER])
            if jump > jump_limit_m:
                return f"the hip centre jumps {jump:.2f} m between two frames: the last pose is held"
        return ""

    def _repair(self, frame: BodyFrame) -> BodyFrame:
        if _all_seen(frame.positions, frame.confidence):
            return frame
        finite = np.isfinite(frame.positions).all(axis=1)
        confidence = np.where(finite, np.nan_to_num(frame.confidence), 0.0)
        if self._last is None or (confidence >= 1.0).all():
            return frame
        root = frame.positions[Joint.HIP_CENTER]
        held = self._last.positions + (root - self._last.positions[Joint.HIP_CENTER])
        step = np.where(np.expand_dims(finite, 1), frame.positions, held) - held
        length = np.sqrt(np.sum(step * step, axis=1))
        reach = INFERRED_SPEED_M_S * (frame.time_s - self._last.time_s)
        share = np.minimum(INFERRED_BLEND, reach / np.maximum(length, 1e-9))
        share = np.where(confidence >= 1.0, 1.0, np.where(confidence > 0.0, share, 0.0))
        return replace(frame, positions=held + share[:, None] * step, confidence=confidence)


@compiled
def _all_seen(positions: Floats, confidence: Floats) -> bool:
    """Every joint (n, 3) tracked and finite: the usual frame, which needs no repair."""
    for joint in range(len(positions)):
        if not confidence[joint] >= 1.0:
            return False
        for axis in range(3):
            if not math.isfinite(positions[joint, axis]):
                return False
    return True
