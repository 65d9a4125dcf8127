"""Sentences that come, stay a while and fade."""

from collections import Counter
from dataclasses import dataclass

STAY_S = 5.0
FADE_S = 0.8


@dataclass(frozen=True)
class Toast:
    """One sentence and the loop time, seconds, at which it came."""

    text: str
    came_s: float

    def opacity(self, now_s: float) -> float:
        """1 while it stays, down to 0 as it fades."""
        return max(0.0, min(1.0, (self.came_s + STAY_S - now_s) / FADE_S))


class Toasts:
    """The newest few sentences; feed it a scene's whole list each frame and it picks out what is new."""

    def __init__(self, most: int = 4) -> None:
        self._most = most
        self._toasts: list[Toast] = []
        self._seen: tuple[str, ...] = ()

    def follow(self, messages: tuple[str, ...], now_s: float) -> None:
        """Add the messages that were not in the list the last time."""
        fresh = Counter(messages) - Counter(self._seen)
        for text in messages:
            if fresh[text] > 0:
                self.add(text, now_s)
        self._seen = messages

    def add(self, text: str, now_s: float) -> None:
        """Show one sentence from now on; a repeated one starts its time again."""
        self._toasts = [t for t in self._toasts if t.text != text][-self._most + 1 :] + [Toast(text, now_s)]

    def drop(self, text: str) -> None:
        """Take a sentence away: it is said in another place."""
        self._toasts = [t for t in self._toasts if t.text != text]

    def visible(self, now_s: float) -> list[Toast]:
        """Oldest first, those that still show."""
        self._toasts = [t for t in self._toasts if t.opacity(now_s) > 0.0]
        return list(self._toasts)
