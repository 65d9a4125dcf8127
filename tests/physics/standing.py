"""Box characters that stand, swing their arms and are steered by plain joint commands, for the tests of physics and control."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan, load_body_plan
from game.characters.skeleton import JOINT_COUNT, JOINTS
from game.control.gains import gains
from game.control.gravity_feedforward import gravity_torque
from game.control.joint_command import JointCommand
from game.physics.dynamics import BodyDynamics
from game.physics.world import World
from game.tunables import Settings

Floats = NDArray[np.float64]
Commander = Callable[[BodyDynamics, int], JointCommand | None]

FACING_AWAY = rotation.about_z(0.0)
FACING_BACK = rotation.about_z(np.pi)
STEPS_PER_COMMAND = 4
STEP_S = 1.0 / 480.0
"""Of a world that is not told another: the tests count their seconds in steps, 480 of them each."""


@cache
def original() -> BodyPlan:
    return load_body_plan("original")


def idle_joints() -> Floats:
    """(14, 4) all joints straight."""
    return np.tile(rotation.IDENTITY, (JOINT_COUNT, 1))


def world_of(*places: Sequence[float], plan: BodyPlan | None = None, joints: Floats | None = None, **settings: object) -> World:
    """Characters at rest, idle unless `joints` are given, at places (x, y, z), soles z above the floor; every second one faces back.

    Settings are given with a double underscore for the point: physics__friction=0.1.
    """
    plan = plan or original()
    values = {"physics.step_s": STEP_S} | {name.replace("__", "."): value for name, value in settings.items()}
    world = World([plan] * len(places), Settings(values))
    for index, (x, y, z) in enumerate(places):
        facing = FACING_BACK if index % 2 else FACING_AWAY
        world.place(index, np.array([x, y, z + plan.joint[0, 2]]), facing, idle_joints() if joints is None else joints)
    return world


def bent(**angles: tuple[float, float, float]) -> Floats:
    """(14, 4) straight joints but for those named, by rotation vectors in the parent's frame, rad."""
    joints = idle_joints()
    for name, angle in angles.items():
        joints[JOINTS.index(name)] = rotation.exp(np.array(angle))
    return joints


def hold(body: BodyDynamics, joints: Floats | None = None, kp_hat: float = 800.0) -> JointCommand:
    """Hold `joints`, or stand idle, with the gains of Eq. 3.8 and gravity taken off."""
    kp, kd = gains(body, kp_hat, "dynamic")
    return JointCommand(idle_joints() if joints is None else joints, np.zeros(42), kp, kd, gravity_torque(body, 0.5))


def swing(body: BodyDynamics, step: int) -> JointCommand:
    """Stand and swing the arms and trunk."""
    a = 0.5 * np.sin(step / 40.0)
    joints = bent(spine=(0.0, 0.3 * a, 0.2 * a), shoulder_left=(0.0, -a, 0.0), shoulder_right=(0.0, a, 0.0), elbow_left=(0.0, -abs(a), 0.0))
    return hold(body, joints)


def thrash(body: BodyDynamics, step: int) -> JointCommand:
    """Throw every joint about as hard as it goes."""
    phase = np.arange(3 * JOINT_COUNT).reshape(JOINT_COUNT, 3)
    command = hold(body, rotation.exp(0.8 * np.sin(step / 25.0 + phase)))
    return replace(command, feedforward=np.zeros(42))


def limp(_body: BodyDynamics, _step: int) -> None:
    return None


def run(world: World, steps: int, commander: Commander | Sequence[Commander] = swing) -> Floats:
    """Steps the world, one commander for all or one each; (steps, nq + nv) the state after each step."""
    every = list(commander) if isinstance(commander, Sequence) else [commander] * len(world.characters)
    states = np.empty((steps, world.model.nq + world.model.nv))
    for k in range(steps):
        if world.step_count % STEPS_PER_COMMAND == 0:
            world.refresh()
            for index, (body, commands) in enumerate(zip(world.characters, every, strict=True)):
                command = commands(body, world.step_count)
                if command is not None:
                    world.command(index, command)
        world.step()
        states[k] = np.concatenate((world.data.qpos, world.data.qvel))
    return states


def unexplained(world: World) -> tuple[float, float]:
    """Largest unexplained force (N) and torque (N m) of any character so far."""
    return float(world.meter.unexplained_force_n.max()), float(world.meter.unexplained_torque_nm.max())
