"""The input gate: what the player can really have done, frame by frame, causal.

Feet bear or lift (by height and speed), a jump needs a push-off, hidden legs do nothing, planted feet stay put, the pelvis is as high
as the legs reach. Where the player moves as people do and is seen well, the joints pass almost as they came.
"""

import math

import numpy as np
from numpy.typing import NDArray

from game.compiled import compiled
from game.intake.gate_buffer import ContactBuffer, SensedFrame
from game.intake.gate_contacts import ContactFinder
from game.intake.gate_heading import BodyHeading
from game.intake.gate_knees import bend_forward
from game.intake.gate_legs import FOOT_JOINTS, LEGS, feet_of
from game.intake.gate_lock import FootLock
from game.intake.gate_pelvis import PelvisHeight, needed_rise
from game.intake.gate_trunk import TrunkTilt
from game.intake.world_frame import WorldFrame
from game.tunables import Settings

Floats = NDArray[np.float64]


class InputGate:
    """One player's gate. `apply` gives None only while the buffer fills."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._finder = ContactFinder(settings)
        self._buffer = ContactBuffer()
        self._locks = (FootLock(0), FootLock(1))
        self._pelvis = PelvisHeight()
        self._trunk = TrunkTilt()
        self._heading = BodyHeading()
        self._last_s: float | None = None

    def apply(self, time_s: float, joints: Floats, raw: Floats) -> WorldFrame | None:
        """The gated frame of smoothed joints (20, 3) and `raw`, the same before smoothing; world frame, metres."""
        contacts, legs = self._finder.step(time_s, raw, joints)
        if not self._settings.switch("gate.on"):
            return WorldFrame(time_s, joints, raw, contacts)
        frame = self._buffer.apply(SensedFrame(time_s, joints, raw, contacts, legs), self._settings.number("gate.buffer_s"))
        if frame is None:
            return None
        dt = 0.0 if self._last_s is None else frame.time_s - self._last_s
        self._last_s = frame.time_s
        return WorldFrame(frame.time_s, self._corrected(frame, dt), frame.raw, frame.contacts, time_s - frame.time_s)

    def _corrected(self, frame: SensedFrame, dt: float) -> Floats:
        number = self._settings.number
        out, feet = frame.joints.copy(), np.empty((2, 2, 3))
        self._place_feet(frame, dt, feet)
        needs, mosts = [], []
        if self._settings.switch("gate.pelvis"):
            slack, lengths = number("gate.leg_slack"), self._finder.lengths
            for side, planted in enumerate(frame.contacts.planted):
                if planted:
                    rise, leg = float(feet[side, 0, 2] - frame.joints[FOOT_JOINTS[side, 0], 2]), frame.legs[side]
                    needs.append(needed_rise(leg, rise, lengths.leg_m, lengths.stoop_m, slack))
                    mosts.append(leg.rise_m + rise)
        self._pelvis.apply(out, dt, sum(needs) / max(1, len(needs)), max(mosts, default=0.0))
        if dt > 0.0:
            self._trunk.apply(out, number("gate.tilt_rad_s") * dt)
        self._heading.apply(out, dt, self._finder.lengths.leg_m, number("gate.turn_rad_s"), number("gate.twist_rad"))
        _put_feet(out, frame.joints, feet)
        if self._settings.switch("gate.knees"):
            bend_forward(out)
        return out

    def _place_feet(self, frame: SensedFrame, dt: float, feet: Floats) -> None:
        """Fill `feet` (2, 2, 3): ankle and toes of each foot, left first."""
        number, joints = self._settings.number, frame.joints
        if not self._settings.switch("gate.lock"):
            feet[:] = joints[FOOT_JOINTS]
            return
        fade_s, up_m, seen = number("gate.fade_time_s"), number("gate.up_m"), feet_of(joints)
        for side, lock in enumerate(self._locks):
            if not frame.contacts.planted[side]:
                lock.lifted(joints, dt, fade_s, feet[side])
                continue
            lift, heel = self._finder.feet[side].raised(seen[side])
            shown = frame.contacts.known and lift < up_m
            drift_s = number("gate.plant_time_s") if shown else math.inf
            heel_m = heel if shown else 0.0
            lock.planted(joints, dt, self._finder.rest_m, feet[side], heel_m=heel_m, drift_s=drift_s, fade_s=fade_s)


@compiled
def _put_feet(out: Floats, seen: Floats, feet: Floats) -> None:
    """Put ankles and toes of `feet` (2, 2, 3) into the joints `out` (20, 3); a knee goes half as far as hip and ankle from where `seen`."""
    for side in range(2):
        (hip, knee, ankle), toes = LEGS[side], FOOT_JOINTS[side, 1]
        for axis in range(3):
            out[ankle, axis], out[toes, axis] = feet[side, 0, axis], feet[side, 1, axis]
            out[knee, axis] += 0.5 * (out[hip, axis] - seen[hip, axis] + feet[side, 0, axis] - seen[ankle, axis])
