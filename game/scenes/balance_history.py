"""Measures of how one fighter keeps its balance and follows its target, sampled for the live plots."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import ANKLES, JOINTS, WRISTS
from game.characters.strength import joint_strength
from game.compiled import compiled
from game.control.whole_body.capture_point import capture_point, natural_frequency
from game.physics.dynamics import BodyDynamics, lowest_corners
from game.report.tracking_error import in_heading
from game.scenes.foot_loads import ground_loads
from game.scenes.history import FRAMES_PER_SAMPLE, History
from game.scenes.planned_balance import PlannedBalance, kept_limits, planned_balance
from game.scenes.simulation import Simulation
from game.scenes.torque_use import note_torques
from game.tunables import Settings

Floats = NDArray[np.float64]

LOADS = ("load_left", "load_right", "load_left_planned", "load_right_planned")
ERRORS = ("capture_cm", "com_cm", "hands_cm", "feet_cm", "pelvis_deg", "joint_mean_rad", "joint_worst_rad")
BODY = ("torque_nm", "com_height_m", "target_height_m", "com_x", "com_y", "upright_s")
USE = tuple(f"use_{joint}" for joint in JOINTS)

_HANDS = np.array([joint + 1 for joint in WRISTS])
_ANKLE_PARTS = np.array([joint + 1 for joint in ANKLES])


class BalanceHistory:
    """Follows fighter `index` of a simulation, sample by sample, and knows what its present frame shows.

    plan: what its strategy wants; use (14,): share of its limit that each joint uses, of a human's strength where `plan` has no
    limits; capture (2,) m: where its capture point is; loads: as `ground_loads` gives them.
    """

    def __init__(self, settings: Settings, index: int = 0) -> None:
        self._settings, self.index = settings, index
        self.history = History((*LOADS, *ERRORS, *BODY, *USE))
        self.plan = PlannedBalance()
        self.use, self._most_used = np.zeros(len(JOINTS)), np.zeros(len(JOINTS))
        self._most_torque = 0.0
        self._scale, self._strength = -1.0, (np.zeros(0), np.zeros(0))
        self.capture, self.loads = np.zeros(2), np.zeros(5)
        self._frame, self._looked = 0, -1

    def observe(self, simulation: Simulation, upright_s: float = math.nan) -> None:
        """One frame of the simulation: torques are sampled by their peaks, the rest as it is at the sample."""
        body, fighter = simulation.world.characters[self.index], simulation.fighters[self.index]
        low, high = kept_limits(fighter) or self._at_rest(fighter.plan)
        torque = simulation.world.actuation.torque[body.joint_dofs]
        self._most_torque = max(self._most_torque, note_torques(torque, low, high, self.use, self._most_used))
        self._frame += 1
        if self._frame % FRAMES_PER_SAMPLE == 0:
            self.history.add(simulation.clock_s, self._row(simulation, upright_s))
            self._most_used[:], self._most_torque = 0.0, 0.0

    def look(self, simulation: Simulation) -> None:
        """Bring `plan`, `capture` and `loads` up to the present frame."""
        if self._looked != self._frame:
            body = simulation.world.characters[self.index]
            self.plan = planned_balance(simulation.fighters[self.index], body)
            self.capture = captured(body)
            self.loads = ground_loads(simulation.world.meter.contacts, body.root_body)
            self._looked = self._frame

    def _at_rest(self, plan: BodyPlan) -> tuple[Floats, Floats]:
        """A human's strength at rest, for a strategy that keeps to no limits; scaled as for one that does."""
        scale = self._settings.number("whole_body.strength")
        if self._scale != scale:
            low, high = joint_strength(plan)
            self._scale, self._strength = scale, (scale * low, scale * high)
        return self._strength

    def _row(self, simulation: Simulation, upright_s: float) -> Floats:
        self.look(simulation)
        body, target, plan = simulation.world.characters[self.index], simulation.fighters[self.index].target, self.plan
        weight = float(body.subtree_mass[0]) * body.gravity
        left, right, *_ = self.loads.tolist()
        planned = (math.nan, math.nan) if plan.loads_n is None else plan.loads_n
        x, y, height = body.com.tolist()
        following = following_errors(
            body.orientation[0], body.joint, body.joint_rotation, target.root_orientation, target.pose.joint, target.joint_rotation
        )
        return np.array((
            left / weight, right / weight, planned[0] / weight, planned[1] / weight,
            _gap_cm(self.capture, plan.capture), _gap_cm(body.com, plan.com), *following,
            self._most_torque, height, target.com[2], x, y, upright_s, *self._most_used.tolist(),
        ))  # fmt: skip


def captured(body: BodyDynamics) -> Floats:
    """(2,) m, the capture point of a body above its lower foot."""
    floor = min(lowest_corners(body.turn, body.box_centre, body.foot_half))
    return capture_point(body.com, body.com_velocity, natural_frequency(body.gravity, float(body.com[2]) - floor))


def _gap_cm(place: Floats, wanted: Floats | None) -> float:
    return math.nan if wanted is None else 100.0 * math.hypot(place[0] - wanted[0], place[1] - wanted[1])


@compiled
def following_errors(
    root: Floats, joint: Floats, rotation: Floats, wanted_root: Floats, wanted_joint: Floats, wanted_rotation: Floats
) -> tuple[float, float, float, float, float]:
    """Farther wrist and ankle from the target's, relative to the root and in its heading (cm); the pelvis from the target's,
    headings apart (degrees); mean and largest angle about any axis of the joints, parent frame (rad).

    root (4,), joint (15, 3), rotation (14, 4) of the character; the wanted ones of the target.
    """
    hand = foot = 0.0
    own = in_heading(joint, joint[0], root)
    wanted = in_heading(wanted_joint, wanted_joint[0], wanted_root)
    for side in range(2):
        hand = max(hand, 100.0 * one.length(own[_HANDS[side]] - wanted[_HANDS[side]]))
        foot = max(foot, 100.0 * one.length(own[_ANKLE_PARTS[side]] - wanted[_ANKLE_PARTS[side]]))
    heading = one.about_z(one.yaw(root) - one.yaw(wanted_root))
    x, y, z = one.turn_to(root, one.multiply(heading, wanted_root))
    tilt = math.degrees(math.sqrt(x * x + y * y + z * z))
    total = worst = 0.0
    for j in range(len(rotation)):
        for angle in one.turn_to(rotation[j], wanted_rotation[j]):
            total += abs(angle)
            worst = max(worst, abs(angle))
    return hand, foot, tilt, total / (3 * len(rotation)), worst
