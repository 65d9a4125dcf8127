"""One character with its player: frames come in, targets follow, torques go out."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import DOF_COUNT
from game.control.joint_command import BalanceStrategy
from game.control.strategies import STRATEGIES
from game.inputs.sensor_noise import SensorNoise
from game.intake.intake import Intake
from game.intake.world_frame import WorldFrame
from game.physics.hang import hanging_root, hold_root, level_feet, release_root
from game.physics.world import World
from game.target.calibration import QUIET_S, Calibration, calibrate, quietest_stretch
from game.target.kinematic_target import KinematicTarget, TargetTracker
from game.tunables import Settings
from kinect.source import BodySource

Floats = NDArray[np.float64]

SETTLING_STEPS = 20
"""Inverse kinematics steps on the first frame, so that the hang begins in the first target and not on the way to it."""


class NoBodyError(ValueError):
    """An input in which nobody is to be seen."""


class Fighter:
    """Character `index` of a world, moved by what a source sees. Times are the source's own.

    place: where it stands, world x, y (m); facing_rad: turned about z from where the player faces;
    strategy: the tunable that names how it keeps its feet.
    """

    def __init__(
        self,
        index: int,
        plan: BodyPlan,
        opens: Callable[[], BodySource],
        settings: Settings,
        *,
        mirrored: bool,
        place: tuple[float, float] = (0.0, 0.0),
        facing_rad: float = 0.0,
        strategy: str = "balance.strategy",
    ) -> None:
        self.index, self.plan, self._settings = index, plan, settings
        self._opens, self.mirrored = opens, mirrored
        self._place, self.facing_rad = np.array(place), facing_rad
        self.source = opens()
        self.intake = Intake(settings, mirrored=mirrored)
        self._strategy_tunable = strategy
        self.strategy_name = settings.choice(strategy)
        self.strategy: BalanceStrategy = STRATEGIES[self.strategy_name](settings)
        self.frame: WorldFrame | None = None
        self.first_frame, self.calibration = self._get_acquainted()
        self.tracker = TargetTracker(plan, self.calibration, settings)
        first = self.first_frame
        target = self.tracker.step(first.time_s - 1.0, first.joints, first.raw)
        for _ in range(SETTLING_STEPS):
            target = self.tracker.step(first.time_s - 1.0, first.joints, first.raw)
        self.target: KinematicTarget = target
        self.frames_seen = 0
        self.fault = ""

    def _get_acquainted(self) -> tuple[WorldFrame, Calibration]:
        """The first frame and the calibration: of a recording its quietest stretch, of a live player the first half second."""
        length = self.source.length_s
        finite = length is not None
        rehearsal = self._opens() if finite else self.source
        intake = Intake(self._settings, mirrored=self.mirrored) if finite else self.intake
        frames = [intake.apply(frame) for frame in rehearsal.poll(length + 1.0 if length is not None else QUIET_S)]
        seen = [frame for frame in frames if frame is not None]
        if finite:
            rehearsal.close()
        if not seen:
            raise NoBodyError(f"{self.source.status} No frame shows a whole body{': ' + intake.fault if intake.fault else ''}.")
        times = np.array([frame.time_s for frame in seen])
        joints = np.array([frame.joints for frame in seen])
        return (seen[0] if finite else seen[-1]), calibrate(self.plan, joints[quietest_stretch(times, joints)])

    def hang(self, world: World) -> None:
        """Place the character just above the floor in its present target's pose, at its place, and hold its root there."""
        target = self.target
        position, orientation = hanging_root(self.plan, self._place, target.root_orientation, target.joint_rotation)
        orientation = rotation.multiply(rotation.about_z(self.facing_rad), orientation)
        world.place(self.index, position, orientation, level_feet(self.plan, orientation, target.joint_rotation))
        hold_root(world.model, world.data, self.index, position, orientation)
        self.strategy.reset(world.characters[self.index])

    def release(self, world: World) -> None:
        release_root(world.model, world.data, self.index)

    def watch(self, until_s: float) -> None:
        """Take every frame up to `until_s` and bring the target up to date; bad frames hold the last good target."""
        if isinstance(self.source, SensorNoise):
            self.source.scale = self._settings.number("sensor.noise")
            self.source.latency_s = self._settings.number("sensor.latency_s")
            self.source.outliers = self._settings.number("sensor.outliers")
        for frame in self.source.poll(until_s):
            self.frames_seen += 1
            seen = self.intake.apply(frame)
            self.fault = self.intake.fault
            if seen is not None:
                self.frame = seen
                self.target = self.tracker.step(seen.time_s, seen.joints, seen.raw, seen.contacts)

    def control(self, world: World, dt: float) -> None:
        """Hand the world a new joint command."""
        wanted = self._settings.choice(self._strategy_tunable)
        body = world.characters[self.index]
        if wanted != self.strategy_name:
            self.strategy_name, self.strategy = wanted, STRATEGIES[wanted](self._settings)
            self.strategy.reset(body)
        world.command(self.index, self.strategy.command(self.target, body, dt))

    def dofs(self) -> slice:
        return slice(DOF_COUNT * self.index, DOF_COUNT * (self.index + 1))

    def close(self) -> None:
        self.source.close()
