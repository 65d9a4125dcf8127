"""Recordings as NumPy archives (.npz), one array a field."""

import zipfile
from pathlib import Path
from typing import Final

import numpy as np

from kinect.body import Floor, Joint
from kinect.clip_format import Clip, ClipError, checked_clip, numbers

LARGEST_BYTES: Final = 2**30  # a day at 30 frames a second is 0.9 GB; more is no recording
WORDS: Final = ("motion", "subject", "sensor", "source", "license")
JOINT_NAMES: Final = tuple("".join(word.capitalize() for word in joint.name.split("_")) for joint in Joint)


def read_npz(path: Path) -> Clip:
    """The clip in a .npz archive with `positions` and `t` (or `fps`), the rest optional; raises ClipError."""
    where = path.name
    fields = _arrays(path)
    if "positions" not in fields:
        raise ClipError(f"{where}: the key positions is missing; valid: an archive with positions (frames, 20, 3) and t (frames,).")
    _check_joint_names(where, fields.get("joint_names"))
    meta: dict[str, str | float] = {}
    for word in WORDS:
        if word in fields and fields[word].dtype.kind in "US" and fields[word].size == 1:
            meta[word] = str(fields[word].reshape(-1)[0])
    fps = _fps(where, fields.get("fps"))
    if fps is not None:
        meta["fps"] = fps
    t = fields.get("t")
    if t is None:
        if fps is None:
            raise ClipError(f"{where}: the key t is missing; valid: t (frames,) in seconds, or fps.")
        t = np.arange(len(np.atleast_1d(fields["positions"]))) / fps
    return checked_clip(where, fields["positions"], fields.get("confidence"), t, fields.get("floor"), fields.get("floor_est"), meta)


def write_npz(path: Path, clip: Clip) -> None:
    """Write the clip as a compressed archive; positions and confidence as float32, as recordings are shared."""
    fields: dict[str, np.ndarray] = {
        "positions": clip.positions.astype(np.float32),
        "confidence": clip.confidence.astype(np.float32),
        "t": clip.t,
        "joint_names": np.array(JOINT_NAMES),
        "floor": _plane(clip.floor),
        "floor_est": _plane(clip.floor_est),
    }
    fields.update({name: np.array(value) for name, value in clip.meta.items()})
    with path.open("wb") as file:  # an open file keeps numpy from adding a suffix
        np.savez_compressed(file, **fields)  # pyright: ignore[reportArgumentType]


def _arrays(path: Path) -> dict[str, np.ndarray]:
    """Every array of the archive; whatever zip and numpy can raise becomes one ClipError."""
    if path.stat().st_size == 0:
        raise ClipError(f"{path.name}: the file is empty; valid: a .npz archive.")
    if not zipfile.is_zipfile(path):
        raise ClipError(f"{path.name}: the file is not a zip archive or is cut off; valid: a .npz archive.")
    name = "the archive"
    try:
        with zipfile.ZipFile(path) as archive:
            members = {info.filename.removesuffix(".npy"): info for info in archive.infolist()}
            if sum(info.file_size for info in members.values()) > LARGEST_BYTES:
                raise ClipError(f"{path.name}: the archive unpacks to more than 1 GB; valid: a recording of at most a day.")
            arrays: dict[str, np.ndarray] = {}
            for name, info in members.items():
                if name not in _READ:
                    continue
                with archive.open(info) as member:
                    arrays[name] = np.lib.format.read_array(member, allow_pickle=False)
            return arrays
    except ClipError:
        raise
    except Exception as fault:  # a corrupt archive raises a dozen unrelated types
        reason = (str(fault).splitlines() or [type(fault).__name__])[0][:120].rstrip(".")
        raise ClipError(f"{path.name}: {name} cannot be read ({reason}); valid: plain numeric or text arrays in a .npz archive.") from fault


_READ: Final = frozenset({"positions", "confidence", "t", "fps", "joint_names", "floor", "floor_est", *WORDS})


def _check_joint_names(where: str, names: np.ndarray | None) -> None:
    if names is None:
        return
    found = [str(name) for name in names.reshape(-1)[: len(JOINT_NAMES) + 1]]
    if found != list(JOINT_NAMES):
        wrong = next((f"{a!r} in place of {b!r}" for a, b in zip(found, JOINT_NAMES, strict=False) if a != b), f"{names.size} names")
        raise ClipError(f"{where}: joint_names has {wrong}; valid: the Kinect SDK's twenty from HipCenter to FootRight in its order.")


def _fps(where: str, value: np.ndarray | None) -> float | None:
    if value is None:
        return None
    fps = numbers(where, "fps", value).reshape(-1)
    if fps.size != 1 or not 1.0 <= fps[0] <= 1000.0:
        raise ClipError(f"{where}: fps is {fps[:4].tolist()}; valid: one number of frames a second from 1 to 1000.")
    return float(fps[0])


def _plane(floor: Floor | None) -> np.ndarray:
    return np.full(4, np.nan) if floor is None else np.array(floor)
