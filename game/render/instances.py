"""Turns drawables into rows of float32 that the graphics card reads: one row an instance."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from game.drawables import MATERIALS, Boxes, Capsules, Layer, Lines, Points

Rows = NDArray[np.float32]
SOLID_FLOATS = 18
"""position 3, bevel, orientation 4 (w, x, y, z), half size 3, roughness, colour 4, emission, material."""
LINE_FLOATS = 11
"""start 3, end 3, colour 4, width in pixels at 720 lines; a point is a line from itself to itself."""
ROUND_BEVEL_M = 0.03
"""Wider bevels and thicker capsules are drawn with the finer mesh."""
_NONE: Rows = np.empty((0, SOLID_FLOATS), dtype=np.float32)


def box_rows(boxes: Boxes, opacity: float = 1.0) -> Rows:
    """Rows (N, 18) of boxes; raises ValueError for an unknown material."""
    if boxes.material not in MATERIALS:
        raise ValueError(f"there is no material {boxes.material!r}; valid: {', '.join(MATERIALS)}.")
    rows = np.empty((len(boxes.position), SOLID_FLOATS), dtype=np.float32)
    rows[:, 0:3] = boxes.position
    rows[:, 3] = boxes.bevel_m
    rows[:, 4:8] = boxes.orientation
    rows[:, 8:11] = boxes.half_size
    rows[:, 11] = boxes.roughness
    rows[:, 12:16] = boxes.colour
    rows[:, 16] = boxes.emission
    rows[:, 17] = MATERIALS.index(boxes.material)
    if boxes.inside_out:
        rows[:, 8:11] *= -1.0  # a point reflection turns every face inwards, winding included
    if opacity < 1.0:
        rows[:, 15] *= opacity
    return rows


def capsule_rows(capsules: Capsules, opacity: float = 1.0) -> Rows:
    """Rows (N, 18) of capsules, as boxes whose bevel is the radius."""
    start, end = np.asarray(capsules.start, dtype=np.float64), np.asarray(capsules.end, dtype=np.float64)
    radius = np.asarray(capsules.radius, dtype=np.float64)
    rows = np.zeros((len(start), SOLID_FLOATS), dtype=np.float32)
    way = end - start
    length = np.sqrt(np.einsum("ij,ij->i", way, way))
    ball = length < 1e-9
    way[ball] = (0.0, 0.0, 1.0)
    way /= np.where(ball, 1.0, length)[:, None]
    down = way[:, 2] < -0.999999
    # half-way quaternion from z to the axis: (1 + z . w, z x w); straight down turns about x
    half = np.stack([1.0 + way[:, 2], -way[:, 1], way[:, 0], np.zeros(len(way))], axis=1)
    half[down] = (0.0, 1.0, 0.0, 0.0)
    half /= np.sqrt(np.einsum("ij,ij->i", half, half))[:, None]
    rows[:, 0:3] = 0.5 * (start + end)
    rows[:, 3] = radius
    rows[:, 4:8] = half
    rows[:, 8] = rows[:, 9] = radius
    rows[:, 10] = radius + 0.5 * length
    rows[:, 11] = capsules.roughness
    rows[:, 12:16] = capsules.colour
    rows[:, 16] = capsules.emission
    if opacity < 1.0:
        rows[:, 15] *= opacity
    return rows


def line_rows(lines: Lines, opacity: float = 1.0) -> Rows:
    """Rows (N, 11) of line segments."""
    rows = np.empty((len(lines.points), LINE_FLOATS), dtype=np.float32)
    rows[:, 0:3] = lines.points[:, 0]
    rows[:, 3:6] = lines.points[:, 1]
    rows[:, 6:10] = lines.colour
    rows[:, 9] *= opacity
    rows[:, 10] = lines.width_px
    return rows


def point_rows(points: Points, opacity: float = 1.0) -> Rows:
    """Rows (N, 11) of points."""
    rows = np.empty((len(points.position), LINE_FLOATS), dtype=np.float32)
    rows[:, 0:3] = rows[:, 3:6] = points.position
    rows[:, 6:10] = points.colour
    rows[:, 9] *= opacity
    rows[:, 10] = points.diameter_px
    return rows


@dataclass
class Packed:
    """Everything of some layers as rows. Solids that cast a shadow come first in each array, `casters` says how many."""

    edged: Rows = field(default_factory=lambda: _NONE)
    edged_casters: int = 0
    round: Rows = field(default_factory=lambda: _NONE)
    round_casters: int = 0
    ghosts: Rows = field(default_factory=lambda: _NONE)
    strokes: Rows = field(default_factory=lambda: np.empty((0, LINE_FLOATS), dtype=np.float32))
    strokes_on_top: Rows = field(default_factory=lambda: np.empty((0, LINE_FLOATS), dtype=np.float32))


def pack(layers: tuple[Layer, ...]) -> Packed:
    """Rows of all drawables of the layers; labels belong to the overlay and are passed over."""
    names = ("edged", "edged_more", "round", "round_more", "ghosts", "strokes", "strokes_on_top")
    bins: dict[str, list[Rows]] = {name: [] for name in names}
    for layer in layers:
        for item in layer.drawables:
            _sort_in(item, layer.opacity, bins)
    packed = Packed()
    packed.edged_casters = sum(map(len, bins["edged"]))
    packed.round_casters = sum(map(len, bins["round"]))
    packed.edged = _join(bins["edged"] + bins["edged_more"], packed.edged)
    packed.round = _join(bins["round"] + bins["round_more"], packed.round)
    packed.ghosts = _join(bins["ghosts"], packed.ghosts)
    packed.strokes = _join(bins["strokes"], packed.strokes)
    packed.strokes_on_top = _join(bins["strokes_on_top"], packed.strokes_on_top)
    return packed


def _sort_in(item: object, opacity: float, bins: dict[str, list[Rows]]) -> None:
    if isinstance(item, Boxes | Capsules):
        rows = box_rows(item, opacity) if isinstance(item, Boxes) else capsule_rows(item, opacity)
        if opacity < 1.0:
            bins["ghosts"].append(rows)
            return
        more = "" if item.casts_shadow else "_more"
        if isinstance(item, Boxes):
            bins[("edged" if item.bevel_m <= ROUND_BEVEL_M else "round") + more].append(rows)
            return
        thick = rows[:, 3] > ROUND_BEVEL_M
        bins["edged" + more].append(rows[~thick])
        bins["round" + more].append(rows[thick])
    elif isinstance(item, Lines):
        bins["strokes_on_top" if item.on_top else "strokes"].append(line_rows(item, opacity))
    elif isinstance(item, Points):
        bins["strokes"].append(point_rows(item, opacity))


def _join(parts: list[Rows], empty: Rows) -> Rows:
    if len(parts) > 1:
        return np.concatenate(parts)
    return parts[0] if parts else empty
