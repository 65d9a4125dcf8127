"""Records what a stream of depth frames gives, until time is up or somebody says stop."""

import time
from collections.abc import Callable, Generator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kinect.depth.depth_stream import DepthStream
from kinect.depth.recorder import DepthRecorder

LOOK_EVERY_S: Final = 0.02
TELL_EVERY_S: Final = 0.5


@dataclass(frozen=True)
class RecordedSoFar:
    """frames taken, seconds since the beginning, and what the stream says of itself."""

    frames: int
    seconds: float
    status: str


def record_session(
    stream: DepthStream,
    folder: str | Path,
    seconds: float | None = None,
    now: Callable[[], float] = time.monotonic,
    sleep: Callable[[float], None] = time.sleep,
) -> Generator[RecordedSoFar, None, None]:
    """Write every frame of the stream to a new folder, telling twice a second how it goes, and once at the end.

    It ends after `seconds`, or with the recording that the stream plays, or when the caller stops asking: closing the iterator
    closes the folder properly. Raises DepthRecordingError where the folder cannot be written. The stream is left open.
    """
    length = stream.length_s
    last = min(v for v in (seconds, length, float("inf")) if v is not None)
    began = told = now()
    frames = 0
    with DepthRecorder(folder) as recorder:
        while True:
            passed = now() - began
            for frame in stream.poll(min(passed, last)):
                recorder.write(frame)
                frames += 1
            if passed >= last:
                break
            if now() - told >= TELL_EVERY_S:
                told = now()
                yield RecordedSoFar(frames, passed, stream.status)
            sleep(LOOK_EVERY_S)
    yield RecordedSoFar(frames, min(now() - began, last), stream.status)
