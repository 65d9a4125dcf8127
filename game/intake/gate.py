"""The input gate: what the player can really have done, frame by frame, causal.

Feet bear or lift (by height and speed), a jump needs a push-off, hidden legs do nothing, planted feet stay put, the pelvis is as high
as the legs reach. Where the player moves as people do and is seen well, the joints pass almost as they came.
"""

import math

import numpy as np
from numpy.typing import NDArray

from game.intake.gate_buffer import ContactBuffer, SensedFrame
from game.intake.gate_contacts import ContactFinder
from game.intake.gate_heading import BodyHeading
from game.intake.gate_legs import ANKLES, FEET, HIPS, KNEES
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
        out = frame.joints.copy()
        feet = self._placed_feet(frame, dt)
        needs, mosts = [], []
        for side, planted in enumerate(frame.contacts.planted):
            if planted:
                rise = float(feet[side][0, 2] - frame.joints[ANKLES[side], 2])
                leg, lengths = frame.legs[side], self._finder.lengths
                needs.append(needed_rise(leg, rise, lengths.leg_m, lengths.stoop_m, self._settings.number("gate.leg_slack")))
                mosts.append(leg.rise_m + rise)
        if not self._settings.switch("gate.pelvis"):
            needs, mosts = [], []
        self._pelvis.apply(out, dt, sum(needs) / max(1, len(needs)), max(mosts, default=0.0))
        if dt > 0.0:
            self._trunk.apply(out, self._settings.number("gate.tilt_rad_s") * dt)
        self._heading.apply(out, dt, self._finder.lengths.leg_m, self._settings.number("gate.turn_rad_s"), self._settings.number("gate.twist_rad"))
        for side, foot in enumerate(feet):
            out[ANKLES[side]], out[FEET[side]] = foot
            knee, hip = KNEES[side], HIPS[side]
            out[knee] += 0.5 * (out[hip] - frame.joints[hip] + foot[0] - frame.joints[ANKLES[side]])
        return out

    def _placed_feet(self, frame: SensedFrame, dt: float) -> list[Floats]:
        """(2, 3) ankle and toes of each foot, left first."""
        number = self._settings.number
        if not self._settings.switch("gate.lock"):
            return [frame.joints[[ANKLES[side], FEET[side]]] for side in (0, 1)]
        placed = []
        fade_s = number("gate.fade_time_s")
        for side, lock in enumerate(self._locks):
            resting, joints = self._finder.feet[side], frame.joints
            if not frame.contacts.planted[side]:
                placed.append(lock.lifted(joints, dt, fade_s))
                continue
            lift, heel = resting.raised(joints)
            seen = frame.contacts.known and lift < number("gate.up_m")
            drift_s = number("gate.plant_time_s") if seen else math.inf
            heel_m = heel if seen else 0.0
            placed.append(lock.planted(joints, dt, self._finder.rest_m, heel_m=heel_m, drift_s=drift_s, fade_s=fade_s))
        return placed
