"""How far the character's wrists are from those of the person who performs, sensor errors and all delays left out of the person."""

import numpy as np
from numpy.typing import NDArray

from game.characters.body_plan import BodyPlan
from game.inputs.performer import Performer
from game.intake.intake import Intake
from game.report.tracking_error import PosedBody
from game.report.wrist_following import HANDS, WRISTS, places_in_heading
from game.target.calibration import calibrate, quietest_stretch
from game.target.kinematic_target import map_input
from game.tunables import Settings

Floats = NDArray[np.float64]

LONGEST_DELAY_S, DELAY_STEP_S = 0.3, 0.005
ALLOWED_DELAY_S = 0.15
"""A game may be this late, and the error is judged at no longer delay."""


class TrueHands:
    """Samples the wrists relative to the root, in its heading, and compares them with the clean performer's some time before."""

    def __init__(self, name: str, plan: BodyPlan) -> None:
        """name: of the motion; plan: of the character, onto whose size the performer is calibrated."""
        intake = Intake(Settings({"intake.smoothing": 0.0, "gate.on": False, "intake.mirror": False}), mirrored=False)
        frames = [frame for frame in map(intake.apply, Performer(name).poll(1e6)) if frame is not None]
        self._time = np.array([frame.time_s for frame in frames])
        joints = np.array([frame.raw for frame in frames])
        calibration = calibrate(plan, joints[quietest_stretch(self._time, joints)])
        mapped = [map_input(frame, calibration) for frame in joints]
        self._true = np.array([places_in_heading(m.end_effector, WRISTS, m.root_position, m.root_orientation) for m in mapped])
        self._own: list[Floats] = []
        self._own_s: list[float] = []

    def sample(self, time_s: float, body: PosedBody) -> None:
        """The character at `time_s` seconds after the release."""
        self._own_s.append(time_s)
        self._own.append(places_in_heading(body.joint, HANDS, body.joint[0], body.orientation[0]))

    def error_m(self, delay_s: float) -> float | None:
        """Mean distance of both wrists from where the performer's were `delay_s` earlier; None where nothing was sampled."""
        if not self._own:
            return None
        then = np.array(self._own_s) - delay_s
        true = np.stack([np.interp(then, self._time, column) for column in self._true.T], axis=1)
        gap = (np.array(self._own) - true).reshape(len(then), len(HANDS), 3)
        return float(np.sqrt(np.sum(gap * gap, axis=2)).mean())

    def best_delay_s(self) -> float:
        """The delay, up to 0.3 s, at which the error is least."""
        delays = np.arange(0.0, LONGEST_DELAY_S + 1e-9, DELAY_STEP_S)
        return float(min(delays, key=lambda delay: self.error_m(float(delay)) or 0.0))
