"""The last ten seconds of some measures for the live plots, one sample for every five frames of 1/60 s."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled

Floats = NDArray[np.float64]

FRAMES_PER_SAMPLE = 5
"""At every frame more points would be drawn than a plot has pixels."""

SAMPLES = 120


class History:
    """Named measures over time; NaN stands for nothing to show. count: of all samples so far."""

    def __init__(self, names: Sequence[str]) -> None:
        self.names = tuple(names)
        # every sample stands in it twice, so that the last ones are always one stretch
        self._kept = np.full((1 + len(names), 2 * SAMPLES), np.nan)
        self._at = self.count = 0

    def add(self, time_s: float, row: Floats) -> None:
        """A sample at `time_s`, which only ever grows: row (n,), in the order of the names."""
        keep(time_s, row, self._at, self._kept)
        self._at = (self._at + 1) % SAMPLES
        self.count += 1

    @property
    def length(self) -> int:
        """How many samples it still has."""
        return min(self.count, SAMPLES)

    def latest(self) -> Floats:
        """(1 + n, m) times and measures, oldest first; a copy that later samples leave alone."""
        end = self._at + SAMPLES
        return self._kept[:, end - self.length : end].copy()


@compiled
def keep(time_s: float, row: Floats, at: int, kept: Floats) -> None:
    """Write a sample into both halves of `kept` (1 + n, 2 SAMPLES)."""
    for column in (at, at + SAMPLES):
        kept[0, column] = time_s
        for k in range(len(row)):
            kept[1 + k, column] = row[k]
