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
    "glow": (0.006, 0.4, 4.5),
}
"""Bevel (m), roughness and emission of each kind of trim."""
_BODY_BEVEL_M, _BODY_ROUGHNESS = 0.022, 0.48
_COOL, _WARM, _HOT = paint("#3b6fb5"), paint("#f0c23c"), paint("#d42a1e")


@dataclass(frozen=True)
class _Piece:
    """Trim of one surface: part (N,) indices, and place (N, 3), turn (N, 4), half_size (N, 3), colour (N, 4) in the parts' frames."""

    surface: Surface
    part: NDArray[np.intp]
    place: Floats
    turn: Floats
    half_size: Floats
    colour: Floats


def costume_of(index: int) -> Costume:
    """The costume of fighter 0, 1, ...; more fighters than costumes share."""
    return COSTUMES[index % len(COSTUMES)]


def dress(part_names: Sequence[str], index: int = 0) -> Floats:
    """Colours (N, 4) of parts by name, such as "upper_arm_left"."""
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
    shown = dress(PARTS, index) if colours is None else colours
    drawables: list[Drawable] = [Boxes(position, orientation, plan.size / 2.0, shown, bevel_m=_BODY_BEVEL_M, roughness=_BODY_ROUGHNESS)]
    joints = position - rotation.turn(matrices, plan.centre_offset)
    radius, colour = _joint_balls(plan, index)
    drawables.append(Capsules(joints[1:], joints[1:], radius, colour, roughness=0.7))
    drawables.append(_neck(plan, position, matrices, joints, index))
    for piece in _tailored(plan, index):
        if colours is not None and piece.surface not in ("gloss", "glow"):
            continue
        bevel, roughness, emission = _SURFACES[piece.surface]
        place = position[piece.part] + rotation.turn(matrices[piece.part], piece.place)
        turn = rotation.multiply(orientation[piece.part], piece.turn)
        drawables.append(Boxes(place, turn, piece.half_size, piece.colour, bevel, roughness, emission, casts_shadow=piece.surface != "glow"))
    return tuple(drawables)


@lru_cache(maxsize=16)
def _cached_tailoring(name: str, sizes: bytes, index: int) -> tuple[_Piece, ...]:
    half = np.frombuffer(sizes, dtype=np.float64).reshape(-1, 3) / 2.0
    trims = costume_of(index).trim
    surfaces = [surface for surface in _SURFACES if any(trim.surface == surface for trim in trims)]
    return tuple(_cut([trim for trim in trims if trim.surface == surface], surface, half) for surface in surfaces)


def _tailored(plan: BodyPlan, index: int) -> tuple[_Piece, ...]:
    return _cached_tailoring(plan.name, np.ascontiguousarray(plan.size, dtype=np.float64).tobytes(), index % len(COSTUMES))


def _cut(trims: Sequence[Trim], surface: Surface, half: Floats) -> _Piece:
    part = np.array([PARTS.index(trim.part) for trim in trims])
    tilt = np.radians([trim.tilt_deg for trim in trims]) / 2.0
    turn = np.zeros((len(trims), 4))
    turn[:, 0], turn[:, 1] = np.cos(tilt), np.sin(tilt)
    return _Piece(
        surface,
        part,
        half[part] * np.array([trim.at for trim in trims]),
        turn,
        half[part] * np.array([trim.size for trim in trims]) + np.array([trim.grow_m for trim in trims]),
        np.array([paint(trim.colour) for trim in trims]),
    )


@lru_cache(maxsize=16)
def _balls(sizes: bytes, index: int) -> tuple[Floats, Floats]:
    size = np.frombuffer(sizes, dtype=np.float64).reshape(-1, 3)
    radius = 0.40 * size[1:, :2].min(axis=1)
    for name, share in (("head", 0.3), ("upper_arm_left", 0.2), ("upper_arm_right", 0.2)):  # inside neck and shoulder pads
        radius[PARTS.index(name) - 1] = share * size[PARTS.index(name), 1]
    return radius, np.tile(paint(costume_of(index).joints), (len(radius), 1))


def _joint_balls(plan: BodyPlan, index: int) -> tuple[Floats, Floats]:
    return _balls(np.ascontiguousarray(plan.size, dtype=np.float64).tobytes(), index % len(COSTUMES))


def _neck(plan: BodyPlan, position: Floats, matrices: Floats, joints: Floats, index: int) -> Capsules:
    """From the top of the trunk to the head."""
    trunk, head = PARTS.index("trunk"), PARTS.index("head")
    base = position[trunk] + matrices[trunk][:, 2] * plan.size[trunk, 2] * 0.46
    top = position[head] - matrices[head][:, 2] * plan.size[head, 2] * 0.42
    radius = np.array([0.30 * plan.size[head, 1]])
    return Capsules(base[None], top[None], radius, np.array([paint(costume_of(index).joints)]), roughness=0.7)
