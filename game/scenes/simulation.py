"""The clockwork that every scene with characters shares: hang, release, then frames of sensing, control and physics."""

import time
from collections.abc import Callable, Sequence

from game.physics.hang import HANG_S
from game.physics.world import FRAME_HZ, World
from game.scenes.fighter import Fighter
from game.tunables import Settings
from kinect.source import BodySource

HANG_FRAMES = round(HANG_S * FRAME_HZ)
Opener = Callable[[], BodySource]


class Simulation:
    """A world and its fighters, advanced in 60 Hz frames.

    `frame` counts from the last release and is negative in a hang; `frames_run` counts from the very beginning.
    """

    def __init__(self, fighters: Sequence[Fighter], settings: Settings) -> None:
        self.fighters = list(fighters)
        self._settings = settings
        self.world = World([f.plan for f in fighters], settings)
        self.frames_run = 0
        self._settings_seen, self._command_steps = -1, 1
        self.stage_s = {"target": 0.0, "control": 0.0, "physics": 0.0}
        self.hang_again()

    @property
    def time_s(self) -> float:
        return self.frame / FRAME_HZ

    @property
    def clock_s(self) -> float:
        """Seconds since the first release, over all rounds; negative in the first hang."""
        return (self.frames_run - HANG_FRAMES) / FRAME_HZ

    @property
    def hanging(self) -> bool:
        return self.frame < 0

    def hang_again(self) -> None:
        """Take everybody back to the start: the next frames are a hang, then a release."""
        self.frame = -HANG_FRAMES
        for fighter in self.fighters:
            fighter.hang(self.world)
        # held roots are no secret, so nothing is metered until the release
        self.world.meter.active = False
        self.previous = self.current = self.snapshot()

    def advance(self) -> None:
        """One frame: the hang ends at frame 0, from then on recordings play and time counts."""
        if self.frame == 0:
            for fighter in self.fighters:
                fighter.release(self.world)
            self.world.meter.active = True
        stamp = time.perf_counter()
        for fighter in self.fighters:
            fighter.watch(self._source_time(fighter))
        stamp = self._spent("target", stamp)
        per_command = self._steps_per_command()
        for step in range(self.world.steps_per_frame):
            if step % per_command == 0:
                stamp = self._spent("physics", stamp)
                self.world.refresh()
                for fighter in self.fighters:
                    fighter.control(self.world, per_command * self.world.step_s)
                stamp = self._spent("control", stamp)
            self.world.step()
        stamp = self._spent("physics", stamp)
        self.frame += 1
        self.frames_run += 1
        self.world.refresh()
        self.previous, self.current = self.current, self.snapshot()

    def _source_time(self, fighter: Fighter) -> float:
        """A recording waits in its first frame during the hang; a live player has been seen for half a second already."""
        if fighter.source.length_s is not None:
            return max(0, self.frames_run - HANG_FRAMES) / FRAME_HZ
        return fighter.first_frame.time_s + (self.frames_run + 1) / FRAME_HZ

    def _steps_per_command(self) -> int:
        if self._settings.version != self._settings_seen:
            self._settings_seen = self._settings.version
            self._command_steps = max(1, round(self.world.steps_per_frame * FRAME_HZ / float(self._settings.choice("control.rate_hz"))))
        return self._command_steps

    def _spent(self, stage: str, since: float) -> float:
        now = time.perf_counter()
        self.stage_s[stage] += now - since
        return now

    def snapshot(self) -> list[tuple]:
        """Box centres (15, 3) and orientations (15, 4) of every character, for interpolated drawing."""
        return [(body.box_centre, body.orientation) for body in self.world.characters]

    def close(self) -> None:
        for fighter in self.fighters:
            fighter.close()
