"""The television on its cabinet with the Kinect on top: what the character faces."""

from game.scenes.room.carpentry import METAL, PAINTED, WOOD, Carpentry, Finish, turn_about
from game.scenes.room.walls import FRONT_X

_BLACK = Finish(0.006, 0.35)
_GLOSSY = Finish(0.012, 0.18)
_SCREEN = Finish(0.0, 0.15, emission=1.4, material="screen", casts_shadow=False)


def television(room: Carpentry, x: float = 2.85) -> None:
    """Cabinet, set, sound bar, console, and the Kinect."""
    _cabinet(room, x)
    room.box((x + 0.02, 0.0, 0.50), (0.24, 0.5, 0.012), "#1c1c20", _BLACK)
    room.box((x + 0.05, 0.0, 0.56), (0.04, 0.12, 0.12), "#1c1c20", _BLACK)
    room.box((x + 0.04, 0.0, 0.93), (0.05, 1.26, 0.73), "#151518", _BLACK)
    room.box((x + 0.0142, 0.0, 0.935), (0.001, 1.22, 0.68), "#ffffff", _SCREEN)
    room.box((x - 0.08, 0.0, 0.525), (0.09, 0.8, 0.06), "#26262b", Finish(0.02, 0.7, material="fabric"))
    kinect(room, x + 0.04, 0.0, 1.295)


def _cabinet(room: Carpentry, x: float) -> None:
    room.box((x, 0.0, 0.30), (0.42, 1.9, 0.36), "#b07c48", Finish(0.01, 0.4, material="wood"))
    room.box((x, 0.0, 0.485), (0.45, 1.96, 0.03), "#c08a55", Finish(0.01, 0.35, material="wood"))
    for y in (-0.64, 0.64):
        room.box((x - 0.205, y, 0.30), (0.02, 0.58, 0.30), "#c8a06a", WOOD)
        room.rod((x - 0.225, y - 0.05, 0.36), (x - 0.225, y + 0.05, 0.36), 0.008, "#3a2a1c", 0.3)
    room.box((x - 0.19, 0.0, 0.30), (0.03, 0.6, 0.30), "#3a2616", WOOD)
    room.box((x - 0.19, 0.08, 0.21), (0.05, 0.34, 0.07), "#e8e4dc", _GLOSSY)
    room.box((x - 0.217, 0.19, 0.21), (0.003, 0.03, 0.008), "#7cff8a", Finish(0.0, 0.5, emission=3.0, casts_shadow=False))
    for side in (-0.85, 0.85):
        for depth in (-0.14, 0.14):
            room.rod((x + depth, side, 0.02), (x + depth, side, 0.12), 0.02, "#3a2a1c")
        room.box((x + 0.02, side * 1.02, 0.68), (0.2, 0.18, 0.34), "#3a2a1c", Finish(0.015, 0.5, material="wood"))
        for z, radius in ((0.62, 0.062), (0.76, 0.032)):
            room.rod((x - 0.075, side * 1.02, z), (x - 0.06, side * 1.02, z), radius, "#1c1c20", 0.8)


def kinect(room: Carpentry, x: float, y: float, z: float) -> None:
    """The sensor, z is its foot: base, neck with the motor, the bar with three lenses and the green light."""
    tip = turn_about((0.0, 1.0, 0.0), 4.0)
    room.box((x, y, z + 0.010), (0.075, 0.085, 0.020), "#17171a", _GLOSSY)
    room.box((x, y, z + 0.032), (0.034, 0.040, 0.030), "#17171a", _GLOSSY)
    room.box((x, y, z + 0.066), (0.064, 0.282, 0.040), "#17171a", _GLOSSY, tip)
    for at, radius, glass in ((-0.060, 0.0135, "#5a1015"), (0.018, 0.0135, "#1a2440"), (0.048, 0.0135, "#401018")):
        room.rod((x - 0.026, y + at, z + 0.067), (x - 0.026, y + at, z + 0.067), radius, "#2c2c32", 0.25)
        room.rod((x - 0.035, y + at, z + 0.067), (x - 0.035, y + at, z + 0.067), radius * 0.62, glass, 0.12)
    room.rod((x - 0.032, y - 0.012, z + 0.066), (x - 0.032, y - 0.012, z + 0.066), 0.0042, "#40ff60", 0.3, 8.0, shadow=False)


def front_wall(room: Carpentry) -> None:
    """What hangs and stands behind the television."""
    x = FRONT_X - 0.03
    for y, z, width, height in ((-1.75, 1.55, 0.6, 0.8), (1.75, 1.6, 0.5, 0.5)):
        room.box((x, y, z), (0.035, width, height), "#3a2a1c", Finish(0.006, 0.4, material="wood"))
        room.box((x - 0.018, y, z), (0.006, width - 0.05, height - 0.05), "#ffffff", Finish(0.0, 0.7, material="painting"))
    for z, width in ((1.75, 1.3), (2.1, 0.9)):
        room.box((x - 0.09, 0.0, z), (0.2, width, 0.03), "#b07c48", WOOD)
    books = ((-0.5, 0.24, "#8c3b2c"), (-0.45, 0.2, "#e4d3b4"), (-0.4, 0.26, "#3c6f7d"), (-0.35, 0.22, "#d9a23a"))
    for i, (y, tall, colour) in enumerate(books):
        room.box((x - 0.09, y, 1.765 + tall / 2), (0.17, 0.04 - 0.004 * (i % 2), tall), colour, PAINTED)
    room.rod((x - 0.09, 0.1, 1.83), (x - 0.09, 0.1, 1.86), 0.06, "#c96f3f", 0.5)
    room.box((x - 0.09, 0.45, 1.83), (0.12, 0.14, 0.13), "#4d7571", Finish(0.03, 0.6))
    room.box((x - 0.09, 0.15, 2.19), (0.1, 0.22, 0.15), "#e0b34c", METAL)
    room.rod((x - 0.09, -0.25, 2.17), (x - 0.09, -0.25, 2.17), 0.055, "#b5482a", 0.4)
