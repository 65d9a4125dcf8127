"""Players before the input gate: performers with and without a sensor's errors, and poses made for one purpose."""

import numpy as np

from game.inputs.open_input import open_input
from game.inputs.performance.repertoire import motion
from game.intake.gate import InputGate
from game.intake.intake import Intake
from game.intake.world_frame import WorldFrame, to_world
from game.rotation import Floats
from game.tunables import Settings, Value
from tests.kinect.recordings import standing_joints

HZ = 30.0


def standing() -> Floats:
    """(20, 3) a person who stands quietly, world frame."""
    return to_world(standing_joints() + np.array([0.0, 0.9, 0.0]))


def gated(joints: Floats, **values: Value) -> list[WorldFrame]:
    """Frames (T, 20, 3) at 30 Hz through a gate of their own; `gate__up_m=0.05` sets gate.up_m."""
    gate = InputGate(settings(**values))
    frames = [gate.apply(k / HZ, frame.copy(), frame.copy()) for k, frame in enumerate(joints)]
    return [frame for frame in frames if frame is not None]


def performed(name: str, noise: float = 0.0, outliers: float = 0.0, seed: int = 0, **values: Value) -> list[WorldFrame]:
    """A performer as the whole intake hands it on."""
    intake = Intake(settings(**values), mirrored=False)
    source = open_input(f"performer:{name}", noise=noise, outliers=outliers, seed=seed)
    frames = [intake.apply(frame) for frame in source.poll(1e3)]
    return [frame for frame in frames if frame is not None]


def true_contacts(name: str, frames: list[WorldFrame]) -> np.ndarray:
    """(T, 2) whether the performer's left and right foot bear at the frames' times."""
    script, t = motion(name).script, np.array([frame.time_s for frame in frames])
    return np.stack((script.on_floor(t, "left"), script.on_floor(t, "right")), axis=1)


def contacts(frames: list[WorldFrame]) -> np.ndarray:
    """(T, 2) whether the gate says that left and right foot are planted."""
    return np.array([frame.contacts.planted for frame in frames])


def joints(frames: list[WorldFrame]) -> Floats:
    return np.array([frame.joints for frame in frames])


def settings(**values: Value) -> Settings:
    return Settings({name.replace("__", "."): value for name, value in values.items()})
