"""What every depth recording is once it is open, and how the device's clock becomes seconds."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.body import Floats
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.disparity import CODES
from kinect.depth.intrinsics import HEIGHT, WIDTH

TICKS_HZ: Final = 60e6
TICK_WRAP: Final = 2**32
LONGEST_GAP_S: Final = 3600.0


class DepthRecordingError(ValueError):
    """A depth recording that cannot be read or written; the message is one sentence with file, field, fault and what is valid."""


@dataclass(frozen=True)
class DepthRecording:
    """An open recording: iterate over it, as often as you like, for its frames in order, each read when its turn comes.

    name: of the file or folder. times: (T,) seconds of the frames, growing from 0. notes: what was assumed or left out, in words.
    Iterating raises DepthRecordingError where a frame cannot be read.
    """

    name: str
    times: Floats
    read: Callable[[], Iterator[DepthFrame]]
    notes: tuple[str, ...] = ()

    def __iter__(self) -> Iterator[DepthFrame]:
        return self.read()

    def __len__(self) -> int:
        return len(self.times)

    @property
    def length_s(self) -> float:
        """Time of the last frame, seconds."""
        return float(self.times[-1])


def checked_raw(where: str, field: str, picture: NDArray[np.uint16]) -> NDArray[np.uint16]:
    """A picture of raw codes, (480, 640), made read-only; raises DepthRecordingError where it is none."""
    if picture.shape != (HEIGHT, WIDTH):
        raise DepthRecordingError(f"{where}: {field} has pictures of shape {picture.shape}; valid: ({HEIGHT}, {WIDTH}).")
    highest = int(picture.max())
    if highest >= CODES:
        raise DepthRecordingError(f"{where}: {field} holds the value {highest}; valid: raw disparity of 11 bits, 0 to {CODES - 1}.")
    picture.flags.writeable = False
    return picture


def seconds_from_ticks(ticks: NDArray[np.uint32], host_s: Floats | None = None) -> tuple[Floats, NDArray[np.bool_]]:
    """Seconds from the first frame, (T,), of a 60 MHz clock that wraps every 71.6 s; and which frames advance, (T,) bool.

    Host times (T,), where known, tell how often the clock wrapped in a long gap; without them a gap is shorter than one wrap,
    and a step of more than half a wrap is one backwards.
    """
    steps = np.diff(ticks.astype(np.int64)) % TICK_WRAP
    if host_s is None:
        steps = np.where(steps > TICK_WRAP // 2, steps - TICK_WRAP, steps)
    else:
        waited = np.clip(np.diff(host_s), -LONGEST_GAP_S, LONGEST_GAP_S) * TICKS_HZ
        steps = steps + np.round((waited - steps) / TICK_WRAP).astype(np.int64) * TICK_WRAP
    time = np.concatenate(([0], np.cumsum(steps)))
    advancing = np.concatenate(([True], time[1:] > np.maximum.accumulate(time)[:-1]))
    return time / TICKS_HZ, advancing


def ticks_at(time_s: float) -> int:
    """The 60 MHz clock's reading time_s after 0, for recordings that keep only seconds."""
    return round(time_s * TICKS_HZ) % TICK_WRAP
