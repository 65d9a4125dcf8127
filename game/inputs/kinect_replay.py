"""A Kinect without body tracking: depth pictures and the floor are there, and a stand-in stands quietly where the body will be."""

from pathlib import Path
from typing import Final

from game.inputs.stand_in import StandIn
from kinect.body import BodyFrame, Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.depth_stream import DepthStream, RecordedDepth, WiredDepth
from kinect.depth.floor_guess import LowestGuess
from kinect.depth.floor_watch import FloorWatch
from kinect.depth.recording import open_depth_recording

NO_BODY: Final = "No body tracking yet: it just stands."
GUESS_EVERY: Final = 15  # frames


class DepthInput:
    """A `BodySource` over a stream of depth frames that shows what it sees and where the floor is, but knows no bodies.

    Frames are only taken from the stream when `depth` is asked for, so that who needs bodies alone need not unpack pictures.
    """

    def __init__(self, stream: DepthStream) -> None:
        self._stream = stream
        self._stand_in = StandIn()
        self._closed = False
        self._watch = FloorWatch()
        self._until_s = 0.0
        self._newest: DepthFrame | None = None
        self._guess = LowestGuess()
        self._frames = 0

    @property
    def status(self) -> str:
        seen = "" if self._newest is None else f" {floor_in_words(self._watch.floor)}"
        return f"{self._stream.status} {NO_BODY}{seen}"

    @property
    def floor_why(self) -> str:
        """In words: where the floor is, or what was seen in place of one."""
        return self._watch.why

    @property
    def length_s(self) -> float | None:
        """Length of the recording, seconds; None for a sensor."""
        return self._stream.length_s

    @property
    def floor(self) -> Floor | None:
        """The plane of the floor in the sensor frame, None while none was seen."""
        return self._watch.floor

    @property
    def drawn_floor(self) -> Floor | None:
        """The floor, or where none was seen a scrap of something level, or the lowest thing seen; None before the first picture."""
        return self._watch.floor or self._watch.hint or self._guess.floor

    def poll(self, until_s: float) -> list[BodyFrame]:
        """The stand-in's frames up to until_s, over the floor that was found: it stands while nobody is tracked."""
        length = self._stream.length_s
        self._until_s = max(self._until_s, until_s)
        last = until_s if length is None else min(until_s, length)
        return [] if self._closed else self._stand_in.poll(last, self._watch.floor)

    def depth(self) -> DepthFrame | None:
        """The newest depth frame of the time last polled for, None before the first."""
        for frame in self._stream.poll(self._until_s):
            self._newest = frame
            if self._watch.see(frame) is None and self._frames % GUESS_EVERY == 0:
                self._guess.see(frame)
            self._frames += 1
        return self._newest

    def close(self) -> None:
        """Release the stream. Calling it twice is harmless."""
        self._stream.close()
        self._closed = True


def floor_in_words(floor: Floor | None) -> str:
    """For a status line: how far below the sensor the floor is, or that none was seen."""
    return "No floor seen." if floor is None else f"Floor {floor.d:.2f} m below."


def replay(path: str | Path) -> DepthInput:
    """A depth recording played frame by frame; raises DepthRecordingError."""
    return DepthInput(RecordedDepth(open_depth_recording(path)))


def replay_through_driver(path: str | Path) -> DepthInput:
    """The same, sent through packets, pyusb and the whole driver on a simulated libusb; raises DepthRecordingError."""
    return DepthInput(WiredDepth(open_depth_recording(path)))
