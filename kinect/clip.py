"""Recordings: read and write them by their suffix, play them as a source of body frames."""

import math
from pathlib import Path
from typing import Final

from kinect.body import BodyFrame, Floor
from kinect.clip_csv import read_csv, write_csv
from kinect.clip_floor import floor_from_resting_ankles
from kinect.clip_format import Clip, ClipError, checked_clip
from kinect.clip_npz import read_npz, write_npz

__all__ = ["Clip", "ClipError", "ClipSource", "checked_clip", "read_clip", "write_clip"]

_READERS: Final = {".npz": read_npz, ".csv": read_csv, ".txt": read_csv}
_WRITERS: Final = {".npz": write_npz, ".csv": write_csv, ".txt": write_csv}


def read_clip(path: str | Path) -> Clip:
    """The recording in a .npz, .csv or .txt file; raises ClipError with one sentence that names file, field and what is valid."""
    path = Path(path)
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        raise ClipError(f"{path.name}: the suffix {path.suffix!r} is no recording's; valid: {', '.join(_READERS)}.")
    try:
        if not path.is_file():
            raise ClipError(f"{path}: there is no such file; valid: a recording ending in {', '.join(_READERS)}.")
        return reader(path)
    except OSError as fault:
        raise ClipError(f"{path}: the file cannot be read ({fault.strerror or fault}); valid: a readable recording.") from fault


def write_clip(path: str | Path, clip: Clip) -> None:
    """Write the recording in the format of the file's suffix; raises ClipError."""
    path = Path(path)
    writer = _WRITERS.get(path.suffix.lower())
    if writer is None:
        raise ClipError(f"{path.name}: the suffix {path.suffix!r} is no recording's; valid: {', '.join(_WRITERS)}.")
    checked_clip(path.name, clip.positions, clip.confidence, clip.t, clip.floor, clip.floor_est)
    try:
        writer(path, clip)
    except OSError as fault:
        raise ClipError(f"{path}: the file cannot be written ({fault.strerror or fault}); valid: a writable folder.") from fault


class ClipSource:
    """Plays a recording on the simulated clock it is polled with.

    Every frame carries the floor: the recorded plane, else the recording's own estimate, else one from the
    resting ankles; `floor_origin` says which. With `loop` it starts anew one frame after its end, time running on.
    """

    def __init__(self, clip: str | Path | Clip, loop: bool = False) -> None:
        """Raises ClipError where the recording cannot be read."""
        self.clip = clip if isinstance(clip, Clip) else read_clip(clip)
        self.name = str(self.clip.meta.get("motion", "recording")) if isinstance(clip, Clip) else Path(clip).name
        self.floor, self.floor_origin = _floor(self.clip)
        self.dropped_frames = self.clip.dropped_frames
        self._loop = loop
        self._next = 0
        self._lap_s = self.clip.length_s + (float(self.clip.t[1]) if len(self.clip.t) > 1 else 1.0 / 30.0)

    @property
    def length_s(self) -> float | None:
        """Time of the last frame, seconds; None while looping."""
        return None if self._loop else self.clip.length_s

    @property
    def status(self) -> str:
        frames = len(self.clip.t)
        if not self._loop and self._next >= frames:
            place = f"ended after {self.clip.length_s:.1f} s"
        else:
            place = f"{self._time(max(0, self._next - 1)) % self._lap_s:.1f} of {self.clip.length_s:.1f} s"
        dropped = f", {self.dropped_frames} frames without a new time left out" if self.dropped_frames else ""
        return f"Recording {self.name}: {place}; floor {self.floor_origin}{dropped}."

    def poll(self, until_s: float) -> list[BodyFrame]:
        """Every frame not yet handed out with time_s <= until_s (finite when looping), oldest first."""
        if self._loop and not math.isfinite(until_s):
            raise ValueError("a looping recording never ends; poll it up to a finite time")
        frames: list[BodyFrame] = []
        total = len(self.clip.t)
        while (self._loop or self._next < total) and self._time(self._next) <= until_s:
            k = self._next % total
            frames.append(
                BodyFrame(self._time(self._next), self.clip.positions[k].copy(), self.clip.confidence[k].copy(), floor=self.floor)
            )
            self._next += 1
        return frames

    def close(self) -> None:
        """Nothing to release: the recording is in memory."""

    def _time(self, index: int) -> float:
        lap, k = divmod(index, len(self.clip.t))
        return lap * self._lap_s + float(self.clip.t[k])


def _floor(clip: Clip) -> tuple[Floor | None, str]:
    if clip.floor is not None:
        return clip.floor, "recorded"
    if clip.floor_est is not None:
        return clip.floor_est, "estimated by the recording's maker"
    floor = floor_from_resting_ankles(clip)
    return floor, "from the resting ankles" if floor is not None else "unknown"
