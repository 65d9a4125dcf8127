"""What a valid recording is: the clip in memory and the rules every file format shares.

Rules: time starts at 0 and strictly grows (a frame whose time does not advance is dropped and counted);
a joint without a finite position has confidence 0; confidence that nobody recorded is 1;
a floor plane has a unit normal that points up.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.body import JOINT_COUNT, Floats, Floor

LONGEST_S: Final = 24.0 * 3600.0
FARTHEST_M: Final = 50.0  # nothing a depth camera reports lies farther; catches millimetres and garbage


class ClipError(ValueError):
    """A recording that cannot be read or written; the message is one sentence with file, field, fault and what is valid."""


@dataclass(frozen=True)
class Clip:
    """A recording of one person.

    positions: (T, 20, 3) metres, sensor frame, `Joint` order, NaN where a joint was lost.
    confidence: (T, 20) in 0..1, 0 wherever the position is NaN. t: (T,) seconds, strictly growing from 0.
    floor: the recorded plane or None; floor_est: a plane fitted by whoever made the recording, or None.
    meta: words and numbers about the recording (motion, subject, sensor, source, license, fps).
    dropped_frames: frames left out because their time did not advance.
    """

    positions: Floats
    confidence: Floats
    t: Floats
    floor: Floor | None = None
    floor_est: Floor | None = None
    meta: Mapping[str, str | float] = field(default_factory=dict)
    dropped_frames: int = 0

    @property
    def length_s(self) -> float:
        """Time of the last frame, seconds."""
        return float(self.t[-1])


def checked_clip(
    where: str,
    positions: object,
    confidence: object | None,
    t: object,
    floor: object | None = None,
    floor_est: object | None = None,
    meta: Mapping[str, str | float] | None = None,
) -> Clip:
    """A Clip from raw arrays under the rules above. `where` names the file; raises ClipError."""
    xyz = numbers(where, "positions", positions)
    if xyz.ndim != 3 or xyz.shape[1:] != (JOINT_COUNT, 3):
        raise ClipError(f"{where}: positions has shape {xyz.shape}; valid: (frames, {JOINT_COUNT}, 3).")
    if len(xyz) == 0:
        raise ClipError(f"{where}: positions holds no frames; valid: at least one.")
    kept, times = _advancing(where, _times(where, t, len(xyz)))
    xyz = xyz[kept]
    xyz[~np.all(np.isfinite(xyz), axis=2)] = np.nan
    seen = np.abs(xyz[np.isfinite(xyz)])
    if seen.size == 0:
        raise ClipError(f"{where}: positions holds no finite joint; valid: metres in the sensor frame.")
    if np.median(seen) > FARTHEST_M:
        raise ClipError(f"{where}: positions is typically {np.median(seen):.3g} from the sensor; valid: metres, not millimetres.")
    xyz[np.any(np.abs(xyz) > FARTHEST_M, axis=2)] = np.nan
    sure = _confidence(where, confidence, len(kept))[kept]
    sure[np.isnan(xyz[:, :, 0])] = 0.0
    return Clip(
        xyz,
        sure,
        times,
        checked_floor(where, "floor", floor),
        checked_floor(where, "floor_est", floor_est),
        dict(meta or {}),
        len(kept) - len(times),
    )


def numbers(where: str, name: str, value: object) -> Floats:
    """A fresh float64 array of `value`; raises ClipError where it is not real numbers."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise ClipError(f"{where}: {name} holds {array.dtype.name} values; valid: real numbers.")
    with np.errstate(over="ignore", invalid="ignore"):
        return np.array(array, dtype=np.float64)


def checked_floor(where: str, name: str, value: object | None) -> Floor | None:
    """The plane with a unit normal that points up, None where `value` is None or all NaN; raises ClipError."""
    if value is None:
        return None
    plane = numbers(where, name, value).reshape(-1)
    if plane.shape != (4,):
        raise ClipError(f"{where}: {name} has {plane.size} numbers; valid: the four A, B, C, D of A x + B y + C z + D = 0.")
    if np.all(np.isnan(plane)):
        return None
    length = float(np.linalg.norm(plane[:3])) if np.all(np.abs(plane) < 1e6) else 0.0
    if length < 1e-6:
        raise ClipError(f"{where}: {name} is {plane.tolist()}, not a plane; valid: finite A, B, C, D or four NaN.")
    plane /= length * (1.0 if plane[1] >= 0.0 else -1.0)
    if plane[1] < 0.5 or not -1.0 < plane[3] < 10.0:
        raise ClipError(f"{where}: {name} is {plane.round(3).tolist()}; valid: a normal within 60 degrees of +y and a sensor below 10 m.")
    return Floor(*(float(v) for v in plane))


def _times(where: str, t: object, frames: int) -> Floats:
    times = numbers(where, "t", t)
    if times.shape != (frames,):
        raise ClipError(f"{where}: t has shape {times.shape}; valid: ({frames},), one time stamp a frame.")
    if not np.all(np.isfinite(times)):
        raise ClipError(f"{where}: t is not finite in frame {int(np.argmin(np.isfinite(times)))}; valid: seconds.")
    return times


def _advancing(where: str, times: Floats) -> tuple[NDArray[np.bool_], Floats]:
    """Which frames advance in time, (T,) bool, and their times from 0."""
    before = np.concatenate(([-np.inf], np.maximum.accumulate(times)[:-1]))
    kept = times > before
    if 2 * np.count_nonzero(kept) <= len(times) and len(times) > 1:
        raise ClipError(
            f"{where}: t runs backwards or stands still in {int(np.sum(~kept))} of {len(times)} frames; valid: growing seconds."
        )
    with np.errstate(over="ignore", invalid="ignore"):
        clean = times[kept] - times[0]
    if len(clean) > 1 and np.median(np.diff(clean)) > 1.0:
        raise ClipError(f"{where}: t advances by {np.median(np.diff(clean)):.3g} a frame; valid: seconds (30 frames a second is 0.033).")
    if not clean[-1] <= LONGEST_S or np.any(np.diff(clean) <= 0.0):
        raise ClipError(f"{where}: t spans {clean[-1]:.3g} s; valid: up to {LONGEST_S:g} s with steps that can be told apart.")
    return kept, clean


def _confidence(where: str, value: object | None, frames: int) -> Floats:
    if value is None:
        return np.ones((frames, JOINT_COUNT))
    sure = numbers(where, "confidence", value)
    if sure.shape != (frames, JOINT_COUNT):
        raise ClipError(f"{where}: confidence has shape {sure.shape}; valid: ({frames}, {JOINT_COUNT}).")
    sure[np.isnan(sure)] = 1.0
    if sure.min() < 0.0 or sure.max() > 1.0:
        raise ClipError(f"{where}: confidence reaches from {sure.min():g} to {sure.max():g}; valid: 0 lost, 0.5 inferred, 1 tracked.")
    return sure
