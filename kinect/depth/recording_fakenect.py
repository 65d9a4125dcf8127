"""Sessions of libfreenect's recorder, fakenect: a folder with INDEX.txt and one file a reading.

Lines of INDEX.txt are KIND-HOST_SECONDS-TICKS.SUFFIX: d depth (.pgm), a accelerometer (.dump), r colour (.ppm, not read).
A depth file is the line "P5 640 480 65535" and 614,400 octets of little-endian uint16, against the PGM standard's big-endian.
"""

import re
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np

from kinect.depth.depth_frame import DepthFrame
from kinect.depth.intrinsics import HEIGHT, WIDTH, factory_intrinsics
from kinect.depth.recording_format import DepthRecording, DepthRecordingError, checked_raw, seconds_from_ticks
from kinect.depth.recording_npz import left_out
from kinect.device_calibration import TYPICAL

INDEX: Final = "INDEX.txt"
_LINE = re.compile(r"([a-z])-(\d+\.\d+)-(\d{1,10})\.(\w+)")
_HEADER = re.compile(rb"P5\s+(\d+)\s+(\d+)\s+(\d+)\s")
_PICTURE_BYTES = HEIGHT * WIDTH * 2
_ACCEL = struct.Struct("<hhhb")


@dataclass(frozen=True)
class _Reading:
    path: Path
    host_s: float
    ticks: int


def read_fakenect(folder: Path) -> DepthRecording:
    """The session in a folder with INDEX.txt; raises DepthRecordingError."""
    depth, accel = _index(folder)
    if depth and _cut_off(depth[-1].path):
        depth, cut = depth[:-1], ("the last frame was cut off and is left out",)
    else:
        cut = ()
    if not depth:
        raise DepthRecordingError(f"{folder.name}: {INDEX} names no whole depth frame; valid: lines such as d-1483969352.1-1479898905.pgm.")
    host = np.array([reading.host_s for reading in depth])
    times, kept = seconds_from_ticks(np.array([reading.ticks for reading in depth], dtype=np.uint32), host)
    felt = np.searchsorted([reading.host_s for reading in accel], host, side="right") - 1
    intrinsics = factory_intrinsics(TYPICAL)

    def frames() -> Iterator[DepthFrame]:
        for k in np.flatnonzero(kept):
            counts = _counts(accel[max(0, int(felt[k]))].path) if accel else None
            yield DepthFrame(_picture(depth[k].path), float(times[k]), depth[k].ticks, counts, TYPICAL, intrinsics)

    return DepthRecording(folder.name, times[kept], frames, ("the usual calibration is assumed", *cut, *left_out(kept)))


def _index(folder: Path) -> tuple[list[_Reading], list[_Reading]]:
    try:
        lines = (folder / INDEX).read_text(encoding="ascii").split()
    except (OSError, UnicodeDecodeError) as fault:
        raise DepthRecordingError(f"{folder.name}: {INDEX} cannot be read ({fault}); valid: text, a file name a line.") from fault
    readings: dict[str, list[_Reading]] = {"d": [], "a": []}
    for number, line in enumerate(lines, start=1):
        parts = _LINE.fullmatch(line)
        if parts is None:
            if number == len(lines):
                break  # the recorder was killed while it wrote
            raise DepthRecordingError(f"{folder.name}: {INDEX} has {line!r} in line {number}; valid: KIND-SECONDS-TICKS.SUFFIX.")
        kind, host, ticks, _ = parts.groups()
        if kind in readings:
            readings[kind].append(_Reading(folder / line, float(host), int(ticks) % 2**32))
    return readings["d"], sorted(readings["a"], key=lambda reading: reading.host_s)


def _cut_off(path: Path) -> bool:
    return not path.is_file() or path.stat().st_size < _PICTURE_BYTES


def _picture(path: Path) -> np.ndarray:
    octets = _octets(path)
    header = _HEADER.match(octets)
    if header is None or tuple(map(int, header.groups())) != (WIDTH, HEIGHT, 65535):
        raise DepthRecordingError(f"{path.name}: the header begins {octets[:20]!r}; valid: P5 {WIDTH} {HEIGHT} 65535.")
    pixels = octets[header.end() :]
    if len(pixels) != _PICTURE_BYTES:
        raise DepthRecordingError(f"{path.name}: the picture has {len(pixels)} octets; valid: {_PICTURE_BYTES}, two a pixel.")
    return checked_raw(path.name, "the picture", np.frombuffer(pixels, dtype="<u2").reshape(HEIGHT, WIDTH).astype(np.uint16))


def _counts(path: Path) -> tuple[int, int, int]:
    octets = _octets(path)
    if len(octets) < _ACCEL.size:
        raise DepthRecordingError(f"{path.name}: the accelerometer's reading has {len(octets)} octets; valid: 12, with x, y, z first.")
    x, y, z, _tilt = _ACCEL.unpack_from(octets)
    return x, y, z


def _octets(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as fault:
        raise DepthRecordingError(f"{path.name}: the file cannot be read ({fault.strerror}); valid: every file in {INDEX}.") from fault
