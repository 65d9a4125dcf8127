"""A progress bar on a text stream, for runs nobody watches in a window."""

import sys
import time
from typing import TextIO


class Progress:
    """Draws `label [####    ] 42 %  3.1 of 7.5 s` in place; on a stream that is no terminal only every tenth of the way."""

    def __init__(self, label: str, total_s: float, stream: TextIO | None = None) -> None:
        self._label, self._total = label, max(total_s, 1e-9)
        self._stream = stream if stream is not None else sys.stderr
        self._live = self._stream.isatty()
        self._shown = -1
        self._started = time.perf_counter()

    def show(self, done_s: float) -> None:
        """Show that `done_s` simulated seconds are done."""
        part = min(1.0, max(0.0, done_s / self._total))
        tick = int(part * (100 if self._live else 10))
        if tick == self._shown:
            return
        self._shown = tick
        bar = "#" * int(part * 30)
        took = time.perf_counter() - self._started
        line = f"{self._label} [{bar:<30}] {part * 100:3.0f} %  {done_s:.1f} of {self._total:.1f} s, took {took:.0f} s"
        self._stream.write(f"\r{line}" if self._live else f"{line}\n")
        self._stream.flush()

    def close(self) -> None:
        """End the line."""
        if self._live:
            self._stream.write("\n")
            self._stream.flush()
