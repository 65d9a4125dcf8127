"""Watches one character through a run and says at the end how it did."""

from game.physics.world import FRAME_HZ
from game.report.tracking_error import TrackingError
from game.report.upright import UprightClock
from game.report.wrist_following import WristFollowing
from game.scenes.fighter import Fighter
from game.scenes.simulation import Simulation

SAMPLE_HZ = 30


class Observer:
    """Call `observe` after each frame of the simulation. Errors count while the character is upright."""

    def __init__(self, fighter: Fighter, length_s: float | None = None) -> None:
        """length_s: of the recording, seconds; None where it does not end."""
        self._fighter, self._length_s = fighter, length_s
        self.upright = UprightClock(fighter.plan.idle_com_height)
        self.error = TrackingError()
        self.wrists = WristFollowing(SAMPLE_HZ)

    def observe(self, simulation: Simulation) -> None:
        """What happens in the hang or after the end of a recording does not count."""
        if simulation.frame <= 0 or (self._length_s is not None and simulation.time_s > self._length_s + 0.5 / FRAME_HZ):
            return
        body = simulation.world.characters[self._fighter.index]
        target = self._fighter.target
        self.upright.observe(simulation.time_s, body.com_height(), float(target.com[2]))
        if self.upright.upright and simulation.frame % (FRAME_HZ // SAMPLE_HZ) == 0:
            self.error.sample(body, body.joint_rotation, target)
            self.wrists.sample(body, target)

    def summary(self) -> dict[str, object]:
        """upright_s, fell_at_s, the errors and the wrists' lag and path ratio."""
        clock = self.upright
        return {
            "upright_s": clock.upright_s,
            "fell_at_s": clock.fell_at_s,
            "target_fault_frames": clock.target_fault_frames,
            **self.error.summary(),
            "wrist_lag_s": self.wrists.lag_s(),
            "wrist_path_ratio": self.wrists.path_ratio(),
        }
