"""The ordered stages between a sensor's frame and the kinematic target: plausibility, levelling, mirror, smoothing, gate."""

from game.intake.gate import InputGate
from game.intake.mirror import mirror
from game.intake.plausibility import Plausibility
from game.intake.smoothing import JointSmoothing
from game.intake.world_frame import Levelling, WorldFrame
from game.tunables import Settings
from kinect.body import BodyFrame


class Intake:
    """BodyFrame to WorldFrame, one player; causal. `fault` says what was wrong with the last frame, "" if nothing."""

    def __init__(self, settings: Settings, *, mirrored: bool) -> None:
        self._settings = settings
        self._mirrored = mirrored
        self._plausibility = Plausibility()
        self._levelling = Levelling()
        self._smoothing = JointSmoothing()
        self._gate = InputGate(settings)

    @property
    def fault(self) -> str:
        return self._plausibility.fault

    @property
    def held_frames(self) -> int:
        """How many frames were refused so far."""
        return self._plausibility.held_frames

    def apply(self, frame: BodyFrame) -> WorldFrame | None:
        """The frame in the world, or None where it is refused or the gate's buffer still fills."""
        good = self._plausibility.apply(frame, self._settings.number("intake.jump_limit_m"))
        if good is None:
            return None
        raw = self._levelling.apply(good)
        if self._mirrored and self._settings.switch("intake.mirror"):
            raw = mirror(raw)
        return self._gate.apply(good.time_s, self._smoothing.apply(raw, self._settings.number("intake.smoothing")), raw)
