"""The shove that pushes and falls are measured with: a constant force at the chest for a fifth of a second."""

import math

import numpy as np

from game.characters.skeleton import PARTS
from game.physics.world import World

PUSH_S = 0.2


def shove_chest(world: World, towards_rad: float, impulse_ns: float) -> None:
    """State it for character 0, from now on; towards_rad: where it points in the world, counterclockwise from x."""
    force = impulse_ns / PUSH_S * np.array([math.cos(towards_rad), math.sin(towards_rad), 0.0])
    world.push(0, PARTS.index("trunk"), force, round(PUSH_S / world.step_s))
