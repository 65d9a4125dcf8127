"""One door to every depth recording: ours, fakenect's, and archives of raw or millimetre pictures."""

from pathlib import Path
from typing import Final

from kinect.depth.recording_fakenect import INDEX, read_fakenect
from kinect.depth.recording_format import DepthRecording, DepthRecordingError
from kinect.depth.recording_npz import joined, raw_archive, read_npz

__all__ = ["DepthRecording", "DepthRecordingError", "open_depth_recording"]

VALID: Final = f"a folder that `kinect record` wrote, a fakenect folder with {INDEX}, or a .npz with raw11 or depth_mm"


def open_depth_recording(path: str | Path) -> DepthRecording:
    """The recording at a file or folder, its frames still on disk; raises DepthRecordingError."""
    path = Path(path)
    if path.is_dir():
        if (path / INDEX).exists():
            return read_fakenect(path)
        return _read_chunks(path)
    if not path.exists():
        raise DepthRecordingError(f"{path}: there is no such file or folder; valid: {VALID}.")
    if path.suffix.lower() != ".npz":
        raise DepthRecordingError(f"{path.name}: this is no depth recording's name; valid: {VALID}.")
    return read_npz(path)


def _read_chunks(folder: Path) -> DepthRecording:
    """What the recorder wrote: the archives in their order, one clock running through them all."""
    chunks = sorted(folder.glob("depth-*.npz"))
    if not chunks:
        raise DepthRecordingError(f"{folder}: there is no recording in this folder; valid: {VALID}.")
    unfinished = any(folder.glob("depth-*.part"))
    notes = ("it was cut off while recording, up to a second is missing",) if unfinished else ()
    return joined(folder.name, [raw_archive(chunk) for chunk in chunks], notes)
