"""A person on strings: keys and gamepad ask, a plausible body does it, a level sensor 2.5 m away sees it."""

from collections.abc import Mapping
from typing import Final

import numpy as np

from game.inputs.performance.figure import Figure, pose_figure
from game.inputs.performance.person import SHIN_M, THIGH_M, centre_of_mass
from game.inputs.performance.script import STANDING
from game.inputs.performer import FLOOR, FRAMES_PER_S, to_sensor
from game.inputs.puppet_balance import Pendulum
from game.inputs.puppet_controls import PuppetControls
from game.inputs.puppet_footwork import Footwork
from game.inputs.puppet_posture import Posture
from kinect.body import JOINT_COUNT, BodyFrame, Floats, Joint
from kinect.source import BodySource

_DEGREES: Final = frozenset({"pitch", "roll", "yaw", "flex", "side", "twist", "elbow", "tilt"})
_STEP_S: Final = 1.0 / FRAMES_PER_S
_FOLLOWS: Final = 1.25  # pelvis movement per movement of the centre of mass: the feet stay, the legs follow by half
_LEG_M: Final = THIGH_M + SHIN_M - 0.002


class Puppet:
    """A `BodySource` of 30 frames a second that does what `controls` says at the time it is polled.

    Bones are rigid, the centre of mass moves as an inverted pendulum over the feet, wishes pass critically damped filters.
    """

    def __init__(self, controls: PuppetControls | None = None, player: int = 0, greeting: str = "Keys and gamepad steer a puppet.") -> None:
        self._greeting = greeting
        self.controls = controls if controls is not None else PuppetControls()
        self._player = player
        self._posture = Posture()
        self._footwork = Footwork()
        self._pendulum = Pendulum()
        self._frames = 0
        self._pelvis = np.zeros(2)
        for _ in range(5):
            _, com, self._pelvis = _solve(_figure(STANDING), self._pelvis, self._pendulum.com)
        self._com_height = float(com[2])
        self._standing_height = self._com_height
        self._closed = False

    @property
    def status(self) -> str:
        doing = self._footwork.move
        return f"{self._greeting} It does a {doing}." if doing else self._greeting

    @property
    def length_s(self) -> float | None:
        """None: a puppet never ends."""
        return None

    def poll(self, until_s: float) -> list[BodyFrame]:
        """The frames up to until_s (finite), each following the controls as they are now."""
        frames: list[BodyFrame] = []
        while not self._closed and self._frames * _STEP_S <= until_s + 1e-9:
            time_s = self._frames * _STEP_S
            frames.append(BodyFrame(time_s, to_sensor(self._next_joints(time_s)), np.ones(JOINT_COUNT), self._player, FLOOR))
            self._frames += 1
        return frames

    def close(self) -> None:
        """Hand out no more frames."""
        self._closed = True

    def _next_joints(self, time_s: float) -> Floats:
        """(20, 3) joints, metres, world; the first call gives quiet standing."""
        footwork, pendulum = self._footwork, self._pendulum
        if self._frames > 0:
            footwork.step(self.controls, float(pendulum.capture_point(self._com_height)[1]), _STEP_S)
            self._posture.step(self.controls, _STEP_S, footwork.on_both_feet)
        channels = self._posture.channels(time_s)
        footwork.add_to(channels)
        if self._frames > 0:
            pendulum.step(np.array([channels["zmp.x"], channels["zmp.y"]]), footwork.support(), self._com_height, _STEP_S)
        rise, strictly = footwork.rise()
        channels["pelvis.height"] += rise
        joints, com, self._pelvis = _solve(_figure(channels), self._pelvis, pendulum.com, self._standing_height + rise, strictly)
        self._com_height = float(com[2])
        return joints


def puppet_of(source: BodySource) -> Puppet | None:
    """The puppet inside a source, however deeply it is wrapped; None where keys cannot steer."""
    inner: object = source
    while inner is not None and not isinstance(inner, Puppet):
        inner = getattr(inner, "source", None)
    return inner


def _figure(channels: Mapping[str, float]) -> Figure:
    """One posture from channels in metres and degrees."""
    values = {name: np.array([value]) for name, value in channels.items()}
    return pose_figure({name: np.radians(value) if name.rsplit(".", 1)[1] in _DEGREES else value for name, value in values.items()})


def _solve(figure: Figure, start_xy: Floats, com_xy: Floats, com_z: float = 0.0, strictly: float = 0.0) -> tuple[Floats, Floats, Floats]:
    """Joints (20, 3), centre of mass (3,) and pelvis (2,) with the pelvis where it puts the centre of mass at com_xy (2,).

    start_xy: (2,) pelvis of the frame before. strictly: 0 keeps the posture's pelvis height, 1 puts the centre of mass
    at com_z, between is between.
    """
    posture_height = float(figure.pelvis_height[0])
    pelvis = np.array([[start_xy[0], start_xy[1], posture_height]])
    for _ in range(3):
        com = centre_of_mass(figure.joints(pelvis))[0]
        pelvis[0, :2] += _FOLLOWS * (com_xy - com[:2])
        exact = pelvis[0, 2] + _FOLLOWS * (com_z - com[2])
        pelvis[0, 2] = posture_height + strictly * (exact - posture_height)
        pelvis[0, 2] = min(pelvis[0, 2], _highest_pelvis(figure, pelvis[0]))
    joints = figure.joints(pelvis)
    return joints[0], centre_of_mass(joints)[0], pelvis[0, :2]


def _highest_pelvis(figure: Figure, pelvis: Floats) -> float:
    """How high HIP_CENTER may be with both legs just short of straight, metres."""
    room = []
    for hip, ankle in ((Joint.HIP_LEFT, Joint.ANKLE_LEFT), (Joint.HIP_RIGHT, Joint.ANKLE_RIGHT)):
        way = figure.feet[0, ankle] - figure.body[0, hip] - pelvis
        room.append(pelvis[2] + way[2] + float(np.sqrt(max(0.0, _LEG_M**2 - way[0] ** 2 - way[1] ** 2))))
    return min(room)
