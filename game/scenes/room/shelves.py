"""A bookcase with books of every size, a sideboard of records, and what people put between them."""

import random

from game.scenes.room.carpentry import PAINTED, WOOD, Carpentry, Finish, turn_about

_SPINES = ("#8c3b2c", "#d9a23a", "#3c6f7d", "#e4d3b4", "#5a6b3f", "#2f3f5c", "#c96f3f", "#6b4a63", "#b9b08f", "#24424a")
_BOOK = Finish(0.004, 0.7)
_CASE = "#b07c48"


def bookcase(room: Carpentry, x: float = -3.12, y: float = 2.32, width: float = 1.25, height: float = 2.0) -> None:
    """Stands against the wall behind the character, to its left."""
    depth, board = 0.30, 0.03
    for side in (-0.5, 0.5):
        room.box((x, y + side * width, height / 2), (depth, board, height), _CASE, WOOD)
    shelves = [0.06 + i * (height - 0.09) / 5 for i in range(6)]
    for z in shelves:
        room.box((x, y, z), (depth - 0.01, width, board), _CASE, WOOD)
    room.box((x - depth / 2 + 0.01, y, height / 2), (0.015, width, height), "#8a5c33", WOOD)
    chance = random.Random(7)
    for level, z in enumerate(shelves[:-1]):
        _fill(room, chance, level, (x, y - width / 2 + 0.03, z + board / 2), width - 0.06)
    _on_top(room, x, y, height)


def _fill(room: Carpentry, chance: random.Random, level: int, corner: tuple[float, float, float], width: float) -> None:
    x, y, z = corner
    at, gap = 0.0, (0.30, 0.62, 0.10, 0.48, 0.74)[level] * width
    while at < width - 0.06:
        if gap is not None and at >= gap:
            _keepsake(room, level, (x + 0.03, y + at + 0.12, z))
            at, gap = at + 0.26, None
            continue
        thick, tall, deep = chance.uniform(0.022, 0.05), chance.uniform(0.20, 0.30), chance.uniform(0.15, 0.21)
        tilt = turn_about((1.0, 0.0, 0.0), chance.choice((0.0, 0.0, 0.0, 0.0, -7.0)))
        place = (x + 0.14 - deep / 2 - chance.uniform(0.0, 0.02), y + at + thick / 2, z + tall / 2)
        room.box(place, (deep, thick, tall), chance.choice(_SPINES), _BOOK, tilt)
        at += thick + (0.03 if tilt[0] < 1.0 else 0.003)


def _keepsake(room: Carpentry, level: int, at: tuple[float, float, float]) -> None:
    x, y, z = at
    if level == 0:
        room.box((x, y, z + 0.12), (0.2, 0.22, 0.22), "#c9a877", Finish(0.02, 0.95, material="fabric"))
    elif level == 1:
        room.rod((x, y, z + 0.06), (x, y, z + 0.10), 0.06, "#d8c6a4", 0.4)
        room.rod((x, y, z + 0.17), (x, y, z + 0.19), 0.03, "#d8c6a4", 0.4)
    elif level == 2:
        room.rod((x, y, z + 0.11), (x, y, z + 0.11), 0.09, "#3c6f7d", 0.35)
        room.box((x, y, z + 0.01), (0.1, 0.1, 0.02), "#6b4526", WOOD)
    elif level == 3:
        room.box((x, y, z + 0.10), (0.02, 0.16, 0.2), "#2b2b31", PAINTED)
        room.box((x + 0.011, y, z + 0.10), (0.004, 0.13, 0.17), "#ffffff", Finish(0.0, 0.6, material="painting"))
    else:
        room.box((x, y, z + 0.02), (0.09, 0.09, 0.04), "#4a3220", WOOD)
        room.rod((x, y, z + 0.05), (x, y, z + 0.10), 0.012, "#e0b34c", 0.2)
        room.rod((x, y, z + 0.15), (x, y, z + 0.18), 0.045, "#e0b34c", 0.2)


def _on_top(room: Carpentry, x: float, y: float, height: float) -> None:
    room.box((x, y - 0.36, height + 0.10), (0.24, 0.36, 0.18), "#d8c6a4", Finish(0.02, 0.95, material="fabric"))
    room.box((x, y + 0.18, height + 0.075), (0.15, 0.15, 0.12), "#c96f3f", Finish(0.03, 0.8))
    for i in range(9):
        way = (0.10 * ((i * 5) % 9 - 4) / 4, 0.12 * ((i * 7) % 9 - 4) / 4)
        tip = (x + way[0] + 0.06, y + 0.18 + way[1], height + 0.24 + 0.012 * (i % 4))
        room.rod((x, y + 0.18, height + 0.13), tip, 0.013, "#54803f", 0.8)


def side_wall(room: Carpentry, y: float = -3.17) -> None:
    """Above the coffee table: a large painting, and a board with a radio and a plant."""
    art = Finish(0.0, 0.7, material="painting")
    for x, z, width, height in ((-1.05, 1.62, 0.72, 0.92), (-0.2, 1.86, 0.46, 0.46)):
        room.box((x, y, z), (width, 0.035, height), "#3a2a1c", Finish(0.006, 0.4, material="wood"))
        room.box((x, y + 0.018, z), (width - 0.05, 0.006, height - 0.05), "#ffffff", art)
    room.box((-0.15, y + 0.09, 1.36), (0.85, 0.2, 0.03), _CASE, WOOD)
    room.box((-0.33, y + 0.09, 1.45), (0.30, 0.12, 0.16), "#4d7571", Finish(0.025, 0.5))
    room.box((-0.39, y + 0.152, 1.45), (0.13, 0.01, 0.11), "#d8c6a4", Finish(0.004, 0.9, material="fabric"))
    room.rod((-0.25, y + 0.15, 1.45), (-0.25, y + 0.16, 1.45), 0.024, "#e0b34c", 0.3)
    room.box((0.12, y + 0.10, 1.43), (0.12, 0.12, 0.11), "#e4d3b4", Finish(0.028, 0.7))
    for i in range(8):
        away = (0.06 * ((i * 5) % 8 - 3.5) / 3.5, 0.03 + 0.04 * ((i * 3) % 8) / 8)
        room.rod((0.12, y + 0.10, 1.47), (0.12 + away[0] * 2.2, y + 0.10 + away[1], 1.60 - 0.05 * (i % 4)), 0.012, "#4f8040", 0.8)


def wall_pictures(room: Carpentry, x: float = -3.27) -> None:
    """Three paintings above the sofa."""
    for y, z, width, height in ((-1.62, 1.70, 0.50, 0.64), (-0.98, 1.64, 0.54, 0.54), (0.55, 1.75, 0.56, 0.72)):
        room.box((x, y, z), (0.035, width, height), "#3a2a1c", Finish(0.006, 0.4, material="wood"))
        room.box((x + 0.018, y, z), (0.006, width - 0.05, height - 0.05), "#ffffff", Finish(0.0, 0.7, material="painting"))
