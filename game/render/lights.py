"""The light of the room: one main light, the bounce from ceiling and floor, and every lamp found among what glows."""

import math
from dataclasses import dataclass

import numpy as np

from game.render.instances import Rows
from game.render.matrices import Matrix, Vector, look_at, multiply, orthographic
from game.tunables import Settings

SHADOW_CENTRE: Vector = (0.0, 0.0, 0.7)
SHADOW_REACH_M = 3.7
"""Half the side of the square, seen from the light, in which shadows fall."""
_KEY = (2.55, 2.05, 1.50)
_SKY = (0.19, 0.23, 0.31)
_GROUND = (0.17, 0.12, 0.085)
_FILL = (0.20, 0.15, 0.11)
_RIM = (0.55, 0.70, 0.95)
_LEAST_GLOW = 0.5


@dataclass(frozen=True)
class Lights:
    """Linear RGB intensities; to_light is the unit vector towards the main light, to_fill towards the soft one opposite."""

    to_light: Vector
    key: Vector
    sky: Vector
    ground: Vector
    fill: Vector
    to_fill: Vector
    rim: Vector


def room_lights(settings: Settings) -> Lights:
    """The light the picture.* tunables ask for. Low light is warmer, as the sun's is."""
    azimuth = math.radians(settings.number("picture.light_azimuth_deg"))
    height = math.radians(settings.number("picture.light_height_deg"))
    level = math.cos(height)
    to_light = (math.cos(azimuth) * level, math.sin(azimuth) * level, math.sin(height))
    to_fill = (-math.cos(azimuth), -math.sin(azimuth), 0.0)
    return Lights(to_light, _KEY, _SKY, _GROUND, _FILL, to_fill, _RIM)


def shadow_matrix(to_light: Vector) -> Matrix:
    """World to the clip space of the main light."""
    eye = (SHADOW_CENTRE[0] + 8.0 * to_light[0], SHADOW_CENTRE[1] + 8.0 * to_light[1], SHADOW_CENTRE[2] + 8.0 * to_light[2])
    return multiply(orthographic(SHADOW_REACH_M, SHADOW_REACH_M, 2.0, 14.0), look_at(eye, SHADOW_CENTRE))


def find_lamps(rows: Rows, brightness: float, count: int) -> tuple[list[tuple[float, ...]], list[tuple[float, ...]]]:
    """The `count` strongest glowing solids among rows (N, 18): (x, y, z, squared radius) and RGB of each; missing ones are black."""
    places: list[tuple[float, ...]] = []
    colours: list[tuple[float, ...]] = []
    size = np.sort(np.abs(rows[:, 8:11]), axis=1)
    area = size[:, 1] * size[:, 2]
    power = np.where(rows[:, 16] > _LEAST_GLOW, rows[:, 16], 0.0) * area
    for row in np.argsort(-power, kind="stable")[:count]:
        if power[row] > 1e-3:
            places.append((*map(float, rows[row, 0:3]), float(area[row]) + 0.02))
            colours.append(tuple(float(v) * float(power[row]) * 3.0 * brightness for v in rows[row, 12:15]))
    missing = count - len(places)
    return places + [(0.0, 0.0, -50.0, 1.0)] * missing, colours + [(0.0, 0.0, 0.0)] * missing
