"""Which feet bear the player, in every frame as it comes: heights, the sight of the legs and the jump gate taken together."""

from game.intake.foot_contacts import FootContacts
from game.intake.gate_floor import RestingFoot
from game.intake.gate_jump import Feet, JumpGate
from game.intake.gate_legs import Floats, Leg, LegLengths, LegSight, feet_of, legs_of
from game.tunables import Settings
from kinect.body import Joint

_ROOT = int(Joint.HIP_CENTER)

HIDDEN_LONGER_S = 0.15
"""Legs that come into sight again are believed only after so long."""


class ContactFinder:
    """Contacts of joints (20, 3), world frame, frame by frame; `rest_m` is the height at which the player's ankles stand."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self.feet = (RestingFoot(), RestingFoot())
        self.lengths = LegLengths()
        self._jump = JumpGate()
        self._time_s: float | None = None
        self._seen_s = HIDDEN_LONGER_S
        self._lifted = [False, False]

    @property
    def rest_m(self) -> float:
        """Mean resting height of the two ankles: one floor for both."""
        return 0.5 * (self.feet[0].rest_m + self.feet[1].rest_m)

    def step(self, time_s: float, joints: Floats, smoothed: Floats) -> tuple[FootContacts, tuple[Leg, Leg]]:
        """Contacts of `joints`, which know sooner, and the legs of the same joints `smoothed`, which leap less."""
        number = self._settings.number
        seen = feet_of(joints)
        if self._time_s is None:
            lowest = min(seen[0][2], seen[1][2])
            for side, foot in enumerate(self.feet):
                foot.start(seen[side], lowest)
                self._lifted[side] = not foot.down
            self._time_s = time_s
        dt, self._time_s = time_s - self._time_s, time_s
        senses = self.feet[0].sense(seen[0], dt), self.feet[1].sense(seen[1], dt)
        legs = self.lengths.observe(LegSight(*legs_of(smoothed)), dt, standing=not any(self._lifted))
        hidden = self.lengths.hidden(legs) or senses[0].sunk or senses[1].sunk
        self._seen_s = 0.0 if hidden else self._seen_s + dt
        known = self._seen_s >= HIDDEN_LONGER_S
        if known:
            up_m, down_m, speed_m_s = number("gate.up_m"), number("gate.down_m"), number("gate.foot_speed_m_s")
            for foot, sense in zip(self.feet, senses, strict=True):
                foot.decide(sense, dt, up_m=up_m, down_m=down_m, speed_m_s=speed_m_s)
        pelvis = float(joints[_ROOT, 2]) - self.rest_m
        up = (not self.feet[0].down, not self.feet[1].down)
        flight = self._jump.step(
            time_s, pelvis, Feet(up, known), push_off_m_s=number("gate.push_off_m_s"), limit_s=number("gate.flight_limit_s")
        )
        gated = self._settings.switch("gate.on") and self._settings.switch("gate.jumps")
        self._bear(up, flight or not gated)
        if known:
            share = min(1.0, dt / max(number("gate.floor_time_s"), 1e-3))
            for foot, sight, lifted in zip(self.feet, seen, self._lifted, strict=True):
                if not lifted and foot.down:
                    foot.settle(sight, share)
        planted = (not self._lifted[0], not self._lifted[1])
        lifts = [0.0 if on_floor else max(0.0, sense.lift_m) for on_floor, sense in zip(planted, senses, strict=True)]
        return FootContacts(planted[0], planted[1], not any(planted), lifts[0], lifts[1], known), legs

    def _bear(self, up: tuple[bool, bool], flight: bool) -> None:
        """Both feet leave in flight only: otherwise the one that stood longer goes on bearing, until the other is down."""
        if flight or not all(up):
            self._lifted = list(up)
        elif all(self._lifted):
            self._lifted = [False, False]
        # else one foot is up already and keeps its freedom, or both stand and stay
