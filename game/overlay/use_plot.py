"""Torque use: a bar for each joint, left and right beside each other, and the joint that uses most of its strength by name."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from game.overlay.sheet import Sheet
from game.overlay.style import ACCENT, COOL, FAINT, INK, WARN, Rgba, alpha
from game.scenes.scene import Plot

Floats = NDArray[np.float64]

TIGHT_PERCENT, FULL_PERCENT = 90.0, 110.0
"""From the first on a bar is red; at the second it is at the end of its room."""

NAMES_EM, FOOT_EM = 4.1, 3.0
SMALL, TINY = 0.7, 0.65
_EMPTY: Rgba = (1.0, 1.0, 1.0, 0.07)


@dataclass(frozen=True)
class _Rows:
    """Where the bars lie in a box, from its top left: the word and height of each row, the middle of each bar, thickness of a bar."""

    words: tuple[tuple[str, float], ...]
    middle: Floats
    thick: float
    left: NDArray[np.bool_]
    height: float


def draw_use(sheet: Sheet, plot: Plot, x: float, y: float, width: float, height: float) -> None:
    """A plot of kind "bars" into a box of the sheet. Its series: the present share and, as a mark, the most of late (% each)."""
    em = sheet.em
    rows = _rows(plot.names, height - FOOT_EM * em)
    start, room = x + NAMES_EM * em, width - NAMES_EM * em
    for word, down in rows.words:
        sheet.words(x, y + down - 0.42 * em, word, INK, SMALL)
    now, most = plot.series["now"][1], plot.series["most"][1]
    end = start + np.maximum(np.minimum(now / FULL_PERCENT, 1.0) * room, 1.0)
    mark = start + np.minimum(most / FULL_PERCENT, 1.0) * room
    middle, tight = y + rows.middle, now > TIGHT_PERCENT
    _draw_bars(sheet, start, start + room, middle, _EMPTY, rows.thick)
    for mine, colour in ((rows.left & ~tight, ACCENT), (~(rows.left | tight), COOL), (tight, WARN)):
        if mine.any():
            _draw_bars(sheet, start, end[mine], middle[mine], colour, rows.thick)
    _draw_bars(sheet, mark - 1.0, mark + 1.0, middle, alpha(INK, 0.8), rows.thick)
    full, bottom = start + room * 100.0 / FULL_PERCENT, y + rows.height
    sheet.line(full, y, full, bottom, alpha(INK, 0.5))
    sheet.words_to(min(full + 0.9 * em, x + width), bottom, "100 %", FAINT, TINY)
    sheet.words(start, bottom, "0", FAINT, TINY)
    worst = int(now.argmax())
    sheet.words(x, bottom + 0.9 * em, "most:", FAINT, SMALL)
    sheet.words(
        x + 2.2 * em, bottom + 0.9 * em, f"{plot.names[worst]} {now[worst]:.0f} %", WARN if tight[worst] else INK, SMALL, strong=True
    )
    right = x
    for text, colour in (("left", ACCENT), ("right", COOL), ("mark: most in 10 s", FAINT)):
        sheet.words(right, bottom + 1.85 * em, text, colour, SMALL)
        right += sheet.width(text, SMALL) + 0.5 * em


def _draw_bars(sheet: Sheet, start: Floats | float, end: Floats | float, middle: Floats, colour: Rgba, thick: float) -> None:
    """All of one colour as one interrupted curve that is as thick as a bar."""
    across = np.full((len(middle), 3), np.nan)
    across[:, 0], across[:, 1] = start, end
    sheet.curve(across.reshape(-1), middle.repeat(3), colour, thick)


@lru_cache(maxsize=8)
def _rows(names: tuple[str, ...], height: float) -> _Rows:
    """One row for each first word of the names; a pair shares a row, left above right."""
    words = list(dict.fromkeys(name.partition(" ")[0] for name in names))
    step = height / max(1, len(words))
    sides = [name.partition(" ")[2] for name in names]
    off = [{"left": 0.3, "right": 0.7}.get(side, 0.5) for side in sides]
    middle = np.array([(words.index(name.partition(" ")[0]) + at) * step for name, at in zip(names, off, strict=True)])
    places = tuple((word, (k + 0.5) * step) for k, word in enumerate(words))
    return _Rows(places, middle, 0.36 * step, np.array([side != "right" for side in sides]), height)
