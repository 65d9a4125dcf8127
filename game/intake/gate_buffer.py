"""A short wait before a change of contact is believed: a foot that lifts for less than the buffer did not lift."""

from collections import deque
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from game.intake.foot_contacts import FootContacts
from game.intake.gate_legs import Leg

Floats = NDArray[np.float64]

CLOCK_S = 1e-3


@dataclass(frozen=True)
class SensedFrame:
    """A frame on its way through the gate: joints (20, 3) smoothed and raw, world metres; contacts as they looked when it came."""

    time_s: float
    joints: Floats
    raw: Floats
    contacts: FootContacts
    legs: tuple[Leg, Leg]


class ContactBuffer:
    """Hands frames out `length_s` after they came, with contacts that later frames have confirmed; length 0 passes them through."""

    def __init__(self) -> None:
        self._waiting: deque[SensedFrame] = deque()
        self._given: FootContacts | None = None

    def apply(self, frame: SensedFrame, length_s: float) -> SensedFrame | None:
        """The newest frame that is at least `length_s` old, or None while there is none."""
        self._waiting.append(frame)
        ready: SensedFrame | None = None
        while self._waiting and frame.time_s - self._waiting[0].time_s >= length_s - CLOCK_S:
            ready = self._waiting.popleft()
        if ready is None:
            return None
        contacts = self._confirmed(ready.contacts, [later.contacts for later in self._waiting])
        self._given = contacts
        return ready if contacts is ready.contacts else replace(ready, contacts=contacts)

    def _confirmed(self, now: FootContacts, later: list[FootContacts]) -> FootContacts:
        """A flag changes only where every waiting frame has the new value."""
        before = self._given
        if before is None or not later:
            return now
        left = _held(before.left_planted, now.left_planted, [c.left_planted for c in later])
        right = _held(before.right_planted, now.right_planted, [c.right_planted for c in later])
        flight = not left and not right
        if (left, right, flight) == (now.left_planted, now.right_planted, now.flight):
            return now
        return replace(now, left_planted=left, right_planted=right, flight=flight)


def _held(before: bool, now: bool, later: list[bool]) -> bool:
    return now if now == before or all(flag == now for flag in later) else before
