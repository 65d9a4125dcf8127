"""The light of the room: one main light, the bounce from ceiling and floor, and every lamp found among what glows."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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
_LEAST_POWER = 0.02


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


def glowing(rows: Rows) -> Rows:
    """Those of rows (N, 18) that light the room: bright and large. An eye glows, but lights nothing."""
    return rows[_power(rows) > _LEAST_POWER]


def find_lamps(rows: Rows, brightness: float, count: int) -> tuple[list[tuple[float, ...]], list[tuple[float, ...]]]:
    """The `count` strongest of rows (N, 18): (x, y, z, squared radius) and RGB of each; missing ones are black."""
    places: list[tuple[float, ...]] = []
    colours: list[tuple[float, ...]] = []
    power = _power(rows)
    for row in np.argsort(-power, kind="stable")[:count]:
        places.append((*map(float, rows[row, 0:3]), float(power[row] / rows[row, 16]) + 0.02))
        colours.append(tuple(float(v) * float(power[row]) * 4.0 * brightness for v in rows[row, 12:15]))
    missing = count - len(places)
    return places + [(0.0, 0.0, -50.0, 1.0)] * missing, colours + [(0.0, 0.0, 0.0)] * missing


def _power(rows: Rows) -> NDArray[np.float32]:
    """Emission times the larger side's quarter area (m2)."""
    half = np.abs(rows[:, 8:11])
    return rows[:, 16] * half.prod(axis=1) / np.maximum(half.min(axis=1), 1e-6)
