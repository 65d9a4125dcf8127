"""Dresses a body plan: its fifteen boxes in colour, balls in the joints, and the trim of the wardrobe, posed with the parts."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.body_plan import BodyPlan
from game.characters.skeleton import PARTS
from game.drawables import Boxes, Capsules, Drawable
from game.scenes.palette import paint
from game.scenes.wardrobe import COSTUMES, Costume, Surface, Trim

Floats = NDArray[np.float64]

_SURFACES: dict[Surface, tuple[float, float, float]] = {
    "shell": (0.016, 0.42, 0.0),
    "soft": (0.006, 0.75, 0.0),
    "gloss": (0.012, 0.14, 0.0),
    "glow": (0.006, 0.4, 2.4),
}
"""Bevel (m), roughness and emission of each kind of trim."""
_BODY_BEVEL_M, _BODY_ROUGHNESS = 0.022, 0.48
_COOL, _WARM, _HOT = paint("#3b6fb5"), paint("#f0c23c"), paint("#d42a1e")


@dataclass(frozen=True)
class _Trimmings:
    """All trim of a costume cut to a plan, in the parts' frames: part (N,), place (N, 3), turn (N, 4), half_size (N, 3), colour (N, 4).

    slices: which rows are of which surface.
    """

    part: NDArray[np.intp]
    place: Floats
    turn: Floats
    half_size: Floats
    colour: Floats
    slices: tuple[tuple[Surface, slice], ...]


def costume_of(index: int) -> Costume:
    """The costume of fighter 0, 1, ...; more fighters than costumes share."""
    return COSTUMES[index % len(COSTUMES)]


def dress(part_names: Sequence[str], index: int = 0) -> Floats:
    """Colours (N, 4) of parts by name, such as "upper_arm_left"."""
    return _dress(tuple(part_names), index % len(COSTUMES)).copy()


@lru_cache(maxsize=16)
def _dress(part_names: tuple[str, ...], index: int) -> Floats:
    colours = costume_of(index).parts
    return np.array([paint(colours[name.removesuffix("_left").removesuffix("_right")]) for name in part_names])


def tint(load: Floats) -> Floats:
    """Loads (N,) of 0..1 as colours (N, 4): blue at rest, yellow half-way, red at the limit."""
    share = np.clip(np.asarray(load, dtype=np.float64), 0.0, 1.0)
    stops = np.array([_COOL, _WARM, _HOT])
    return np.stack([np.interp(share, (0.0, 0.5, 1.0), stops[:, channel]) for channel in range(4)], axis=1)


def dressed(plan: BodyPlan, position: Floats, orientation: Floats, index: int = 0, colours: Floats | None = None) -> tuple[Drawable, ...]:
    """A posed fighter: box centres (15, 3), unit quaternions (15, 4). `colours` (15, 4) replace the costume's, and leave off its trim."""
    matrices = rotation.matrix(orientation)
    shown = _dress(PARTS, index % len(COSTUMES)) if colours is None else colours
    tailored = _tailor(_Key(plan), index % len(COSTUMES))
    trim = tailored.trim
    place = position[trim.part] + rotation.turn(matrices[trim.part], trim.place)
    turn = rotation.multiply(orientation[trim.part], trim.turn)
    drawables: list[Drawable] = [Boxes(position, orientation, plan.size / 2.0, shown, bevel_m=_BODY_BEVEL_M, roughness=_BODY_ROUGHNESS)]
    start = position[tailored.rod_part[0]] + rotation.turn(matrices[tailored.rod_part[0]], tailored.rod_start)
    end = position[tailored.rod_part[1]] + rotation.turn(matrices[tailored.rod_part[1]], tailored.rod_end)
    drawables.append(Capsules(start, end, tailored.rod_radius, tailored.rod_colour, roughness=0.7))
    for surface, rows in trim.slices:
        if colours is None or surface in ("gloss", "glow"):
            bevel, roughness, emission = _SURFACES[surface]
            half, colour = trim.half_size[rows], trim.colour[rows]
            drawables.append(Boxes(place[rows], turn[rows], half, colour, bevel, roughness, emission, casts_shadow=surface != "glow"))
    return tuple(drawables)


@dataclass(frozen=True)
class _Tailored:
    """Trim, and rods (M, 3) from a place on one part to a place on another: balls in the joints, and the neck."""

    trim: _Trimmings
    rod_part: tuple[NDArray[np.intp], NDArray[np.intp]]
    rod_start: Floats
    rod_end: Floats
    rod_radius: Floats
    rod_colour: Floats


class _Key:
    """A body plan as a key of the cache: the same object, whatever arrays it holds."""

    def __init__(self, plan: BodyPlan) -> None:
        self.plan = plan

    def __hash__(self) -> int:
        return id(self.plan)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Key) and other.plan is self.plan


@lru_cache(maxsize=16)
def _tailor(key: _Key, index: int) -> _Tailored:
    plan, costume = key.plan, costume_of(index)
    trunk, head, count = PARTS.index("trunk"), PARTS.index("head"), len(PARTS)
    part = np.arange(1, count)
    radius = 0.40 * plan.size[1:, :2].min(axis=1)
    for name, share in (("head", 0.3), ("upper_arm_left", 0.2), ("upper_arm_right", 0.2)):  # inside neck and shoulder pads
        radius[PARTS.index(name) - 1] = share * plan.size[PARTS.index(name), 1]
    ball = -plan.centre_offset[1:]
    up = np.array([0.0, 0.0, 1.0])
    return _Tailored(
        _cut(costume.trim, plan.size / 2.0),
        (np.append(part, trunk), np.append(part, head)),
        np.vstack((ball, 0.46 * plan.size[trunk, 2] * up)),
        np.vstack((ball, -0.42 * plan.size[head, 2] * up)),
        np.append(radius, 0.30 * plan.size[head, 1]),
        np.tile(paint(costume.joints), (count, 1)),
    )


def _cut(trims: Sequence[Trim], half: Floats) -> _Trimmings:
    trims = [trim for surface in _SURFACES for trim in trims if trim.surface == surface]
    surfaces = [trim.surface for trim in trims]
    slices: list[tuple[Surface, slice]] = [
        (s, slice(surfaces.index(s), surfaces.index(s) + surfaces.count(s))) for s in _SURFACES if s in surfaces
    ]
    part = np.array([PARTS.index(trim.part) for trim in trims])
    tilt = np.radians([trim.tilt_deg for trim in trims]) / 2.0
    turn = np.zeros((len(trims), 4))
    turn[:, 0], turn[:, 1] = np.cos(tilt), np.sin(tilt)
    return _Trimmings(
        part,
        half[part] * np.array([trim.at for trim in trims]),
        turn,
        half[part] * np.array([trim.size for trim in trims]) + np.array([trim.grow_m for trim in trims]),
        np.array([paint(trim.colour) for trim in trims]),
        tuple(slices),
    )
