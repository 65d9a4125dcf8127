"""Pictures out of a NumPy archive one at a time, so that a minute of depth needs no gigabyte of memory."""

import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.depth.intrinsics import HEIGHT, WIDTH
from kinect.depth.recording_format import DepthRecordingError

PICTURE_BYTES: Final = HEIGHT * WIDTH * 2
LARGEST_FIELD_BYTES: Final = 2**28
VALID_ARCHIVE: Final = "valid: a .npz archive with raw11 and ticks, or depth_mm and t_us"


def fields_of(path: Path) -> frozenset[str]:
    """Names of the arrays in the archive; raises DepthRecordingError."""
    with _opened(path) as archive:
        return frozenset(name.removesuffix(".npy") for name in archive.namelist())


def small_field(path: Path, field: str) -> np.ndarray:
    """One array of the archive, whole; raises DepthRecordingError where it is missing or damaged."""
    with _opened(path) as archive:
        try:
            if archive.getinfo(f"{field}.npy").file_size > LARGEST_FIELD_BYTES:
                raise DepthRecordingError(f"{path.name}: {field} unpacks to more than 256 MB; {VALID_ARCHIVE}.")
            with archive.open(f"{field}.npy") as member:
                return np.lib.format.read_array(member, allow_pickle=False)
        except DepthRecordingError:
            raise
        except KeyError as fault:
            raise DepthRecordingError(f"{path.name}: the field {field} is missing; {VALID_ARCHIVE}.") from fault
        except Exception as fault:  # a corrupt archive raises a dozen unrelated types
            raise _damaged(path, field, fault) from fault


def picture_count(path: Path, field: str) -> int:
    """How many pictures the array holds; raises DepthRecordingError where it is not (frames, 480, 640) of uint16."""
    for picture in _stream(path, field, header_only=True):
        return int(picture)
    raise AssertionError("a stream begins with its count")


def pictures(path: Path, field: str) -> Iterator[NDArray[np.uint16]]:
    """The pictures of an array (frames, 480, 640) of uint16, one after the other; raises DepthRecordingError."""
    stream = _stream(path, field, header_only=False)
    next(stream)
    yield from stream  # pyright: ignore[reportReturnType]


def _stream(path: Path, field: str, header_only: bool) -> Iterator[int | NDArray[np.uint16]]:
    with _opened(path) as archive:
        try:
            with archive.open(f"{field}.npy") as member:
                frames = _frames_in_header(path, field, member)
                yield frames
                for k in range(0 if header_only else frames):
                    octets = member.read(PICTURE_BYTES)
                    if len(octets) < PICTURE_BYTES:
                        raise DepthRecordingError(f"{path.name}: {field} is cut off in frame {k}; valid: {frames} whole pictures.")
                    yield np.frombuffer(octets, dtype="<u2").reshape(HEIGHT, WIDTH).astype(np.uint16)
        except DepthRecordingError:
            raise
        except KeyError as fault:
            raise DepthRecordingError(f"{path.name}: the field {field} is missing; {VALID_ARCHIVE}.") from fault
        except Exception as fault:
            raise _damaged(path, field, fault) from fault


def _frames_in_header(path: Path, field: str, member) -> int:
    version = np.lib.format.read_magic(member)
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    shape, fortran, dtype = read(member)
    if len(shape) != 3 or shape[1:] != (HEIGHT, WIDTH) or shape[0] == 0 or dtype != np.dtype("<u2") or fortran:
        raise DepthRecordingError(
            f"{path.name}: {field} is {dtype.name} of shape {shape}; valid: uint16 of shape (frames, {HEIGHT}, {WIDTH}), one frame or more."
        )
    return shape[0]


def _opened(path: Path) -> zipfile.ZipFile:
    try:
        return zipfile.ZipFile(path)
    except zipfile.BadZipFile as fault:
        raise DepthRecordingError(f"{path.name}: the file is not a zip archive or is cut off; {VALID_ARCHIVE}.") from fault
    except OSError as fault:
        raise DepthRecordingError(f"{path}: the file cannot be read ({fault.strerror or fault}); {VALID_ARCHIVE}.") from fault


def _damaged(path: Path, field: str, fault: Exception) -> DepthRecordingError:
    reason = (str(fault).splitlines() or [type(fault).__name__])[0][:120].rstrip(".")
    return DepthRecordingError(f"{path.name}: {field} cannot be read ({reason}); {VALID_ARCHIVE}.")
