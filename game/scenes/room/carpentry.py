"""Builds furniture out of boxes and capsules, and sorts the pieces into as few drawables as possible."""

import math
from dataclasses import dataclass, field

import numpy as np

from game.drawables import Boxes, Capsules, Drawable
from game.scenes.palette import Colour, paint

Place = tuple[float, float, float]
Turn = tuple[float, float, float, float]
UPRIGHT: Turn = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Finish:
    """How a surface looks and feels; see game.drawables.Boxes."""

    bevel_m: float = 0.008
    roughness: float = 0.6
    emission: float = 0.0
    material: str = "plain"
    casts_shadow: bool = True
    inside_out: bool = False


WOOD = Finish(0.006, 0.45, material="wood")
PAINTED = Finish(0.006, 0.5)
CLOTH = Finish(0.05, 0.95, material="fabric")
METAL = Finish(0.004, 0.3)


def turn_about(axis: Place, degrees: float) -> Turn:
    """Unit quaternion (w, x, y, z) of a rotation about a unit axis."""
    half = math.radians(degrees) / 2.0
    s = math.sin(half)
    return (math.cos(half), axis[0] * s, axis[1] * s, axis[2] * s)


def yaw(degrees: float) -> Turn:
    """Rotation about the vertical."""
    return turn_about((0.0, 0.0, 1.0), degrees)


def compose(a: Turn, b: Turn) -> Turn:
    """First b, then a."""
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


@dataclass
class Carpentry:
    """Collects pieces; `drawables` hands them over."""

    _boxes: dict[Finish, list[tuple[Place, Turn, Place, Colour]]] = field(default_factory=dict)
    _rods: dict[tuple[float, float, bool], list[tuple[Place, Place, float, Colour]]] = field(default_factory=dict)

    def box(self, centre: Place, size: Place, colour: str, finish: Finish = PAINTED, turn: Turn = UPRIGHT) -> None:
        """A box with edge lengths `size` (m), turned about its centre; colour "#rrggbb"."""
        half = (size[0] / 2.0, size[1] / 2.0, size[2] / 2.0)
        self._boxes.setdefault(finish, []).append((centre, turn, half, paint(colour)))

    def rod(
        self, start: Place, end: Place, radius: float, colour: str, roughness: float = 0.5, emission: float = 0.0, shadow: bool = True
    ) -> None:
        """A round bar; from a place to itself it is a ball."""
        self._rods.setdefault((roughness, emission, shadow), []).append((start, end, radius, paint(colour)))

    def drawables(self) -> tuple[Drawable, ...]:
        """One drawable for each finish, in the order of first use."""
        made: list[Drawable] = []
        for finish, pieces in self._boxes.items():
            place, turn, half, colour = (np.array(column, dtype=np.float64) for column in zip(*pieces, strict=True))
            made.append(
                Boxes(
                    *(place, turn, half, colour),
                    bevel_m=finish.bevel_m,
                    roughness=finish.roughness,
                    emission=finish.emission,
                    casts_shadow=finish.casts_shadow,
                    material=finish.material,
                    inside_out=finish.inside_out,
                )
            )
        for (roughness, emission, shadow), rods in self._rods.items():
            start, end, radius, colour = (np.array(column, dtype=np.float64) for column in zip(*rods, strict=True))
            made.append(Capsules(start, end, radius, colour, roughness, emission, shadow))
        return tuple(made)
