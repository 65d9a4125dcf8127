"""The window on the character's left with its curtains, the floor lamp, and a string of small lights."""

import math
from itertools import pairwise

from game.scenes.room.carpentry import METAL, PAINTED, Carpentry, Finish
from game.scenes.room.walls import SIDE_Y

_PANE = Finish(0.0, 0.2, emission=2.2, material="outdoors", casts_shadow=False)
_SHADE = Finish(0.05, 0.9, emission=2.6, casts_shadow=False)


def window(room: Carpentry, x: float = -0.9, width: float = 1.9, low: float = 0.75, high: float = 2.25) -> None:
    """In the wall at +y, where the main light comes from."""
    y, middle, tall = SIDE_Y - 0.02, (low + high) / 2, high - low
    room.box((x, y, middle), (width, 0.02, tall), "#ffffff", _PANE)
    for part in (-0.5, 0.0, 0.5):
        room.box((x + part * width, y - 0.02, middle), (0.06, 0.05, tall + 0.06), "#f4ecdf", PAINTED)
    for z in (low, middle + 0.2, high):
        room.box((x, y - 0.02, z), (width + 0.06, 0.05, 0.055), "#f4ecdf", PAINTED)
    room.box((x, y - 0.08, low - 0.03), (width + 0.2, 0.2, 0.04), "#f4ecdf", PAINTED)
    room.rod((x - 1.5, y - 0.13, 2.42), (x + 1.5, y - 0.13, 2.42), 0.014, "#6b4526", 0.3)
    for side in (-1.0, 1.0):
        _curtain(room, x + side * (width / 2 + 0.18), y - 0.13)
    _sill(room, x, y - 0.10, low)


def _curtain(room: Carpentry, x: float, y: float) -> None:
    for fold in range(7):
        at = x + (fold - 3) * 0.085
        depth = y + (0.022 if fold % 2 else -0.022)
        room.rod((at, depth, 0.06), (at, depth, 2.36), 0.05, "#d8b98a" if fold % 2 else "#cfae7d", 1.0)


def _sill(room: Carpentry, x: float, y: float, z: float) -> None:
    for at, pot in ((-0.55, "#c96f3f"), (0.15, "#e4d3b4"), (0.62, "#3c6f7d")):
        room.box((x + at, y, z + 0.05), (0.11, 0.11, 0.11), pot, Finish(0.02, 0.7))
        for i in range(6):
            angle = i * 2.4 + at
            top = (x + at + 0.07 * math.cos(angle), y + 0.07 * math.sin(angle), z + 0.17 + 0.02 * (i % 3))
            room.rod((x + at, y, z + 0.10), top, 0.014, "#5f8f45", 0.8)


def floor_lamp(room: Carpentry, x: float = -2.75, y: float = 1.36) -> None:
    """Beside the sofa; its shade is what lights the evening side of the room."""
    room.box((x, y, 0.015), (0.30, 0.30, 0.03), "#2b2622", Finish(0.014, 0.4))
    room.rod((x, y, 0.03), (x, y, 1.46), 0.012, "#b99a5b", 0.25)
    room.box((x, y, 1.56), (0.34, 0.34, 0.30), "#ffb464", _SHADE)
    room.box((x, y, 1.405), (0.35, 0.35, 0.012), "#b99a5b", METAL)
    room.box((x, y, 1.715), (0.35, 0.35, 0.012), "#b99a5b", METAL)


def string_lights(room: Carpentry, x: float = -3.25, span: float = 5.9, swags: int = 4) -> None:
    """Hung in swags along the wall behind the character."""
    count = swags * 7
    places = []
    for i in range(count + 1):
        t = i / count
        drop = 0.14 * abs(math.sin(math.pi * swags * t))
        places.append((x, (t - 0.5) * span, 2.52 - drop))
    for a, b in pairwise(places):
        room.rod(a, b, 0.004, "#2b2622", 0.8, shadow=False)
    for place in places[1:-1]:
        bulb = (place[0] + 0.01, place[1], place[2] - 0.035)
        room.rod(bulb, bulb, 0.018, "#ffb45c", 0.5, 3.2, shadow=False)
