"""Depth recordings as NumPy archives: raw disparity with the device's ticks, or millimetres with microseconds."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.body import Floats
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.disparity_grid import disparity_grid
from kinect.depth.intrinsics import MICROSOFT_SDK, Intrinsics, factory_intrinsics
from kinect.depth.npz_pictures import fields_of, picture_count, pictures, small_field
from kinect.depth.recording_format import DepthRecording, DepthRecordingError, checked_raw, seconds_from_ticks, ticks_at
from kinect.device_calibration import TYPICAL, DeviceCalibration

NO_ACCEL: Final = -32768
GRID_FRAMES: Final = 8
Accel = tuple[int, int, int] | None


def read_npz(path: Path) -> DepthRecording:
    """The recording in one archive; raises DepthRecordingError."""
    fields = fields_of(path)
    if "raw11" in fields:
        return joined(path.name, [raw_archive(path)])
    if "depth_mm" in fields:
        return _millimetres(path)
    raise DepthRecordingError(f"{path.name}: there is neither raw11 nor depth_mm in the archive; valid: one of them.")


@dataclass(frozen=True)
class RawArchive:
    """An archive of raw pictures, nothing left out: ticks (n,), host_s (n,) or None, accel a row each, and the sensor it came from."""

    path: Path
    ticks: NDArray[np.uint32]
    host_s: Floats | None
    accel: list[Accel]
    calibration: DeviceCalibration
    intrinsics: Intrinsics

    def frames(self, times: Floats, kept: NDArray[np.bool_]) -> Iterator[DepthFrame]:
        """The kept frames (n,) bool at the given seconds (n,)."""
        for k, picture in enumerate(pictures(self.path, "raw11")):
            if kept[k]:
                raw = checked_raw(self.path.name, "raw11", picture)
                yield DepthFrame(raw, float(times[k]), int(self.ticks[k]), self.accel[k], self.calibration, self.intrinsics)


def raw_archive(path: Path) -> RawArchive:
    """All of an archive but its pictures; raises DepthRecordingError."""
    fields = fields_of(path)
    count = picture_count(path, "raw11")
    ticks = _column(path, "ticks", count).astype(np.uint32)
    host = _column(path, "host_time", count).astype(np.float64) if "host_time" in fields else None
    return RawArchive(path, ticks, host, _accel(path, fields, count, host), *_sensor(path, fields))


def joined(name: str, archives: list[RawArchive], notes: tuple[str, ...] = ()) -> DepthRecording:
    """Archives that follow each other as one recording, one clock running through them."""
    hosts = [archive.host_s for archive in archives if archive.host_s is not None]
    host = np.concatenate(hosts) if len(hosts) == len(archives) else None
    times, kept = seconds_from_ticks(np.concatenate([archive.ticks for archive in archives]), host)
    ends = np.cumsum([len(archive.ticks) for archive in archives])

    def frames() -> Iterator[DepthFrame]:
        for archive, end in zip(archives, ends, strict=True):
            here = slice(int(end) - len(archive.ticks), int(end))
            yield from archive.frames(times[here], kept[here])

    assumed = ("the usual calibration is assumed",) if archives[0].calibration.is_typical else ()
    return DepthRecording(name, times[kept], frames, (*notes, *assumed, *left_out(kept)))


def _millimetres(path: Path) -> DepthRecording:
    count = picture_count(path, "depth_mm")
    times = _column(path, "t_us", count).astype(np.float64) / 1e6
    times -= times[0]
    kept = np.concatenate(([True], times[1:] > np.maximum.accumulate(times)[:-1]))
    seen = [np.unique(picture) for _, picture in zip(range(GRID_FRAMES), pictures(path, "depth_mm"), strict=False)]
    grid = disparity_grid(np.concatenate(seen))

    def frames() -> Iterator[DepthFrame]:
        for k, picture in enumerate(pictures(path, "depth_mm")):
            if kept[k]:
                raw = checked_raw(path.name, "depth_mm", grid.codes[picture])
                yield DepthFrame(raw, float(times[k]), ticks_at(float(times[k])), None, grid.calibration, MICROSOFT_SDK)

    note = f"millimetres turned back into raw disparity to within {grid.worst_mm:.1f} mm"
    return DepthRecording(path.name, times[kept], frames, (note, *left_out(kept)))


def _column(path: Path, field: str, count: int) -> np.ndarray:
    """A field of one number a frame, (count,); raises DepthRecordingError."""
    values = small_field(path, field)
    if values.shape != (count,) or values.dtype.kind not in "fiu":
        kind = f"{values.dtype.name} of shape {values.shape}"
        raise DepthRecordingError(f"{path.name}: {field} is {kind}; valid: ({count},) numbers, one a frame.")
    if not np.all(np.isfinite(values)):
        raise DepthRecordingError(f"{path.name}: {field} is not finite in frame {int(np.argmin(np.isfinite(values)))}; valid: numbers.")
    return values


def left_out(kept: NDArray[np.bool_]) -> tuple[str, ...]:
    """The note on frames that do not advance in time, if there are any."""
    missing = int(np.count_nonzero(~kept))
    return (f"{missing} frames whose time does not advance are left out",) if missing else ()


def _sensor(path: Path, fields: frozenset[str]) -> tuple[DeviceCalibration, Intrinsics]:
    """The calibration and lens kept in the archive, or the usual ones; raises DepthRecordingError."""
    if "calibration" not in fields:
        return TYPICAL, factory_intrinsics(TYPICAL)
    numbers = small_field(path, "calibration")
    if numbers.shape != (4,) or numbers.dtype.kind != "f" or not np.all(np.isfinite(numbers)) or np.any(numbers[:3] <= 0.0):
        raise DepthRecordingError(
            f"{path.name}: calibration is {numbers.tolist()}; valid: plane distance, pixel size, baseline (metres, positive) and shift."
        )
    lens = small_field(path, "intrinsics")
    if lens.shape != (3,) or lens.dtype.kind != "f" or not np.all(np.isfinite(lens)) or lens[0] <= 0.0:
        raise DepthRecordingError(f"{path.name}: intrinsics is {lens.tolist()}; valid: focal length (positive), centre u and v, pixels.")
    distance, pixel, baseline, shift = (float(v) for v in numbers)
    typical = "calibration_is_typical" in fields and bool(np.all(small_field(path, "calibration_is_typical")))
    return DeviceCalibration(distance, pixel, baseline, shift, typical), Intrinsics(*(float(v) for v in lens))


def _accel(path: Path, fields: frozenset[str], count: int, host: Floats | None) -> list[Accel]:
    """Counts for each frame: kept a frame each, or on a clock of their own, where the last reading before a frame counts."""
    if "accel" not in fields:
        return [None] * count
    rows = small_field(path, "accel")
    if rows.ndim != 2 or rows.shape[1] < 3 or rows.dtype.kind not in "iu" or len(rows) == 0:
        raise DepthRecordingError(f"{path.name}: accel is {rows.dtype.name} of shape {rows.shape}; valid: integer rows of x, y, z counts.")
    if "accel_host_time" in fields and host is not None:
        when = _column(path, "accel_host_time", len(rows))
        rows = rows[np.clip(np.searchsorted(when, host, side="right") - 1, 0, len(rows) - 1)]
    elif len(rows) != count:
        raise DepthRecordingError(f"{path.name}: accel has {len(rows)} rows; valid: {count}, one a frame, or accel_host_time beside it.")
    return [None if row[0] == NO_ACCEL else (int(row[0]), int(row[1]), int(row[2])) for row in rows]
