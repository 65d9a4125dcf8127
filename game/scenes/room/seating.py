"""The sofa with its cushions, a blanket and the cat; the coffee table that was pushed aside to make room for the game."""

import math
from itertools import pairwise

from game.scenes.room.carpentry import CLOTH, PAINTED, WOOD, Carpentry, Finish, compose, turn_about, yaw

_SOFA, _SOFA_LIGHT = "#2b4a63", "#34587a"
_SOFT = Finish(0.07, 0.95, material="fabric")
_PILLOW = Finish(0.06, 0.95, material="fabric")
_CAT = "#d98a45"


def sofa(room: Carpentry, x: float = -2.55, y: float = -0.25) -> None:
    """Three seats wide, its back to the wall behind the character."""
    room.box((x, y, 0.24), (0.92, 2.24, 0.20), _SOFA, CLOTH)
    room.box((x - 0.34, y, 0.52), (0.24, 2.24, 0.62), _SOFA, _SOFT)
    for side in (-1.0, 1.0):
        room.box((x + 0.02, y + side * 1.08, 0.41), (0.94, 0.22, 0.44), _SOFA, _SOFT)
        for foot in (-0.36, 0.36):
            room.rod((x + foot, y + side * 1.0, 0.03), (x + foot, y + side * 1.0, 0.12), 0.022, "#6b4526")
    for seat in (-0.64, 0.0, 0.64):
        room.box((x + 0.09, y + seat, 0.405), (0.74, 0.63, 0.17), _SOFA_LIGHT, _SOFT)
        room.box((x - 0.17, y + seat, 0.64), (0.20, 0.62, 0.40), _SOFA_LIGHT, _SOFT, turn_about((0.0, 1.0, 0.0), -12.0))
    lean = turn_about((0.0, 1.0, 0.0), -24.0)
    for at, colour, roll in ((-0.80, "#d9a23a", 18.0), (-0.52, "#b5482a", -14.0), (0.82, "#e4d3b4", -16.0)):
        room.box((x + 0.04, y + at, 0.67), (0.13, 0.42, 0.40), colour, _PILLOW, compose(lean, turn_about((1.0, 0.0, 0.0), roll)))
    _blanket(room, x, y + 1.09)
    _cat(room, x + 0.14, y + 0.34, 0.50)


def _blanket(room: Carpentry, x: float, y: float) -> None:
    knit = Finish(0.02, 1.0, material="fabric")
    room.box((x + 0.10, y, 0.635), (0.46, 0.25, 0.035), "#cf7b4a", knit)
    room.box((x + 0.10, y + 0.125, 0.47), (0.46, 0.035, 0.36), "#cf7b4a", knit)
    room.box((x + 0.02, y + 0.127, 0.47), (0.06, 0.036, 0.362), "#ecd9b6", knit)
    room.box((x + 0.18, y + 0.127, 0.47), (0.06, 0.036, 0.362), "#ecd9b6", knit)


def _cat(room: Carpentry, x: float, y: float, z: float) -> None:
    """Asleep, curled up; nothing a falling biped does wakes it."""
    ring = [(x + 0.11 * math.cos(a), y + 0.13 * math.sin(a), z + 0.05) for a in (0.4, 1.2, 2.0, 2.8, 3.6, 4.4)]
    for i, (a, b) in enumerate(pairwise(ring)):
        room.rod(a, b, 0.088 - 0.004 * i, _CAT, 0.95)
    room.rod((x + 0.13, y - 0.06, z + 0.08), (x + 0.15, y - 0.08, z + 0.085), 0.066, _CAT, 0.95)
    for side in (-1.0, 1.0):
        ear = (x + 0.14 + 0.02 * side, y - 0.075 + 0.035 * side, z + 0.15)
        room.box(ear, (0.02, 0.04, 0.05), "#b96f33", PAINTED, turn_about((1.0, 0.0, 0.0), 25.0 * side))
    room.rod((x - 0.02, y - 0.14, z + 0.02), (x + 0.10, y - 0.17, z + 0.02), 0.024, "#b96f33", 0.95)


def coffee_table(room: Carpentry, x: float = -0.45, y: float = -2.35) -> None:
    """Low, oak, with what an evening leaves on it."""
    room.box((x, y, 0.40), (1.05, 0.55, 0.04), "#c08a55", Finish(0.012, 0.4, material="wood"), yaw(4.0))
    room.box((x, y, 0.18), (0.9, 0.42, 0.02), "#a87442", WOOD, yaw(4.0))
    for sx in (-0.45, 0.45):
        for sy in (-0.2, 0.2):
            room.rod((x + sx, y + sy, 0.02), (x + sx * 0.94, y + sy * 0.94, 0.39), 0.02, "#6b4526")
    room.box((x - 0.2, y + 0.04, 0.427), (0.26, 0.19, 0.012), "#b5482a", PAINTED, yaw(12.0))
    room.box((x - 0.2, y + 0.04, 0.442), (0.24, 0.18, 0.016), "#3c6f7d", PAINTED, yaw(-6.0))
    room.rod((x + 0.22, y - 0.08, 0.46), (x + 0.22, y - 0.08, 0.49), 0.038, "#efe6d6", 0.3)
    room.rod((x + 0.265, y - 0.08, 0.465), (x + 0.265, y - 0.08, 0.485), 0.014, "#efe6d6", 0.3)
    room.box((x + 0.1, y + 0.14, 0.435), (0.16, 0.09, 0.03), "#2b2b31", Finish(0.014, 0.5), yaw(-30.0))
    for i, colour in enumerate(("#d9a23a", "#4d7571", "#e4d3b4", "#8c3b2c")):
        room.box((x - 0.1 + 0.03 * i, y, 0.205 + 0.014 * i), (0.3, 0.22, 0.013), colour, PAINTED, yaw(8.0 * i))
