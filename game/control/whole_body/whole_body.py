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
from game.control.whole_body.contact_states import Phase
from game.control.whole_body.contact_wrenches import cone_rows
from game.control.whole_body.foot_tasks import CATCH_UP_S, flight, stance, swing
from game.control.whole_body.footing import PRESSURE_MARGIN_M, Footing, Sole, Wish
from game.control.whole_body.inverse_dynamics import eliminate
from game.control.whole_body.joint_tasks import joint_accelerations, turn_acceleration
from game.control.whole_body.leg_kinematics import LEG_PARTS, sole_motion
from game.control.whole_body.motion_window import Motion, MotionWindow
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.support_polygon import nearest_inside
from game.control.whole_body.task_stack import add_com, add_sole, add_spin, diagonal_tasks, wrench_rows
from game.control.whole_body.torque_limits import Problem, limits_at, within_limits
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings

Floats = NDArray[np.float64]

LEAST_LEAP_M = 0.06
"""A player who rises with a swing that would carry him this far above standing is about to jump."""

SOLE_AHEAD_M = 0.055
HIGHEST_LEAP_M = 0.4
"""Nobody is followed higher than that."""

GOAL_TIME_S = 0.04
"""Low-pass of where the capture point should be."""

_COM_WEIGHT = np.array([2000.0, 2000.0, 500.0])
_NO_ROWS = np.zeros((0, DOF_COUNT))
_NO_STIFFNESS = np.zeros(3 * JOINT_COUNT)
_PRICE = 1e-6 * np.tile([1.0, 1.0, 1.0, 21.0, 6.0, 21.0], 2)
"""What a wrench costs, so that the least one is taken."""


def _joint_weight(standing: tuple[int, ...]) -> Floats:
    """(42,) arms, spine and neck, legs that stand, legs that swing."""
    out = np.full(JOINT_COUNT, 0.6)
    out[:2] = 1.0
    out[8:11] = 0.25 if 0 in standing else 0.3
    out[11:14] = 0.25 if 1 in standing else 0.3
    return np.repeat(out, 3)


_JOINT_WEIGHT = {standing: _joint_weight(standing) for standing in ((), (0,), (1,), (0, 1))}


class WholeBody:
    """Balance strategy `whole-body`."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self.cos = np.zeros(3)
        self.com_target = np.zeros(3)
        self.left_share = 0.5
        self._ready = False
        self._hanging = AnkleStrategy(settings)
        self._cone_of, self._cone_rows = (0.0, 0), _NO_ROWS

    def reset(self, dynamics: BodyState) -> None:
        self._ready = True
        self.footing = Footing()
        self._strength = np.array(joint_strength(dynamics.plan))
        self._hanging.reset(dynamics)
        self._window = MotionWindow()
        self._player: PlayerStance | None = None
        self._last: KinematicTarget | None = None
        self._since_s = 0.0
        self._goal: Floats | None = None
        self.com_target = dynamics.com.copy()
        self.fallen = False
        self.landing = False
        self.wrench = np.zeros(0)

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        if not self._ready:
            self.reset(dynamics)
        self._listen(target, dynamics, dt)
        delay = self._settings.number("whole_body.delay_s")
        motion = self._window.moment(self._window.newest_s + self._since_s - delay)
        soles = (_sole(dynamics, 0), _sole(dynamics, 1))
        if dynamics.held:
            return self._hanging.command(target, dynamics, dt)
        if dynamics.com[2] < 0.5 or self.fallen:
            self.fallen = True
            return self._limp(target, dynamics)
        pressure, frequency = self._plan(target, motion, dynamics, soles, dt)
        return self._solve(motion, dynamics, soles, pressure, frequency, dt)

    def _listen(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> None:
        self._since_s += dt
        ankles = dynamics.joint[list(FEET)]
        if self._player is None:
            self._player = PlayerStance(float(dynamics.plan.joint[FEET[0], 2]))
            self._player.settle(target, ankles, one.yaw(dynamics.orientation[0]))
        if target is not self._last:
            self._last, self._since_s = target, 0.0
            self._window.add(target, 2.0 * self._settings.number("whole_body.delay_s"))
            self._player.watch(target)
        if not any(self._player.up) and all(foot.stands for foot in self.footing.feet):
            self._player.drift(target, ankles, dt)

    def _plan(
        self, target: KinematicTarget, motion: Motion, body: BodyState, soles: tuple[Sole, Sole], dt: float
    ) -> tuple[Floats, float]:
        """The pressure (2,) that balance wants, and omega."""
        player = self._player
        assert player is not None
        floor = min(sole.centre[2] for sole in soles)
        frequency = natural_frequency(body.gravity, float(body.com[2]) - floor)
        xi = capture_point(body.com, body.com_velocity, frequency)
        wish = self._wish(motion, body, soles)
        calm = math.hypot(*(xi - body.com[:2])) < 0.05
        self.footing.update(soles, xi, frequency, wish, calm, self._taking_off(body), dt)
        goal = self._capture_goal(frequency, dt)
        wanted = nearest_inside(self.footing.goal_hull(soles, 0.02), goal)
        self.com_target[:2] = wanted
        hull = self.footing.hull(soles, PRESSURE_MARGIN_M)
        self.xi, self.xi_wanted = xi, wanted
        self.pressure = pressure_target(xi, wanted, frequency, self._settings.number("whole_body.capture_rate"), hull, 0.03)
        return self.pressure, frequency

    def _taking_off(self, body: BodyState) -> bool:
        """The COM rises on straight legs, or fast enough on unloaded feet: the floor has nothing more to give."""
        speed = body.com_velocity[2]
        if speed < 0.35:
            return False
        if not any(body.foot_contact) or (speed > 0.6 and max(_reach(body, side) for side in range(2)) > 0.98):
            return True
        player = self._player
        assert player is not None
        load = float(self.wrench[2::6].sum()) if len(self.wrench) else 0.0
        return player.flight and load < 0.08 * body.subtree_mass[0] * body.gravity and speed > self._leap_speed(body) - 0.1

    def _leap_speed(self, body: BodyState) -> float:
        """m/s upwards that would carry the COM as high as the player's is going, by the newest frames; 0 where nobody leaps."""
        player = self._player
        assert player is not None
        newest = self._window.moment(self._window.newest_s)
        rise = max(float(newest.velocity[3, 2]), 0.0)
        apex = player.place(newest.place[3])[2] + rise * rise / (2.0 * body.gravity)
        if not player.flight and apex < body.plan.idle_com_height + LEAST_LEAP_M:
            return 0.0
        return math.sqrt(2.0 * body.gravity * max(min(apex, HIGHEST_LEAP_M + body.plan.idle_com_height) - body.com[2], 0.0))

    def _wish(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole]) -> Wish:
        player = self._player
        assert player is not None
        place, yaw = np.empty((2, 2)), [0.0, 0.0]
        for side in range(2):
            ankle = player.ankle(motion, side)
            yaw[side] = one.yaw(player.orientation(motion.turn[JOINT_COUNT + 1 + side]))
            place[side] = ankle[:2] + _forward(yaw[side], soles[side])
        up = (player.up[0], player.up[1])
        return Wish(up, player.flight, place, (yaw[0], yaw[1]))

    def _capture_goal(self, frequency: float, dt: float) -> Floats:
        """(2,) the player's own capture point in the character's world, low-passed."""
        player = self._player
        assert player is not None
        seen = player.place(self._window.newest_places[3])[:2] + player.direction(self._window.com_velocity())[:2] / frequency
        share = min(1.0, dt / GOAL_TIME_S)
        self._goal = seen if self._goal is None else self._goal + share * (seen - self._goal)
        return self._goal

    def _solve(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole], pressure: Floats, frequency: float, dt: float) -> JointCommand:
        settings = self._settings
        mass, bias = body.equations
        velocity = body.velocity
        inertia = mass.diagonal()[6:]
        feet = self.footing.feet
        standing = tuple(side for side in range(2) if feet[side].stands and soles[side].touches)
        strength = settings.number("whole_body.strength") * self._strength
        low, high = limits_at(strength[0], strength[1], velocity[6:])
        weight = _JOINT_WEIGHT[standing]
        hessian, gradient = self._joint_tasks(motion, body, velocity, weight, 0.7 * np.maximum(-strength[0], strength[1]) / inertia)
        rows = []
        for side, sole in enumerate(soles):
            twist, product = sole_motion(side, sole.centre, body.joint, body.turn, velocity)
            task_weight, goal = self._foot_task(side, sole, twist, motion, body)
            jacobian = add_sole(hessian, gradient, side, sole.centre, body.joint, body.turn, task_weight, goal - product)
            if side in standing:
                rows.append(wrench_rows(jacobian, body.turn[FEET[side]]))
        if standing:
            com_goal = np.empty(3)
            com_goal[:2] = frequency**2 * (body.com[:2] - pressure)
            com_goal[2] = self._height_acceleration(motion, body)
            add_com(hessian, gradient, mass, bias, body.gravity, body.subtree_mass[0], _COM_WEIGHT, com_goal)
        spin_weight = settings.number("whole_body.spin_weight")
        self.momentum = add_spin(hessian, gradient, mass, bias, velocity, body.turn[0], body.com - body.joint[0], spin_weight, 2.0)
        lower, response, schur_inverse = eliminate(hessian, mass)
        stacked = np.concatenate(rows) if rows else _NO_ROWS
        problem = Problem(gradient, lower, response, schur_inverse, mass, bias, stacked, _PRICE[: len(stacked)], self._cone(soles[0], standing), standing)
        self.torque, acceleration, self.wrench = within_limits(problem, low, high, weight, inertia)
        damping = settings.number("whole_body.hold") * inertia / dt
        # the velocity that the damping meets in the middle of the steps it acts in
        reference = velocity[6:] + 0.625 * dt * acceleration[6:]
        return JointCommand(body.joint_rotation, reference, _NO_STIFFNESS, damping, self.torque)

    def _joint_tasks(self, motion: Motion, body: BodyState, velocity: Floats, weight: Floats, largest: Floats) -> tuple[Floats, Floats]:
        settings, player = self._settings, self._player
        assert player is not None
        goal = joint_accelerations(
            body.joint_rotation, velocity[6:], motion.joint, motion.spin[:JOINT_COUNT], motion.spin_rate[:JOINT_COUNT],
            settings.number("whole_body.pose_stiffness"), settings.number("whole_body.pose_damping"), largest,
        )  # fmt: skip
        root = turn_acceleration(body.orientation[0], velocity[3:6], player.orientation(motion.root), motion.spin[JOINT_COUNT], 200.0, 26.0, 60.0)
        return diagonal_tasks(weight, goal, settings.number("whole_body.pelvis_weight"), root)

    def _cone(self, sole: Sole, standing: tuple[int, ...]) -> Floats:
        friction = 0.9 * min(self._settings.number("physics.friction"), 1.0)
        if self._cone_of != (friction, len(standing)):
            self._cone_of = (friction, len(standing))
            self._cone_rows = cone_rows(len(standing), friction, sole.half_length - 0.015, sole.half_width - 0.01, 0.08)
        return self._cone_rows

    def _foot_task(self, side: int, sole: Sole, twist: Floats, motion: Motion, body: BodyState) -> tuple[Floats, Floats]:
        """Weights (6,) and acceleration (6,) of the sole."""
        player, foot = self._player, self.footing.feet[side]
        assert player is not None
        orientation, turn = body.orientation[FEET[side]], body.turn[FEET[side]]
        if foot.stands:
            return stance(twist, turn, sole.centre[2], sole.touches, foot.time_s)
        if foot.phase is Phase.STEP:
            place, velocity, acceleration, yaw = foot.step_motion(0.06)
            return swing(sole.centre, orientation, turn, twist, place, velocity, acceleration, one.about_z(yaw), np.zeros(3))
        facing = player.orientation(motion.turn[JOINT_COUNT + 1 + side])
        yaw = one.yaw(facing)
        if self.footing.flying:
            theirs = 0.5 * (motion.place[1] + motion.place[2])
            under = self.xi + player.direction(motion.place[1 + side] - theirs)[:2] + _forward(yaw, sole)
            return flight(sole.centre, orientation, turn, twist, under, body.com_velocity, one.about_z(yaw))
        place = player.ankle(motion, side)
        place[:2] += _forward(yaw, sole)
        place[2] -= float(body.plan.joint[FEET[0], 2])
        if player.up[side]:
            place[2] = max(place[2], 0.02)
        else:
            place[2] = min(place[2], 0.0) - 0.01
            facing = one.about_z(yaw)
        velocity, acceleration = player.direction(motion.velocity[1 + side]), player.direction(motion.acceleration[1 + side])
        if foot.fresh:
            foot.fresh = False
            foot.behind = sole.centre - place
        left = max(1.0 - foot.time_s / CATCH_UP_S, 0.0)
        place += left * left * foot.behind
        velocity -= 2.0 * left / CATCH_UP_S * foot.behind
        return swing(sole.centre, orientation, turn, twist, place, velocity, acceleration, facing, motion.spin[JOINT_COUNT + 1 + side])

    def _height_acceleration(self, motion: Motion, body: BodyState) -> float:
        player = self._player
        assert player is not None
        height = player.place(motion.place[3])[2]
        self.com_target[2] = height
        if self.footing.landed_s < 0.6:
            self.landing = (self.landing or self.footing.landed_s < 0.02) and height > body.com[2]
            if self.landing:
                # not after the player up into the air again: soften the landing until he comes down too
                return min(max(-12.0 * body.com_velocity[2], -5.0), 9.0)
        wanted = 100.0 * (height - body.com[2]) + 20.0 * (motion.velocity[3, 2] - body.com_velocity[2]) + motion.acceleration[3, 2]
        if motion.velocity[3, 2] > 0.3:
            wanted = max(wanted, 30.0 * (self._leap_speed(body) - body.com_velocity[2]))
        return min(max(wanted, -8.0), 25.0)

    def _limp(self, target: KinematicTarget, body: BodyState) -> JointCommand:
        """On the floor: the target's pose with little strength."""
        kp, kd = gains(body, 0.125 * self._settings.number("pd.kp_hat"), "dynamic")
        return JointCommand(target.joint_rotation, np.zeros(3 * JOINT_COUNT), kp, kd, np.zeros(3 * JOINT_COUNT))


def _reach(body: BodyState, side: int) -> float:
    """Distance from hip to ankle over the length of the straight leg."""
    thigh, shank, foot = LEG_PARTS[side]
    length = np.linalg.norm(body.plan.joint_offset[shank]) + np.linalg.norm(body.plan.joint_offset[foot])
    return float(np.linalg.norm(body.joint[thigh] - body.joint[foot]) / length)


def _forward(yaw: float, sole: Sole) -> Floats:
    """(2,) from the ankle to the centre of the sole of a flat foot."""
    return np.array([SOLE_AHEAD_M * math.cos(yaw), SOLE_AHEAD_M * math.sin(yaw)])


def _sole(body: BodyState, side: int) -> Sole:
    part = FEET[side]
    length, width, height = body.plan.foot_half
    turn = body.turn[part]
    return Sole(body.box_centre[part] - height * turn[:, 2], math.atan2(turn[1, 0], turn[0, 0]), body.joint[part], body.foot_contact[side], length, width)
