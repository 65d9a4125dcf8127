"""What each stage of a picture frame costs, milliseconds."""

import statistics
import time
from collections import deque
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

FRAME_BUDGET_MS = 1000.0 / 60.0


class StageTimes:
    """Times of the last 600 frames per stage, measured on the machine's own clock whatever clock paces the game."""

    def __init__(self) -> None:
        self._ms: dict[str, deque[float]] = {}

    @contextmanager
    def measure(self, stage: str) -> Iterator[None]:
        """Add one sample to `stage`: the milliseconds its block took."""
        start = time.perf_counter()
        try:
            yield
        finally:
            self.add(stage, (time.perf_counter() - start) * 1e3)

    def add(self, stage: str, ms: float) -> None:
        """Add one sample, milliseconds."""
        self._ms.setdefault(stage, deque(maxlen=600)).append(ms)

    def medians(self, newest: int = 600) -> Mapping[str, float]:
        """Median of the newest samples of each stage, in the order in which the stages first ran."""
        return {stage: statistics.median(list(ms)[-newest:]) for stage, ms in self._ms.items()}
