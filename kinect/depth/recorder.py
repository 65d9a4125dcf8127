"""Writes depth frames to a folder, a second at a time, so that a killed recording keeps all but its last second."""

import os
import queue
import threading
import zipfile
from pathlib import Path
from typing import Final

import numpy as np

from kinect.depth.depth_frame import DepthFrame
from kinect.depth.recording_format import DepthRecordingError
from kinect.depth.recording_npz import NO_ACCEL

CHUNK_FRAMES: Final = 30
WAITING_CHUNKS: Final = 4
_COMPRESSION: Final = 1  # 10 ms a frame on one core, outside the interpreter's lock; level 6 takes 35 ms for a third less


class DepthRecorder:
    """A folder of archives depth-000000.npz, depth-000001.npz ..., each readable by numpy.load and complete in itself.

    Each is written under another name, then renamed. Compressing happens in a thread of its own.
    """

    def __init__(self, folder: str | Path, chunk_frames: int = CHUNK_FRAMES) -> None:
        """Raises DepthRecordingError where the folder cannot be made or holds something already."""
        self.folder = Path(folder)
        self.frames_written = 0
        self._chunk_frames = chunk_frames
        self._pending: list[DepthFrame] = []
        self._chunks: queue.Queue[list[DepthFrame] | None] = queue.Queue(WAITING_CHUNKS)
        self._fault: OSError | None = None
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            if any(self.folder.iterdir()):
                raise DepthRecordingError(f"{self.folder}: the folder is not empty; valid: a new or an empty folder.")
        except OSError as fault:
            raise DepthRecordingError(f"{self.folder}: no folder can be made here ({fault.strerror}); valid: a writable place.") from fault
        self._thread = threading.Thread(target=self._run, name="depth recorder", daemon=True)
        self._thread.start()

    def write(self, frame: DepthFrame) -> None:
        """Take a frame; waits where the disk is far behind, and raises DepthRecordingError where it is full."""
        self._check()
        self._pending.append(frame)
        if len(self._pending) >= self._chunk_frames:
            self._hand_over()

    def close(self) -> None:
        """Write what is left; calling it twice is harmless. Raises DepthRecordingError where that fails."""
        if self._thread.is_alive():
            self._hand_over()
            self._chunks.put(None)
            self._thread.join()
        self._check()

    def __enter__(self) -> "DepthRecorder":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _hand_over(self) -> None:
        if self._pending:
            self._chunks.put(self._pending)
            self._pending = []

    def _check(self) -> None:
        if self._fault is not None:
            reason = self._fault.strerror or self._fault
            raise DepthRecordingError(f"{self.folder}: it cannot be written ({reason}); valid: a disk with room.") from self._fault

    def _run(self) -> None:
        number = 0
        while (chunk := self._chunks.get()) is not None:
            if self._fault is not None:
                continue
            try:
                _write_chunk(self.folder / f"depth-{number:06d}.npz", chunk)
                number += 1
                self.frames_written += len(chunk)
            except OSError as fault:
                self._fault = fault


def _write_chunk(path: Path, frames: list[DepthFrame]) -> None:
    first = frames[0]
    c, lens = first.calibration, first.intrinsics
    no_accel = (NO_ACCEL, NO_ACCEL, NO_ACCEL)
    fields = {
        "raw11": np.stack([frame.raw for frame in frames]).astype("<u2", copy=False),
        "ticks": np.array([frame.ticks for frame in frames], dtype=np.uint32),
        "host_time": np.array([frame.time_s for frame in frames]),
        "accel": np.array([no_accel if frame.accel is None else frame.accel for frame in frames], dtype=np.int16),
        "calibration": np.array([c.zero_plane_distance_m, c.zero_plane_pixel_size_m, c.baseline_m, c.const_shift], dtype=np.float64),
        "calibration_is_typical": np.array(c.is_typical),
        "intrinsics": np.array([lens.focal_px, lens.centre_u, lens.centre_v], dtype=np.float64),
    }
    unfinished = path.with_suffix(".part")
    with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED, compresslevel=_COMPRESSION) as archive:
        for name, array in fields.items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                np.lib.format.write_array(member, array, allow_pickle=False)
    os.replace(unfinished, path)
