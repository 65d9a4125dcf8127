"""The strategy itself: the player's motion and the plan for the feet as tasks, one optimisation, torques for every joint."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import DOF_COUNT, FEET, JOINT_COUNT
from game.characters.strength import joint_strength
from game.control.ankle_strategy import AnkleStrategy
from game.control.gains import gains
from game.control.joint_command import BodyState, JointCommand
from game.control.whole_body.capture_point import capture_point, natural_frequency, pressure_target
from game.control.whole_body.contact_wrenches import cone_rows
from game.control.whole_body.foot_goals import flight_task, foot_task, wish_of
from game.control.whole_body.footing import PRESSURE_MARGIN_M, Footing
from game.control.whole_body.hold_damping import held_speed, hold_damping
from game.control.whole_body.inverse_dynamics import eliminate
from game.control.whole_body.joint_limits import soft_limits
from game.control.whole_body.joint_tasks import joint_accelerations, turn_acceleration
from game.control.whole_body.leap import ComHeight, taking_off
from game.control.whole_body.leg_kinematics import sole_motion
from game.control.whole_body.motion_window import Motion, MotionWindow
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.sole import Sole, sole_of
from game.control.whole_body.support_polygon import nearest_inside
from game.control.whole_body.task_stack import add_com, add_sole, add_spin, diagonal_tasks, wrench_rows
from game.control.whole_body.torque_limits import Problem, limits_at, within_limits
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings

Floats = NDArray[np.float64]

GOAL_TIME_S = 0.04
"""Low-pass of where the capture point should be."""

_COM_WEIGHT = np.array([2000.0, 2000.0, 500.0])
PLANNED = 0.9
"""Share of a joint's strength that is planned with; the rest holds it to its plan between two ticks."""

HELD_BY_RAD_S = 8.0
"""A limb that loses what it pushed against between two ticks is held at least as if it took its whole strength this far off its speed."""

_NO_ROWS = np.zeros((0, DOF_COUNT))
_NOTHING = np.zeros(3 * JOINT_COUNT)
_PRICE = 1e-6 * np.tile([1.0, 1.0, 1.0, 21.0, 6.0, 21.0], 2)
"""What a wrench costs, so that the least one is taken."""


def _joint_weight(standing: tuple[int, ...]) -> Floats:
    """(42,) arms, spine and neck, legs that stand, legs that swing."""
    out = np.full(JOINT_COUNT, 0.6)
    out[:2] = 1.0
    out[8:11] = 0.25 if 0 in standing else 0.3
    out[11:14] = 0.25 if 1 in standing else 0.3
    return np.repeat(out, 3)


_JOINT_WEIGHT: dict[tuple[int, ...], Floats] = {standing: _joint_weight(standing) for standing in ((), (0,), (1,), (0, 1))}


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
        self._cone_of, self._cone_rows = (0.0, 0), _NO_ROWS

    def reset(self, dynamics: BodyState) -> None:
        self._ready = True
        self.footing = Footing()
        self._strength = np.array(joint_strength(dynamics.plan))
        self._hanging.reset(dynamics)
        self._window = MotionWindow()
        self._player = PlayerStance(float(dynamics.plan.joint[FEET[0], 2]))
        self._last: KinematicTarget | None = None
        self._since_s = 0.0
        self._goal: Floats | None = None
        self.com_target = dynamics.com.copy()
        self.fallen = False
        self._height = ComHeight()
        self.wrench = np.zeros(0)
        self.standing: tuple[int, ...] = ()
        self.limits: tuple[Floats, Floats] | None = None

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        if not self._ready:
            self.reset(dynamics)
        self._listen(target, dynamics, dt)
        if dynamics.held:
            return self._hanging.command(target, dynamics, dt)
        if dynamics.com[2] < 0.5 or self.fallen:
            self.fallen = True
            return self._limp(target, dynamics)
        delay = self._settings.number("whole_body.delay_s")
        motion = self._window.moment(self._window.newest_s + self._since_s - delay)
        soles = (sole_of(dynamics, 0), sole_of(dynamics, 1))
        frequency = self._plan(motion, dynamics, soles, dt)
        return self._solve(motion, dynamics, soles, frequency, dt)

    def _listen(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> None:
        self._since_s += dt
        ankles = dynamics.joint[list(FEET)]
        if self._last is None:
            self._player.settle(target, ankles, one.yaw(dynamics.orientation[0]))
        if target is not self._last:
            self._last, self._since_s = target, 0.0
            self._window.add(target, 2.0 * self._settings.number("whole_body.delay_s"))
            self._player.watch(target)
        if not any(self._player.up) and all(foot.stands for foot in self.footing.feet):
            self._player.drift(target, ankles, dt)

    def _plan(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole], dt: float) -> float:
        """What the feet do and where the pressure is to be; gives omega."""
        floor = min(sole.centre[2] for sole in soles)
        frequency = natural_frequency(body.gravity, float(body.com[2]) - floor)
        xi = capture_point(body.com, body.com_velocity, frequency)
        self._wish = wish_of(self._player, motion, body)
        calm = math.hypot(*(xi - body.com[:2])) < 0.05
        leaving = taking_off(self._window, self._player, body, float(self.wrench[2::6].sum()))
        self.footing.update(soles, xi, frequency, self._wish, calm, leaving, dt)
        goal = self._capture_goal(frequency, dt)
        wanted = nearest_inside(self.footing.goal_hull(soles, 0.02), goal)
        self.com_target[:2] = wanted
        hull = self.footing.hull(soles, PRESSURE_MARGIN_M)
        self.xi = xi
        self.pressure = pressure_target(xi, wanted, frequency, self._settings.number("whole_body.capture_rate"), hull, 0.03)
        self.cos = np.array([self.pressure[0], self.pressure[1], floor])
        return frequency

    def _capture_goal(self, frequency: float, dt: float) -> Floats:
        """(2,) the player's own capture point in the character's world, low-passed."""
        player = self._player
        seen = player.place(self._window.newest_places[3])[:2] + player.direction(self._window.com_velocity())[:2] / frequency
        share = min(1.0, dt / GOAL_TIME_S)
        self._goal = seen if self._goal is None else self._goal + share * (seen - self._goal)
        return self._goal

    def _solve(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole], frequency: float, dt: float) -> JointCommand:
        settings = self._settings
        mass, bias = body.equations
        velocity = body.velocity
        inertia = mass.diagonal()[6:]
        feet = self.footing.feet
        standing = tuple(side for side in range(2) if feet[side].stands and soles[side].touches)
        strength = settings.number("whole_body.strength") * self._strength
        strongest = np.maximum(-strength[0], strength[1])
        low, high = limits_at(strength[0], strength[1], velocity[6:])
        self.standing, self.limits = standing, (low, high)
        weight = _JOINT_WEIGHT[standing].copy()
        hessian, gradient = self._joint_tasks(motion, body, velocity, weight, 0.7 * strongest / inertia)
        rows = []
        for side, sole in enumerate(soles):
            twist, product = sole_motion(side, sole.centre, body.joint, body.turn, velocity)
            if self.footing.flying:
                task_weight, goal = flight_task(side, sole, twist, self.xi, motion, self._player, self._wish, body)
            else:
                task_weight, goal = foot_task(side, sole, feet[side], twist, motion, self._player, self._wish, body)
            jacobian = add_sole(hessian, gradient, side, sole.centre, body.joint, body.turn, task_weight, goal - product)
            if side in standing:
                rows.append(wrench_rows(jacobian, body.turn[FEET[side]]))
        if standing:
            com_goal = np.empty(3)
            com_goal[:2] = frequency**2 * (body.com[:2] - self.pressure)
            com_goal[2] = self._height.acceleration(motion, self._window, self._player, self.footing, body)
            add_com(hessian, gradient, mass, bias, body.gravity, body.subtree_mass[0], _COM_WEIGHT, com_goal)
        spin_weight = settings.number("whole_body.spin_weight")
        self.momentum = add_spin(hessian, gradient, mass, bias, velocity, body.turn[0], body.com - body.joint[0], spin_weight, 2.0)
        lower, response, schur_inverse = eliminate(hessian, mass)
        stacked = np.concatenate(rows) if rows else _NO_ROWS
        cone, price = self._cone(soles[0], standing), _PRICE[: len(stacked)]
        problem = Problem(gradient, lower, response, schur_inverse, mass, bias, stacked, price, cone, standing)
        self.torque, acceleration, self.wrench = within_limits(problem, PLANNED * low, PLANNED * high, weight, inertia)
        self.com_target[2] = self._player.place(motion.place[3])[2]
        firmness = np.maximum(inertia / dt, strongest / HELD_BY_RAD_S)
        damping = hold_damping(settings.number("whole_body.hold") * firmness, self.torque, low, high)
        # the velocity that the damping meets in the middle of the steps it acts in
        reference = held_speed(velocity[6:], 0.56 * dt * acceleration[6:])
        return JointCommand(body.joint_rotation, reference, _NOTHING, damping, self.torque)

    def _joint_tasks(self, motion: Motion, body: BodyState, velocity: Floats, weight: Floats, largest: Floats) -> tuple[Floats, Floats]:
        settings = self._settings
        goal = joint_accelerations(
            body.joint_rotation, velocity[6:], motion.joint, motion.spin[:JOINT_COUNT], motion.spin_rate[:JOINT_COUNT],
            settings.number("whole_body.pose_stiffness"), settings.number("whole_body.pose_damping"), largest,
        )  # fmt: skip
        soft_limits(body.joint_rotation, velocity[6:], weight, goal)
        upright, spin = self._player.orientation(motion.root), motion.spin[JOINT_COUNT]
        root = turn_acceleration(body.orientation[0], velocity[3:6], upright, spin, 200.0, 26.0, 60.0)
        return diagonal_tasks(weight, goal, settings.number("whole_body.pelvis_weight"), root)

    def _cone(self, sole: Sole, standing: tuple[int, ...]) -> Floats:
        friction = 0.9 * min(self._settings.number("physics.friction"), 1.0)
        if self._cone_of != (friction, len(standing)):
            self._cone_of = (friction, len(standing))
            self._cone_rows = cone_rows(len(standing), friction, sole.half_length - 0.015, sole.half_width - 0.01, 0.08)
        return self._cone_rows

    def _limp(self, target: KinematicTarget, body: BodyState) -> JointCommand:
        """On the floor: the target's pose with little strength."""
        kp, kd = gains(body, 0.125 * self._settings.number("pd.kp_hat"), "dynamic")
        return JointCommand(target.joint_rotation, _NOTHING, kp, kd, _NOTHING)
