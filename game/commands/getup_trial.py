"""A try to get up with key poses that a search proposes, and how good it was."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game.characters.joint_limits import HIGH, LOW
from game.characters.skeleton import FEET, JOINT_COUNT, JOINTS, PARTS
from game.characters.strength import joint_strength
from game.commands.casting import body_plan
from game.commands.getup_case import GetupCase, lie_after_shove
from game.control.joint_command import JointCommand
from game.control.whole_body.capture_point import capture_point, natural_frequency
from game.control.whole_body.falling import fall
from game.control.whole_body.getting_up import GettingUp, is_ready, nearer_route_of
from game.control.whole_body.key_poses import KeyPose, pose_of
from game.control.whole_body.sole import polygon, soles_of
from game.control.whole_body.support_polygon import distance_inside
from game.physics.dynamics import BodyDynamics
from game.physics.world import FRAME_HZ, World
from game.rotation import exp
from game.tunables import Settings

Floats = NDArray[np.float64]

STEP_RAD, USUAL_S, SHORTEST_S, LONGEST_S = 0.5, 0.35, 0.2, 1.0
"""A number of 1 turns a joint so far; one of 0 takes this time for the way to a pose, which keeps within the last two."""

_BOTH_SIDES = ("spine.y", "neck.y", "shoulder.x", "shoulder.y", "elbow.y", "hip.x", "hip.y", "knee.y", "ankle.y")
_ONE_SIDE = ("shoulder_{}.x", "shoulder_{}.y", "elbow_{}.y", "hip_{}.x", "hip_{}.y", "knee_{}.y")
_ROLL = ("spine.x", "spine.y", "spine.z", *(name.format(side) for side in ("left", "right") for name in _ONE_SIDE))
AXES = {"side": _ROLL, "supine": _ROLL, "prone": _BOTH_SIDES}
"""What is turned on each route: joint and axis; what has no side is turned on both, mirrored."""

INSIDE_M, SLOW_M_S, LOW_M = 0.03, 0.4, 0.4
"""What a try is to come to: the COM so far inside its feet, so slow, so high."""

FAILED, UNREADY, READY = 9.0, 0.13, 0.1
"""Loss of a try that broke off, the least of one that did not come to stand ready, the largest of one that did."""

SHOVED_SHARE = 0.8
"""So many lie as the game's shoves leave them, which is other than how a body lies that was thrown there."""

_DROP_M, _LIE_S = 0.7, 1.8
_TRUNK = PARTS.index("trunk")
_NOTHING = np.zeros(3 * JOINT_COUNT)


def poses_of(route: str, numbers: Floats) -> tuple[KeyPose, ...]:
    """Key poses of a proposal: for each its turns, in the order of AXES, then its time."""
    axes = AXES[route]
    return tuple(_pose_of(axes, row) for row in numbers.reshape(-1, len(axes) + 1))


def _pose_of(axes: Sequence[str], row: Floats) -> KeyPose:
    turned: dict[str, list[float]] = {}
    for name, number in zip(axes, row[:-1], strict=True):
        joint, axis = name.split(".")
        turned.setdefault(joint, [0.0, 0.0, 0.0])["xyz".index(axis)] = STEP_RAD * float(number)
    seconds = min(max(USUAL_S * float(np.exp(row[-1])), SHORTEST_S), LONGEST_S)
    return KeyPose(np.clip(pose_of(**turned), LOW, HIGH), seconds)


def numbers_of(route: str, poses: Sequence[KeyPose]) -> Floats:
    """The proposal that `poses_of` makes these poses from."""
    rows = []
    for pose in poses:
        row = []
        for name in AXES[route]:
            joint, axis = name.split(".")
            row.append(pose.joints[JOINTS.index(joint if joint in JOINTS else f"{joint}_left"), "xyz".index(axis)] / STEP_RAD)
        rows.append([*row, np.log(pose.seconds / USUAL_S)])
    return np.array(rows).reshape(-1)


class Trial:
    """A world with one character that collides with itself, thrown down and driven again and again."""

    def __init__(self, character: str, settings: Settings) -> None:
        self._character, self._settings = character, settings
        self.world = World([body_plan(character)], settings)
        self.body: BodyDynamics = self.world.characters[0]
        low, high = joint_strength(self.body.plan)
        scale = settings.number("whole_body.strength")
        self._strength = scale * low, scale * high

    def lie(self, rng: np.random.Generator) -> Floats:
        """(63,) how it lies: four times in five shoved over in the game, else fallen from a height, limbs and body turned anyhow."""
        while rng.uniform() < SHOVED_SHARE:
            case = GetupCase(self._character, int(rng.integers(1 << 30)), int(rng.integers(1 << 30)))
            lies = lie_after_shove(case, self._settings)
            if lies is not None:
                return lies
        body, turn = self.body, rng.normal(size=4)
        joints = 0.6 * (LOW + (HIGH - LOW) * rng.uniform(0.1, 0.9, LOW.shape))
        self.world.place(0, np.array([0.0, 0.0, _DROP_M]), turn / np.linalg.norm(turn), exp(joints))
        self._forget()
        rotation, kp, kd = np.empty((JOINT_COUNT, 4)), np.empty(3 * JOINT_COUNT), np.empty(3 * JOINT_COUNT)
        for frame in range(round(_LIE_S * FRAME_HZ)):
            inertia = np.ascontiguousarray(np.diagonal(body.equations[0])[6:])
            fall(frame / FRAME_HZ, body.turn[_TRUNK], body.joint_rotation, inertia, rotation, kp, kd)
            self._frame(rotation, kp, kd)
        return body.configuration

    def roll(self, lying: Floats) -> Floats:
        """(63,) how one who lies on the back (63,) lies after the key poses of that route."""
        self._place(lying)
        getting_up = GettingUp(self.body, "supine")
        while not getting_up.has_ended:
            self._drive(getting_up)
        return self.body.configuration

    def loss(self, lying: Floats, route: str, poses: Sequence[KeyPose]) -> float:
        """How far a try from where it lies (63,) ends from standing ready.

        Who has rolled over goes on from the front with the key poses of the data file: they have to fit.
        """
        self._place(lying)
        body, best = self.body, FAILED
        getting_up = GettingUp(body, route, poses)
        while not getting_up.has_ended or getting_up.route != "prone":
            if getting_up.has_ended:
                if nearer_route_of(body) == "supine":
                    return 1.5 + 0.5 * float(body.turn[_TRUNK, 2, 0])
                getting_up = GettingUp(body, "prone")
            self._drive(getting_up)
            if getting_up.comes_to_stand:
                if is_ready(body):
                    return min(READY, 0.3 * unreadiness(body))
                best = min(best, max(UNREADY, unreadiness(body)))
        return best

    def _place(self, configuration: Floats) -> None:
        self.world.place(0, configuration[:3], configuration[3:7], configuration[7:].reshape(-1, 4))
        self._forget()

    def _forget(self) -> None:
        """The solver's last answer would change the last bits of the next one."""
        self.world.data.qacc_warmstart[:] = 0.0

    def _drive(self, getting_up: GettingUp) -> None:
        """One frame."""
        rotation, kp, kd = np.empty((JOINT_COUNT, 4)), np.empty(3 * JOINT_COUNT), np.empty(3 * JOINT_COUNT)
        getting_up.drive(self.body, *self._strength, 1.0 / FRAME_HZ, rotation, kp, kd)
        self._frame(rotation, kp, kd)

    def _frame(self, rotation: Floats, kp: Floats, kd: Floats) -> None:
        self.world.command(0, JointCommand(rotation.copy(), _NOTHING, kp.copy(), kd.copy(), _NOTHING))
        for _ in range(self.world.steps_per_frame):
            self.world.step()
        self.world.refresh()


def unreadiness(body: BodyDynamics) -> float:
    """How far a body is from standing ready: metres off its feet, its soles' tilt and height, its speed, and how low it still is."""
    soles, com = soles_of(body), body.com
    xi = capture_point(com, body.com_velocity, natural_frequency(body.gravity, float(com[2])))
    hull = polygon(soles, True, True, INSIDE_M)
    off = sum(max(0.0, -float(distance_inside(hull, point))) for point in (xi, com[:2]))
    tilt = float(np.sum(1.0 - body.turn[list(FEET), 2, 2]))
    high = sum(max(0.0, float(sole.centre[2])) for sole in soles)
    fast = max(0.0, float(np.linalg.norm(body.com_velocity)) - SLOW_M_S)
    return off + tilt + 1.5 * high + 0.3 * fast + 0.6 * max(0.0, LOW_M - float(com[2]))
