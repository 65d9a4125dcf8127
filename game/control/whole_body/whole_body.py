"""The strategy itself: the player's motion and the plan for the feet as tasks, one optimisation, torques for every joint."""

import math

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.characters.skeleton import DOF_COUNT, FEET, JOINT_COUNT, JOINTS
from game.control.gains import gains
from game.control.joint_command import BodyState, JointCommand
from game.control.whole_body.capture_point import capture_point, natural_frequency, pressure_target
from game.control.whole_body.contact_states import Phase
from game.control.whole_body.contact_wrenches import cone_rows, solve_wrenches
from game.control.whole_body.footing import PRESSURE_MARGIN_M, Footing, Sole, Wish
from game.control.whole_body.inverse_dynamics import add_task, eliminate, motion_and_torque, torque_of_wrench, wrench_cost
from game.control.whole_body.joint_tasks import joint_accelerations, turn_acceleration
from game.control.whole_body.leg_kinematics import LEG_PARTS, sole_jacobian, sole_motion
from game.control.whole_body.motion_window import Motion, MotionWindow
from game.control.whole_body.player_stance import PlayerStance
from game.control.whole_body.support_polygon import nearest_inside
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings

Floats = NDArray[np.float64]

_LEG_ROWS = [np.array([3 * j + a for j in legs for a in range(3)]) for legs in ((8, 9, 10), (11, 12, 13))]

_STRENGTH = {"spine": 300.0, "neck": 60.0, "shoulder": 120.0, "elbow": 80.0, "wrist": 20.0, "hip": 300.0, "knee": 300.0, "ankle": 150.0}
TORQUE_LIMIT: Floats = np.repeat([_STRENGTH[name.split("_")[0]] for name in JOINTS], 3)


class WholeBody:
    """Balance strategy `whole-body`."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self.cos = np.zeros(3)
        self.com_target = np.zeros(3)
        self.left_share = 0.5
        self._started = False

    def reset(self, dynamics: BodyState) -> None:
        self.footing = Footing()
        self._window = MotionWindow()
        self._player: PlayerStance | None = None
        self._last: KinematicTarget | None = None
        self._since_s = 0.0
        self.com_target = dynamics.com.copy()
        self.fallen = False
        self.landing = False
        self.wrench = np.zeros(0)

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        self._listen(target, dynamics, dt)
        delay = self._settings.number("whole_body.delay_s")
        motion = self._window.moment(self._window.newest_s + self._since_s - delay)
        soles = (_sole(dynamics, 0), _sole(dynamics, 1))
        if dynamics.com[2] < 0.5 or self.fallen:
            self.fallen = True
            return self._soft(target, dynamics)
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
        goal = self._capture_goal(target, soles, frequency)
        wanted = nearest_inside(self.footing.goal_hull(soles, 0.02), goal)
        self.com_target[:2] = wanted
        hull = self.footing.hull(soles, PRESSURE_MARGIN_M)
        self.xi, self.xi_wanted = xi, wanted
        return pressure_target(xi, wanted, frequency, self._settings.number("whole_body.capture_rate"), hull, 0.03), frequency

    def _taking_off(self, body: BodyState) -> bool:
        """The COM rises on straight legs or unloaded feet: the floor has nothing more to give."""
        if body.com_velocity[2] < 0.35:
            return False
        load = float(self.wrench[2::6].sum()) if len(self.wrench) else 0.0
        return load < 0.08 * body.subtree_mass[0] * body.gravity or max(_reach(body, side) for side in range(2)) > 0.995

    def _wish(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole]) -> Wish:
        player = self._player
        assert player is not None
        place, yaw = np.empty((2, 2)), [0.0, 0.0]
        for side in range(2):
            ankle = player.ankle(motion, side)
            yaw[side] = one.yaw(player.orientation(motion.turn[JOINT_COUNT + 1 + side]))
            place[side] = ankle[:2] + _forward(yaw[side], soles[side])
        up = (player.up[0], player.up[1])
        return Wish(up, all(up), place, (yaw[0], yaw[1]))

    def _capture_goal(self, target: KinematicTarget, soles: tuple[Sole, Sole], frequency: float) -> Floats:
        """(2,) the player's own capture point, carried over relative to the feet that both stand on."""
        player = self._player
        assert player is not None
        places = self._window.newest_places
        sides = [self.footing.intended] if self.footing.intended is not None else [0, 1]
        theirs = np.mean([player.place(places[1 + side]) for side in sides], axis=0)
        ours = np.mean([soles[side].ankle for side in sides], axis=0)
        com = player.place(places[3]) - theirs + ours
        return com[:2] + player.direction(self._window.com_velocity())[:2] / frequency

    def _solve(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole], pressure: Floats, frequency: float, dt: float) -> JointCommand:
        settings, player = self._settings, self._player
        assert player is not None
        mass, bias = body.equations
        velocity = body.velocity
        total = body.subtree_mass[0]
        hessian, gradient = 1e-5 * np.eye(DOF_COUNT), np.zeros(DOF_COUNT)
        feet = self.footing.feet

        # joints and pelvis
        limit = TORQUE_LIMIT * settings.number("whole_body.strength") * np.clip((28.0 - np.abs(velocity[6:])) / 10.0, 0.05, 1.0)
        own = mass.diagonal()[6:]
        wanted = joint_accelerations(
            body.joint_rotation, velocity[6:], motion.joint, motion.spin[:JOINT_COUNT], motion.spin_rate[:JOINT_COUNT],
            settings.number("whole_body.pose_stiffness"), settings.number("whole_body.pose_damping"), 0.7 * limit / own,
        )  # fmt: skip
        weight = self._joint_weights(feet)
        rows = np.arange(6, DOF_COUNT)
        hessian[rows, rows] += weight
        root = turn_acceleration(body.orientation[0], velocity[3:6], player.orientation(motion.root), motion.spin[JOINT_COUNT], 200.0, 26.0, 60.0)
        pelvis = settings.number("whole_body.pelvis_weight")
        rows = np.arange(3, 6)
        hessian[rows, rows] += pelvis
        gradient[3:6] += pelvis * root

        # feet
        jacobians, prices = [], []
        for side in range(2):
            jacobian = sole_jacobian(side, soles[side].centre, body.joint, body.turn)
            twist, product = sole_motion(side, soles[side].centre, body.joint, body.turn, velocity)
            if feet[side].stands:
                task_weight, goal = self._stance_task(side, soles[side], twist, body)
                turned = jacobian.copy()
                frame = body.turn[FEET[side]]
                turned[3:] = frame.T @ jacobian[3:]
                jacobians.append(turned)
                prices.append([1.0, 1.0, 1.0, 21.0, 6.0, 21.0])
            else:
                task_weight, goal = self._swing_task(side, soles[side], twist, motion, body)
            add_task(hessian, gradient, jacobian, task_weight, goal - product)

        # centre of mass and angular momentum
        linear = mass[:3] / total
        com_rest = bias[:3] / total - np.array([0.0, 0.0, body.gravity])
        com_goal = np.empty(3)
        com_goal[:2] = frequency**2 * (body.com[:2] - pressure)
        com_goal[2] = self._height_acceleration(motion, body, soles)
        if feet[0].stands or feet[1].stands:
            add_task(hessian, gradient, linear, np.array([2000.0, 2000.0, 500.0]), com_goal - com_rest)
        arm = _skew(body.com - body.joint[0])
        spin_rows = body.turn[0] @ mass[3:6] - arm @ mass[:3]
        spin_rest = body.turn[0] @ bias[3:6] - arm @ bias[:3]
        momentum = spin_rows @ velocity
        add_task(hessian, gradient, spin_rows, np.full(3, settings.number("whole_body.spin_weight")), -2.0 * momentum - spin_rest)

        lower, response, schur = eliminate(hessian, mass)
        stacked = np.concatenate(jacobians) if jacobians else np.zeros((0, DOF_COUNT))
        price = 1e-6 * np.concatenate(prices) if prices else np.zeros(0)
        torque, acceleration = self._within_limits(gradient, weight, wanted, lower, response, schur, mass, bias, stacked, price, limit, own, soles)
        self.torque = torque
        damping = settings.number("whole_body.hold") * own / dt
        reference = velocity[6:] + 0.625 * dt * acceleration[6:]
        return JointCommand(body.joint_rotation, reference, np.zeros(3 * JOINT_COUNT), damping, torque)

    def _within_limits(self, gradient, weight, wanted, lower, response, schur, mass, bias, stacked, price, limit, own, soles):
        """Torques that keep their limits: free limbs ask for less, standing legs get rows of their own."""
        standing = [side for side in range(2) if self.footing.feet[side].stands]
        held = np.concatenate([_LEG_ROWS[side] for side in standing]) if standing else np.zeros(0, np.int64)
        free_rows = np.setdiff1d(np.arange(3 * JOINT_COUNT), held)
        half = soles[0]
        friction = 0.9 * min(self._settings.number("physics.friction"), 1.0)
        cone = cone_rows(len(standing), friction, half.half_length - 0.022, half.half_width - 0.017, 0.08)
        empty = np.zeros((0, 6 * len(standing)))
        torque = acceleration = np.zeros(0)
        for _ in range(3):
            total = gradient.copy()
            total[6:] += weight * wanted
            quadratic, linear, free, residual = wrench_cost(total, lower, mass, bias, schur, stacked, price)
            wrench = np.zeros(0)
            if standing:
                solved = solve_wrenches(quadratic, linear, cone, empty, np.zeros(0), np.zeros(0))
                wrench = solved if solved is not None else np.zeros(len(stacked))
            acceleration, torque = motion_and_torque(wrench, free, residual, response, schur, mass, bias, stacked)
            over = np.abs(torque) - limit
            if standing and (over[held] > 0.0).any():
                broken = held[over[held] > 0.0]
                rows = torque_of_wrench(broken, response, schur, mass, stacked)
                rest = torque[broken] - rows @ wrench
                solved = solve_wrenches(quadratic, linear, cone, rows, -limit[broken] - rest, limit[broken] - rest)
                if solved is not None:
                    wrench = solved
                    acceleration, torque = motion_and_torque(wrench, free, residual, response, schur, mass, bias, stacked)
                    over = np.abs(torque) - limit
            if not (over[free_rows] > 0.0).any():
                break
            wanted = wanted.copy()
            excess = np.maximum(over[free_rows], 0.0) * np.sign(torque[free_rows])
            wanted[free_rows] -= 1.1 * excess / own[free_rows]
        self.wrench = wrench
        return np.clip(torque, -limit, limit), acceleration

    def _joint_weights(self, feet) -> Floats:
        out = np.empty(JOINT_COUNT)
        out[0:2] = 1.0
        out[2:8] = 0.6
        for side, rows in enumerate(((8, 9, 10), (11, 12, 13))):
            out[list(rows)] = 0.25 if feet[side].stands else 0.3
        return np.repeat(out, 3)

    def _stance_task(self, side: int, sole: Sole, twist: Floats, body: BodyState) -> tuple[Floats, Floats]:
        """Weights (6,) and acceleration (6,) of a foot that stands: it rests, flat on the floor."""
        up = body.turn[FEET[side]][:, 2]
        flat = one.cross(np.ascontiguousarray(up), np.array([0.0, 0.0, 1.0]))
        goal = -30.0 * twist
        goal[3:] += 150.0 * flat
        ramp = min(1.0, 0.1 + self.footing.feet[side].time_s / 0.06)
        if not sole.touches:
            goal[2] -= 100.0 * max(sole.centre[2], 0.0)
            ramp = 0.02
        return np.full(6, 20000.0 * ramp), goal

    def _swing_task(self, side: int, sole: Sole, twist: Floats, motion: Motion, body: BodyState) -> tuple[Floats, Floats]:
        player, foot = self._player, self.footing.feet[side]
        assert player is not None
        orientation = body.orientation[FEET[side]]
        goal = np.zeros(6)
        if self.footing.flying:
            facing = one.about_z(one.yaw(player.orientation(motion.turn[JOINT_COUNT + 1 + side])))
            frame = body.turn[FEET[side]]
            goal[3:] = frame @ turn_acceleration(orientation, frame.T @ twist[3:], facing, np.zeros(3), 250.0, 30.0, 200.0)
            theirs = 0.5 * (motion.place[1] + motion.place[2])
            under = self.xi + player.direction(motion.place[1 + side] - theirs)[:2] + _forward(one.yaw(facing), sole)
            goal[:2] = 150.0 * (under - sole.centre[:2]) + 25.0 * (body.com_velocity[:2] - twist[:2])
            size = math.hypot(goal[0], goal[1])
            goal[:2] *= min(1.0, 40.0 / max(size, 1e-9))
            return np.array([10.0, 10.0, 0.0, 3.0, 3.0, 3.0]), goal
        if foot.phase is Phase.STEP:
            place, velocity, acceleration, yaw = foot.step_motion(0.06)
            facing, spin = one.about_z(yaw), np.zeros(3)
        else:
            facing = player.orientation(motion.turn[JOINT_COUNT + 1 + side])
            yaw = one.yaw(facing)
            place = player.ankle(motion, side)
            place[:2] += _forward(yaw, sole)
            place[2] -= dynamics_rest(body)
            velocity = player.direction(motion.velocity[1 + side])
            acceleration = player.direction(motion.acceleration[1 + side])
            if not player.up[side]:
                place[2] = min(place[2], 0.0) - 0.01
                facing = one.about_z(yaw)
            else:
                place[2] = max(place[2], 0.02)
            spin = motion.spin[JOINT_COUNT + 1 + side]
        goal[:3] = 600.0 * (place - sole.centre) + 45.0 * (velocity - twist[:3]) + acceleration
        frame = body.turn[FEET[side]]
        goal[3:] = frame @ turn_acceleration(orientation, frame.T @ twist[3:], facing, spin, 250.0, 30.0, 200.0)
        size = math.sqrt(goal[:3] @ goal[:3])
        goal[:3] *= min(1.0, 80.0 / max(size, 1e-9))
        return np.full(6, 150.0), goal

    def _height_acceleration(self, motion: Motion, body: BodyState, soles: tuple[Sole, Sole]) -> float:
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
        return min(max(wanted, -5.0), 14.0)

    def _soft(self, target: KinematicTarget, body: BodyState) -> JointCommand:
        kp, kd = gains(body, 100.0, "dynamic")
        return JointCommand(target.joint_rotation, np.zeros(3 * JOINT_COUNT), kp, kd, np.zeros(3 * JOINT_COUNT))


def dynamics_rest(body: BodyState) -> float:
    """m, ankle above the sole."""
    return float(body.plan.joint[FEET[0], 2])


def _reach(body: BodyState, side: int) -> float:
    """Distance from hip to ankle over the length of the straight leg."""
    thigh, shank, foot = LEG_PARTS[side]
    length = np.linalg.norm(body.plan.joint_offset[shank]) + np.linalg.norm(body.plan.joint_offset[foot])
    return float(np.linalg.norm(body.joint[thigh] - body.joint[foot]) / length)


def _forward(yaw: float, sole: Sole) -> Floats:
    """(2,) from the ankle to the centre of the sole of a flat foot."""
    c, s = math.cos(yaw), math.sin(yaw)
    return 0.055 * np.array([c, s])


def _sole(body: BodyState, side: int) -> Sole:
    part = FEET[side]
    half = body.plan.size[part] / 2.0
    turn = body.turn[part]
    centre = body.box_centre[part] - half[2] * turn[:, 2]
    return Sole(centre, math.atan2(turn[1, 0], turn[0, 0]), body.joint[part], body.foot_contact[side], half[0], half[1])


def _skew(v: Floats) -> Floats:
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])
