"""A body thrown about in the air, its equations of motion, and how a small motion of any of its degrees of freedom shows."""

from collections.abc import Callable

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import FEET
from game.physics.dynamics import BodyDynamics
from game.physics.world import World
from tests.physics.standing import run, thrash, world_of

Floats = NDArray[np.float64]


def thrown(steps: int = 60) -> tuple[World, BodyDynamics]:
    """A world with one body high above the floor that flies, tumbles and has every joint on the move."""
    world = world_of((0.3, -0.2, 2.0))
    run(world, steps, thrash)
    world.data.qvel[:6] += [0.8, -0.5, 1.2, 1.5, -2.0, 1.0]
    world.refresh()
    return world, world.characters[0]


def moved(world: World, velocity: Floats, time_s: float, look: Callable[[BodyDynamics], Floats]) -> Floats:
    """What `look` sees once every degree of freedom has gone on at `velocity` (48,) for `time_s`; the body is put back."""
    before = world.data.qpos.copy()
    mj.mj_integratePos(world.model, world.data.qpos, velocity, time_s)
    world.refresh()
    seen = look(world.characters[0])
    world.data.qpos[:] = before
    world.refresh()
    return seen


def rate(world: World, velocity: Floats, look: Callable[[BodyDynamics], Floats], step_s: float = 1e-5) -> Floats:
    """Central difference of what `look` sees along a motion at constant `velocity` (48,)."""
    return (moved(world, velocity, step_s, look) - moved(world, velocity, -step_s, look)) / (2.0 * step_s)


def sole_point(body: BodyDynamics, side: int) -> Floats:
    """(3,) centre of the sole, world."""
    part = FEET[side]
    return body.box_centre[part] - 0.5 * body.plan.size[part][2] * body.turn[part][:, 2]
