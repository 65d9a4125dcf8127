"""From the device's ticks to seconds that only grow: unwrapped, and carried over interruptions by the host's clock."""

from typing import Final

TICKS_PER_S: Final = 60_000_000
DEPTH_PERIOD_TICKS: Final = 2_002_155
"""Ticks from one depth frame to the next: 33.369 ms, 29.968 frames/s."""
WRAP: Final = 1 << 32
TRUST_S: Final = 1.0
"""How far ticks and host clock may drift apart between two frames before the ticks are held to have started anew."""
LEAST_STEP_S: Final = 1e-4


class CaptureTime:
    """Seconds since the first frame, strictly growing: by the device's ticks while they make sense, else by the host's clock."""

    def __init__(self) -> None:
        self._ticks: int | None = None
        self._host_s = 0.0
        self._time_s = 0.0

    def seconds(self, ticks: int, host_s: float) -> float:
        """Capture time of a frame that carries `ticks` (32 bits, wrapping every 71.58 s) and arrived at `host_s` on the host's clock."""
        if self._ticks is None:
            step = 0.0
        else:
            step = ((ticks - self._ticks) % WRAP) / TICKS_PER_S
            waited = host_s - self._host_s
            if abs(step - waited) > TRUST_S:
                step = max(waited, LEAST_STEP_S)
            step = max(step, LEAST_STEP_S)
        self._ticks, self._host_s = ticks, host_s
        self._time_s += step
        return self._time_s
