"""The contract of everything that delivers bodies: a recording, a performer, keys, a sensor."""

from typing import Protocol

from kinect.body import BodyFrame


class BodySource(Protocol):
    """A stream of body frames.

    Recordings and performers follow the simulated time they are asked for, so a result does not
    depend on the machine's speed. Live sources return what has arrived and stamp the capture time.
    A source that fails says so in `status`; it never raises into the loop.
    """

    @property
    def status(self) -> str:
        """What the source sees, in plain words for a player."""
        ...

    @property
    def length_s(self) -> float | None:
        """Length of the recording, seconds; None for a live source that never ends."""
        ...

    def poll(self, until_s: float) -> list[BodyFrame]:
        """Every frame not yet handed out with time_s <= until_s, oldest first. The first frame has time_s 0."""
        ...

    def close(self) -> None:
        """Release what the source holds. Calling it twice is harmless."""
        ...
