"""A polar plot of how hard a character may be pushed from each direction, seen from above: front up, its left on the left."""

import math
from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

SIZE_PX, SHARPER = 900, 3
"""Of the picture; it is drawn so many times larger and scaled down."""

GROUND, RING, INK, FILL, EDGE = "#f7f4ee", "#d5cfc3", "#2b2a28", "#e9a15b", "#b4551a"
RING_NS = 20.0


def polar_plot(path: Path, title: str, direction_deg: Sequence[float], impulse_ns: Sequence[float]) -> None:
    """Write a PNG: directions counterclockwise from the front, impulses in N s; raises OSError where it cannot be written."""
    size = SIZE_PX * SHARPER
    picture = Image.new("RGB", (size, size), GROUND)
    draw = ImageDraw.Draw(picture)
    outer = max(RING_NS, RING_NS * math.ceil(max(impulse_ns, default=0.0) / RING_NS))
    middle, reach = (0.5 * size, 0.53 * size), 0.36 * size
    points = [_at(middle, reach * ns / outer, angle) for angle, ns in zip(direction_deg, impulse_ns, strict=True)]
    draw.polygon(points, fill=FILL)
    for ring in range(1, round(outer / RING_NS) + 1):
        r = reach * ring * RING_NS / outer
        draw.ellipse((middle[0] - r, middle[1] - r, middle[0] + r, middle[1] + r), outline=RING, width=SHARPER)
    for angle in direction_deg:
        draw.line((*middle, *_at(middle, reach, angle)), fill=RING, width=SHARPER)
    draw.line([*points, points[0]], fill=EDGE, width=3 * SHARPER, joint="curve")
    _label_rings(draw, middle, reach, outer)
    words, small = _font(0.026), _font(0.02)
    for angle, ns, (x, y) in zip(direction_deg, impulse_ns, points, strict=True):
        r = 0.008 * size
        draw.ellipse((x - r, y - r, x + r, y + r), fill=EDGE)
        draw.text(_at(middle, 1.13 * reach, angle), f"{ns:.0f}", fill=INK, font=words, anchor="mm")
    draw.text((0.5 * size, 0.05 * size), title, fill=INK, font=words, anchor="mm")
    caption = "N s at the chest for 0.2 s, recovered from; the push goes where the number stands, the character faces up"
    draw.text((0.5 * size, 0.97 * size), caption, fill=INK, font=small, anchor="mm")
    picture.resize((SIZE_PX, SIZE_PX), Image.Resampling.LANCZOS).save(path)


def _label_rings(draw: ImageDraw.ImageDraw, middle: tuple[float, float], reach: float, outer: float) -> None:
    for ring in range(1, round(outer / RING_NS) + 1):
        where = _at(middle, reach * ring * RING_NS / outer, -22.5)
        draw.text(where, f"{ring * RING_NS:.0f}", fill=INK, font=_font(0.017), anchor="mm")


def _at(middle: tuple[float, float], radius: float, angle_deg: float) -> tuple[float, float]:
    """The place in the picture of a direction: 0 up, 90 (the character's left) to the left."""
    angle = math.radians(angle_deg)
    return middle[0] - radius * math.sin(angle), middle[1] - radius * math.cos(angle)


def _font(share: float) -> ImageFont.ImageFont | ImageFont.FreeTypeFont:
    return ImageFont.load_default(share * SIZE_PX * SHARPER)
