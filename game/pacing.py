"""How many fixed updates a picture frame owes: an accumulator of wall time, or one by one without a clock."""

from dataclasses import dataclass

from game.scenes.scene import Scene

UPDATE_S = 1.0 / 60.0
LONGEST_CATCH_UP_S = 0.05


@dataclass(frozen=True)
class Due:
    """updates: fixed updates to run now; blend: 0..1, how far to draw from the state before the last update to the one after it."""

    updates: int
    blend: float


class WallPace:
    """Fixed updates follow a clock; a frame that took longer than 50 ms loses the rest, so that a slow machine never spirals.

    Only the number of updates per frame depends on the clock, never what an update does.
    """

    def __init__(self) -> None:
        self._last_s: float | None = None
        self._owed_s = 0.0
        self._kept: list[tuple[float, float]] = []

    def due(self, now_s: float, paused: bool = False) -> Due:
        """Ask once per picture frame with the clock's time, seconds."""
        passed = 0.0 if self._last_s is None else max(0.0, now_s - self._last_s)
        self._last_s = now_s
        if paused:
            return Due(0, self._owed_s / UPDATE_S)
        taken = min(passed, LONGEST_CATCH_UP_S)
        self._note(now_s, passed, taken)
        self._owed_s += taken
        updates = int(self._owed_s / UPDATE_S + 1e-9)
        self._owed_s = max(0.0, self._owed_s - updates * UPDATE_S)
        return Due(updates, min(1.0, self._owed_s / UPDATE_S))

    @property
    def speed(self) -> float:
        """Simulated seconds per second over about the last one; 1.0 is keeping up."""
        passed = sum(p for p, _ in self._kept)
        return sum(t for _, t in self._kept) / passed if passed > 0.3 else 1.0

    def _note(self, now_s: float, passed: float, taken: float) -> None:
        self._kept.append((passed, taken))
        while len(self._kept) > 2 and sum(p for p, _ in self._kept) - self._kept[0][0] > 1.0:
            self._kept.pop(0)


class StepPace:
    """A fixed number of updates per picture frame and no clock: the same pictures on any machine."""

    speed = 1.0

    def __init__(self, updates_per_frame: int = 1) -> None:
        self._updates = updates_per_frame

    def due(self, now_s: float, paused: bool = False) -> Due:
        """`updates_per_frame` updates whatever the time; none while paused. Draws the newest state."""
        return Due(0 if paused else self._updates, 1.0)


def is_over(scene: Scene, seconds: float | None) -> bool:
    """Has a run nobody watches come to its end: `seconds` of simulated time after the start-up hang, else the end of the recording?"""
    return scene.finished if seconds is None else scene.time_s >= seconds - 1e-6
