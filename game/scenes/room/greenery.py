"""House plants: leaves are thin boxes with round edges, set around a stem by the golden angle."""

import math

from game.scenes.room.carpentry import Carpentry, Finish, compose, turn_about, yaw

_LEAF = Finish(0.006, 0.55)
_GREENS = ("#3f6b35", "#4f8040", "#356032", "#5f8f45")
_GOLDEN_DEG = 137.508


def big_plant(room: Carpentry, x: float, y: float, height: float = 1.45, leaves: int = 30, pot: str = "#c8653a") -> None:
    """A rubber tree in a clay pot."""
    room.box((x, y, 0.17), (0.36, 0.36, 0.32), pot, Finish(0.09, 0.85))
    room.box((x, y, 0.325), (0.40, 0.40, 0.06), pot, Finish(0.028, 0.85))
    room.rod((x, y, 0.3), (x + 0.02, y + 0.02, height * 0.9), 0.016, "#5b4630", 0.9)
    for i in range(leaves):
        t = i / (leaves - 1)
        z = 0.5 + t * (height - 0.5)
        length = 0.34 - 0.13 * t
        pitch = 8.0 - 62.0 * t + 10.0 * math.sin(i * 1.7)
        around = i * _GOLDEN_DEG
        reach = (0.05 + length * 0.52) * math.cos(math.radians(pitch))
        centre = (
            x + reach * math.cos(math.radians(around)),
            y + reach * math.sin(math.radians(around)),
            z - (0.05 + length * 0.52) * math.sin(math.radians(pitch)),
        )
        turn = compose(yaw(around), compose(turn_about((0.0, 1.0, 0.0), pitch), turn_about((1.0, 0.0, 0.0), 12.0 * math.sin(i * 2.3))))
        room.box(centre, (length, 0.15 - 0.05 * t, 0.012), _GREENS[i % 4], _LEAF, turn)
        room.rod((x, y, z), centre, 0.006, "#4f6f3a", 0.8, shadow=False)


def grass_plant(room: Carpentry, x: float, y: float, z: float = 0.0, blades: int = 22, length: float = 0.75, pot: str = "#e8dcc8") -> None:
    """Long arching blades in a pale pot."""
    room.box((x, y, z + 0.13), (0.26, 0.26, 0.26), pot, Finish(0.07, 0.6))
    for i in range(blades):
        around = math.radians(i * _GOLDEN_DEG)
        out = (0.35 + 0.65 * ((i * 7) % blades) / blades) * length * 0.55
        low = (x, y, z + 0.24)
        middle = (x + 0.4 * out * math.cos(around), y + 0.4 * out * math.sin(around), z + 0.24 + 0.75 * (length - 0.3 * out))
        tip = (x + out * math.cos(around), y + out * math.sin(around), middle[2] + 0.06 - 0.35 * out)
        room.rod(low, middle, 0.009, _GREENS[i % 4], 0.7)
        room.rod(middle, tip, 0.007, _GREENS[(i + 1) % 4], 0.7)
