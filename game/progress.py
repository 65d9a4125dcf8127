"""A progress bar on a text stream, for runs nobody watches in a window."""

import sys
import time
from typing import TextIO


class Progress:
    """Draws `label [####    ] 42 %  3.1 of 7.5 s` in place; on a stream that is no terminal only every tenth of the way.

    start_s: simulated time at the start, negative where a start-up hang comes first: the bar counts it, the seconds do not.
    unit: what is counted. Where the whole length is not known (None) it counts seconds, on such a stream every tenth one.
    """

    def __init__(self, label: str, total_s: float | None, stream: TextIO | None = None, start_s: float = 0.0, unit: str = "s") -> None:
        self._label, self._total, self._start = label, total_s, start_s
        self._unit, self._decimals = unit, 1 if unit == "s" else 0
        self._stream = stream if stream is not None else sys.stderr
        self._live = self._stream.isatty()
        self._shown = -1
        self._started = time.perf_counter()

    def show(self, done_s: float) -> None:
        """Show that `done_s` simulated seconds are done."""
        took = time.perf_counter() - self._started
        if self._total is None:
            tick = int(done_s) if self._live else int(done_s) // 10
            line = f"{self._label}  {max(0.0, done_s):.0f} s, took {took:.0f} s"
        else:
            part = min(1.0, max(0.0, (done_s - self._start) / max(self._total - self._start, 1e-9)))
            tick = int(part * (100 if self._live else 10))
            seconds = f"{max(0.0, done_s):.{self._decimals}f} of {self._total:.{self._decimals}f} {self._unit}, took {took:.0f} s"
            line = f"{self._label} [{'#' * int(part * 30):<30}] {part * 100:3.0f} %  {seconds}"
        if tick == self._shown:
            return
        self._shown = tick
        self._stream.write(f"\r{line}" if self._live else f"{line}\n")
        self._stream.flush()

    def close(self) -> None:
        """End the line."""
        if self._live:
            self._stream.write("\n")
            self._stream.flush()
