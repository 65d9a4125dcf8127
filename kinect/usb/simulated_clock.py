"""A clock that passes as fast as the program can follow, and can hold everybody up, as the interpreter lock does."""


class VirtualClock:
    """Seconds from 0. With `hold_s` > 0, every `hold_every_s` the time jumps by `hold_s` while nobody could do anything."""

    def __init__(self, hold_every_s: float = 0.5, hold_s: float = 0.0) -> None:
        self._now = 0.0
        self._every, self._hold = hold_every_s, hold_s
        self._next_hold = hold_every_s

    def now(self) -> float:
        """Seconds since the start."""
        return self._now

    def sleep(self, seconds: float) -> None:
        """Let so many seconds pass, and the holds that fall into them."""
        self._now += max(seconds, 0.0)
        while self._hold > 0.0 and self._now >= self._next_hold:
            self._now = max(self._now, self._next_hold + self._hold)
            self._next_hold += self._every
