"""The floor sought beside the game: one look takes longer than a picture may."""

import threading
from typing import Final

from kinect.body import Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.floor_guess import LowestGuess
from kinect.depth.floor_watch import LOOK_EVERY_S, FloorWatch

JOIN_S: Final = 2.0


class FloorSeeker:
    """Shown frames by one thread, looks at the newest of them twice a second in another."""

    def __init__(self) -> None:
        self.floor: Floor | None = None
        self.drawn: Floor | None = None
        self.why = "no floor was looked for yet"
        self._watch = FloorWatch()
        self._guess = LowestGuess()
        self._newest: DepthFrame | None = None
        self._looked_s: float | None = None
        self._shown = threading.Event()
        self._closing = False
        self._thread = threading.Thread(target=self._run, name="kinect floor", daemon=True)
        self._thread.start()

    def show(self, frame: DepthFrame) -> None:
        """Here is a newer frame; returns at once."""
        self._newest = frame
        if self._looked_s is None or not 0.0 <= frame.time_s - self._looked_s < LOOK_EVERY_S:
            self._shown.set()

    def close(self) -> None:
        """End the thread. Calling it twice is harmless."""
        self._closing = True
        self._shown.set()
        self._thread.join(JOIN_S)

    def _run(self) -> None:
        while True:
            self._shown.wait()
            self._shown.clear()
            frame = self._newest
            if self._closing:
                return
            if frame is not None:
                self._look(frame)
                self._looked_s = frame.time_s

    def _look(self, frame: DepthFrame) -> None:
        self.floor = self._watch.see(frame)
        self.why = self._watch.why
        if self.floor is None and self._watch.hint is None:
            self._guess.see(frame)
        self.drawn = self.floor or self._watch.hint or self._guess.floor
