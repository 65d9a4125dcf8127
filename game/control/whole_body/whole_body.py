"""The strategy itself: the player's motion and the plan for the feet as tasks, one optimisation, torques for every joint."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import FEET, JOINT_COUNT, PARTS
from game.characters.strength import joint_strength
from game.control.ankle_strategy import AnkleStrategy
from game.control.joint_command import BodyState, JointCommand
from game.control.whole_body.bracing import CALM, bracing
from game.control.whole_body.capture_point import capture_point, natural_frequency, players_capture_point, steer
from game.control.whole_body.contact_wrenches import cone_rows
from game.control.whole_body.falling import is_lost
from game.control.whole_body.felt_push import FeltPush
from game.control.whole_body.foot_goals import flight_task, foot_task
from game.control.whole_body.footing import Footing
from game.control.whole_body.hold_damping import hold
from game.control.whole_body.leap import ComHeight, leap_speed, taking_off
from game.control.whole_body.leg_kinematics import sole_motions
from game.control.whole_body.motion_window import Motion, MotionWindow
from game.control.whole_body.on_the_floor import OnTheFloor, Stage
from game.control.whole_body.pelvis_goal import held_by_feet
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.posed_tick import Body, Wanted, pose_and_answer, room_for_posed
from game.control.whole_body.sole import PRESSURE_MARGIN_M, Sole, soles_of
from game.control.whole_body.standing_up import StandingUp
from game.control.whole_body.sway import Sway
from game.control.whole_body.task_weights import COM_WEIGHT, JOINT_WEIGHT, PLANNED, TaskWeights
from game.control.whole_body.torque_limits import Problem, within_limits
from game.control.whole_body.wish import wish_of
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings

Floats = NDArray[np.float64]

GOAL_TIME_S = 0.04
"""Low-pass of where the capture point should be."""

GOAL_MARGIN_M, GOAL_ENDS_M = 0.045, 0.035
"""The capture point is wanted this far inside the soles, and this much more from heels and toes: there is room left to push with."""

LEAST_LOAD = 0.5
"""Share of the weight that the floor is reckoned with at least when it is to push sideways."""

LANDED_S = 0.4
"""So long after a landing all turning is to end."""

SETTLE_S = 1.0
"""For so long after a step that saved the balance the player's place follows to where it has led."""

_NO_ROWS, _NO_STIFFNESS = np.zeros((0, 0)), np.zeros(3 * JOINT_COUNT)
_PRICE = 1e-6 * np.tile([1.0, 1.0, 1.0, 21.0, 6.0, 21.0], 2)
"""What a wrench costs, so that the least one is taken."""


_TRUNK = PARTS.index("trunk")
_FEET = slice(FEET[0], FEET[1] + 1, FEET[1] - FEET[0])
_STANDING: dict[tuple[bool, bool], tuple[int, ...]] = {(False, False): (), (True, False): (0,), (False, True): (1,), (True, True): (0, 1)}


class WholeBody:
    """Balance strategy `whole-body`. Its readable fields are for the overlay's balance layer and for reports.

    cos (3,): where the pressure under the feet is wanted; com_target (3,): where the capture point is wanted, at the COM's height;
    torque (42,) N m, wrench (n,), momentum (3,) of the last tick; standing: the feet that `wrench` (6 numbers each) belongs to;
    limits: the least and the largest torque (42,) N m that the joints had at their speed, None before the first tick.
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self.cos = np.zeros(3)
        self.com_target = np.zeros(3)
        self._ready = False
        self._hanging = AnkleStrategy(settings)
        self._posed = room_for_posed()

    def reset(self, dynamics: BodyState) -> None:
        self._ready = True
        self.footing = Footing()
        self.felt = FeltPush()
        self._weights = TaskWeights(self._settings, np.array(joint_strength(dynamics.plan)))
        self._total_mass = float(dynamics.subtree_mass[0])
        self._hanging.reset(dynamics)
        self._window = MotionWindow()
        self._player = PlayerStance(float(dynamics.plan.joint[FEET[0], 2]))
        self._last: KinematicTarget | None = None
        self._since_s = 0.0
        self._goal: tuple[float, float] | None = None
        self.com_target = dynamics.com.copy()
        self.floor = OnTheFloor()
        self._rise: StandingUp | None = None
        self._height = ComHeight()
        self.wrench = np.zeros(0)
        self.standing: tuple[int, ...] = ()
        self._bracing = CALM
        self.limits: tuple[Floats, Floats] | None = None

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        if not self._ready:
            self.reset(dynamics)
        self._listen(target, dynamics, dt)
        if dynamics.held:
            return self._hanging.command(target, dynamics, dt)
        soles = soles_of(dynamics)
        if self._has_fallen(target, dynamics, soles, dt):
            return self.floor.command(dynamics, self._weights.full_strength, self._settings.number("whole_body.strength"), dt)
        delay = self._settings.number("whole_body.delay_s")
        motion = self._window.moment(self._window.newest_s + self._since_s - delay)
        if self._rise is not None:
            motion = self._rise.on_the_way(motion, dt)
            self._rise = None if self._rise.done else self._rise
        frequency = self._plan(motion, dynamics, soles, dt)
        return self._solve(motion, dynamics, soles, frequency, dt)

    @property
    def fallen(self) -> bool:
        """It falls, lies or gets up; nothing is planned."""
        return self.floor.lies

    @property
    def stays_down(self) -> bool:
        """It has tried to get up often enough."""
        return self.floor.stays_down

    def _has_fallen(self, target: KinematicTarget, body: BodyState, soles: tuple[Sole, Sole], dt: float) -> bool:
        floor = self.floor
        if floor.lies:
            if floor.stands_ready(body, self._settings.switch("whole_body.get_up"), dt):
                self._take_stance(target, body)
            return floor.lies
        if floor.stage is Stage.STANDING_UP:
            floor.rise(float(body.com[2]), float(target.com[2]) - self._player.floor_z, dt)
        elif body.com[2] < min(0.5, 0.8 * target.com[2]):
            floor.fall()
        if not self.footing.flying:
            xi = capture_point(body.com, body.com_velocity, natural_frequency(body.gravity, float(body.com[2])))
            if is_lost(self.footing.reach_hull(soles), body.com, xi, float(body.turn[_TRUNK, 2, 2])):
                floor.fall()
        return floor.lies

    def _take_stance(self, target: KinematicTarget, body: BodyState) -> None:
        """Both feet stand where they are, and the player's world lies over them."""
        self.footing, self.felt, self._height, self._goal = Footing(), FeltPush(), ComHeight(), None
        self._player.settle(target, body.joint[_FEET], one.yaw(body.orientation[0]))
        self._player.watch(target)
        self._rise = StandingUp(body, self._player)

    def _listen(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> None:
        self._since_s += dt
        ankles = dynamics.joint[_FEET]
        if self._last is None:
            self._player.settle(target, ankles, one.yaw(dynamics.orientation[0]))
        if target is not self._last:
            self._last, self._since_s = target, 0.0
            self._window.add(target, 2.0 * self._settings.number("whole_body.delay_s"))
            self._player.watch(target)
        if not any(self._player.up) and all(foot.stands for foot in self.footing.feet):
            mending = self.footing.mending.side
            pivot = None if mending is None else 1 - mending
            self._player.drift(target, ankles, pivot, self.footing.saved_s < SETTLE_S, dt)

    def _plan(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole], dt: float) -> float:
        """What the feet do and where the pressure is to be; gives omega."""
        floor = min(float(soles[0].centre[2]), float(soles[1].centre[2]))
        frequency = natural_frequency(body.gravity, float(body.com[2]) - floor)
        xi = capture_point(body.com, body.com_velocity, frequency)
        self._wish = wish_of(self._player, motion, body)
        self._leap = leap_speed(self._window, self._player, body)
        leaving = taking_off(self._leap, self._player, body, sum(self.wrench[2::6].tolist()))
        goal = self._capture_goal(frequency, dt)
        self.felt.feel(body.com_velocity, self.wrench, self._total_mass, dt)
        away_m = math.hypot(xi[0] - body.com[0], xi[1] - body.com[1])
        sway = Sway(xi, frequency, away_m, self.felt.thrown, self.felt.acceleration, self._load())
        self.footing.update(soles, sway, self._wish, leaving, dt)
        self._bracing = bracing(self.footing, self.felt)
        rate = self._settings.number("whole_body.capture_rate") * self._bracing.rate
        goal_hull = self.footing.goal_hull(soles, GOAL_MARGIN_M, GOAL_ENDS_M)
        hull = self.footing.hull(soles, PRESSURE_MARGIN_M)
        x, y, *pressure = steer(*goal, goal_hull, xi, frequency, rate, hull)
        self.com_target[0], self.com_target[1] = x, y
        self.xi, self.pressure, self.cos = xi, np.array(pressure), np.array([*pressure, floor])
        return frequency

    def _load(self) -> tuple[float, float]:
        """Shares of the weight that was planned for the left and the right foot; nothing of none."""
        lift = {side: float(self.wrench[6 * place + 2]) for place, side in enumerate(self.standing)}
        total = max(sum(lift.values()), 1e-9)
        return lift.get(0, 0.0) / total, lift.get(1, 0.0) / total

    def _capture_goal(self, frequency: float, dt: float) -> tuple[float, float]:
        """x, y of the player's own capture point in the character's world, low-passed."""
        window = self._window
        x, y = players_capture_point(window.newest_places[3], window.com_velocity(), self._player.overlay, frequency)
        if self._goal is not None:
            share = min(1.0, dt / GOAL_TIME_S)
            x, y = self._goal[0] + share * (x - self._goal[0]), self._goal[1] + share * (y - self._goal[1])
        self._goal = x, y
        return x, y

    def _solve(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole], frequency: float, dt: float) -> JointCommand:
        mass, bias = body.equations
        velocity, rotation = body.velocity, body.joint_rotation
        feet = self.footing.feet
        pushes = (feet[0].stands and soles[0].touches, feet[1].stands and soles[1].touches)
        standing = _STANDING[pushes]
        twist, product, weight, goal = np.empty((4, 2, 6))
        sole_motions(soles[0].centre, soles[1].centre, body.joint, body.turn, velocity, twist, product)
        self._foot_tasks(soles, twist, motion, body, weight, goal)
        com_goal = np.zeros(3)
        if standing:
            lift = self._height.acceleration(motion, self._window.newest_rise[1], self._leap, self._player, self.footing, body)
            # the floor's force points from the pressure to the COM: the less it lifts, the less it pushes sideways
            push = max(1.0 + lift / body.gravity, LEAST_LOAD) * frequency**2
            com_goal[0], com_goal[1] = push * (body.com[0] - self.pressure[0]), push * (body.com[1] - self.pressure[1])
            com_goal[2] = lift
        # who leaves the floor or meets it must not turn: there is nothing to come back with in the air
        leaping = self.footing.landed_s < LANDED_S or self._leap > 0.0
        numbers = self._weights.numbers(not leaping, self.footing.flying, self._bracing, dt)
        cone = self._cone(soles, standing)
        price, joint_weight = _PRICE[: 6 * len(standing)], JOINT_WEIGHT[standing] * self._bracing.joints
        within, outcome = pose_and_answer(
            Body(mass, bias, velocity, rotation, body.orientation, body.turn, body.joint, body.com, self._total_mass, body.gravity),
            Wanted(
                motion.turn, motion.spin, motion.spin_rate, self._upright(motion, soles),
                (soles[0].centre, soles[1].centre), weight, goal, product, pushes, com_goal, COM_WEIGHT * self._bracing.com,
            ),
            numbers, self._weights.strength, joint_weight, price, cone, self._posed,
        )  # fmt: skip
        self.standing, self.limits, self.momentum = standing, (outcome.low, outcome.high), outcome.momentum
        self.torque, self.wrench = outcome.torque, outcome.wrench
        if not within:
            p = self._posed
            problem = Problem(
                p.gradient, p.lower, p.response, p.schur_inverse, p.free, mass, bias, p.jacobian[: len(price)], price, cone, standing
            )
            limits = PLANNED * outcome.low, PLANNED * outcome.high
            self.torque, acceleration, self.wrench = within_limits(problem, *limits, p.weight, p.inertia)
            hold(p.firmness, self.torque, *self.limits, velocity, acceleration, dt, outcome.damping, outcome.speed)
        self.com_target[2] = motion.place[3, 2] - self._player.floor_z
        return JointCommand(rotation, outcome.speed, _NO_STIFFNESS, outcome.damping, self.torque)

    def _upright(self, motion: Motion, soles: tuple[Sole, Sole]) -> Floats:
        """(4,) of the pelvis; takes from the motion's spin what the feet forbid."""
        yaws, feet = (soles[0].yaw, soles[1].yaw), self.footing.feet
        return held_by_feet(self._player.orientation(motion.root), motion.spin[JOINT_COUNT], yaws, (feet[0].stands, feet[1].stands))

    def _foot_tasks(self, soles: tuple[Sole, Sole], twist: Floats, motion: Motion, body: BodyState, weight: Floats, goal: Floats) -> None:
        """Fill weight and goal, (2, 6) each, of both soles, which move with `twist` (2, 6)."""
        player, wish = self._player, self._wish
        for side, foot in enumerate(self.footing.feet):
            if self.footing.flying:
                flight_task(side, soles[side], twist[side], self.xi, motion, player, wish, body, weight[side], goal[side])
            else:
                foot_task(side, soles[side], foot, twist[side], motion, player, wish, body, weight[side], goal[side])
            if foot.saving is not None:
                weight[side] *= self._bracing.swing

    def _cone(self, soles: tuple[Sole, Sole], standing: tuple[int, ...]) -> Floats:
        if not standing:
            return _NO_ROWS
        friction = 0.9 * min(self._settings.number("physics.friction"), 1.0)
        yaws = tuple(soles[side].yaw for side in standing)
        return cone_rows(yaws, friction, soles[0].half_length, soles[0].half_width)
