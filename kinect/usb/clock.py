"""The host's clock, exchangeable so that a minute of streaming can be simulated in seconds."""

import time
from typing import Protocol


class Clock(Protocol):
    """Seconds that grow, and a way to let them pass."""

    def now(self) -> float:
        """Seconds since any fixed instant."""
        ...

    def sleep(self, seconds: float) -> None:
        """Let so many seconds pass."""
        ...


class WallClock:
    """Real time."""

    def now(self) -> float:
        """Seconds since some fixed instant."""
        return time.monotonic()

    def sleep(self, seconds: float) -> None:
        """Wait so long; not at all for a negative time."""
        time.sleep(max(seconds, 0.0))
