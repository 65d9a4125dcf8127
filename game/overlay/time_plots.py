"""Plots over time as small multiples: one box each, two beside each other, the last ten seconds."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game.overlay.sheet import Sheet
from game.overlay.style import FAINT, INK, Rgba, alpha
from game.scenes.scene import Plot

TIME_SPAN_S = 10.0
COLUMNS, BETWEEN_EM = 2, 0.7
TITLE_EM, GAP_EM = 1.05, 0.4
SMALL, TINY = 0.72, 0.65
LINES: tuple[Rgba, ...] = (
    (1.00, 0.70, 0.26, 1.0), (0.40, 0.80, 0.96, 1.0), (0.56, 0.86, 0.50, 1.0), (0.93, 0.50, 0.74, 1.0),
    (0.80, 0.72, 0.98, 1.0), (0.95, 0.90, 0.55, 1.0), (0.98, 0.48, 0.38, 1.0), (0.55, 0.90, 0.85, 1.0),
)  # fmt: skip
_ROUND = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.5, 10.0)
_PLANNED = " planned"

Floats = NDArray[np.float64]


def rows_of(count: int) -> int:
    """Rows that `count` plots fill."""
    return -(-count // COLUMNS)


@dataclass(frozen=True)
class _Drawn:
    """A plot as it lies in its box: curves in overlay units from the box's top left, words to be written small."""

    plot: Plot
    size: tuple[float, float]
    curves: tuple[tuple[Floats, Floats, Rgba, bool], ...]
    title: str
    words: tuple[tuple[float, float, str, Rgba], ...]


class TimePlots:
    """Draws plots of kind "time". One that has not changed since the last frame is not worked out again."""

    def __init__(self) -> None:
        self._drawn: dict[str, _Drawn] = {}

    def draw(self, sheet: Sheet, plots: Sequence[Plot], y: float, width: float, graph: float) -> None:
        """All of them, from y downwards; graph: height of the box with the curves."""
        em = sheet.em
        cell = (width - (COLUMNS - 1) * BETWEEN_EM * em) / COLUMNS
        for number, plot in enumerate(plots):
            row, column = divmod(number, COLUMNS)
            x, top = column * (cell + BETWEEN_EM * em), y + row * ((TITLE_EM + GAP_EM) * em + graph)
            drawn = self._drawn.get(plot.title)
            if drawn is None or drawn.plot is not plot or drawn.size != (cell, graph):
                drawn = self._drawn[plot.title] = _laid_out(sheet, plot, cell, graph)
            _draw_one(sheet, drawn, x, top)


def _laid_out(sheet: Sheet, plot: Plot, width: float, graph: float) -> _Drawn:
    low, high = span_of([value for _, value in plot.series.values()])
    newest = max((float(t[-1]) for t, _ in plot.series.values() if len(t)), default=0.0)
    across, up = width / TIME_SPAN_S, (graph - 4.0) / (high - low)
    colours = colours_of(plot)
    curves = []
    for name, (t, value) in plot.series.items():
        if len(t) and t[0] < newest - TIME_SPAN_S:
            first = int(np.searchsorted(t, newest - TIME_SPAN_S))
            t, value = t[first:], value[first:]
        curves.append((width + across * (t - newest), graph - 2.0 - up * (value - low), colours[name], name.endswith(_PLANNED)))
    em, title = sheet.em, plot.title[:1].upper() + plot.title[1:] + (f", {plot.unit}" if plot.unit else "")
    ends = [(0.2 * em, 0.0, f"{high:g}", FAINT), (0.2 * em, graph - 0.85 * em, f"{low:g}", FAINT)]
    legend = _legend(sheet, plot, colours, width, width - sheet.width(title, SMALL, strong=True) - 0.5 * em)
    return _Drawn(plot, (width, graph), tuple(curves), title, (*ends, *legend))


def _draw_one(sheet: Sheet, drawn: _Drawn, x: float, y: float) -> None:
    em, (width, graph) = sheet.em, drawn.size
    sheet.words(x, y, drawn.title, INK, SMALL, strong=True)
    top = y + TITLE_EM * em
    sheet.box(x, top, width, graph, (0.0, 0.0, 0.0, 0.28), 0.25)
    sheet.box(x + width / 2, top, 1.0, graph, (1.0, 1.0, 1.0, 0.08))
    for across, down, colour, planned in drawn.curves:
        sheet.curve(x + across, top + down, alpha(colour, 0.6) if planned else colour, (0.06 if planned else 0.09) * em)
    for across, down, text, colour in drawn.words:
        sheet.words(x + across, top + down, text, colour, TINY)


def _legend(sheet: Sheet, plot: Plot, colours: dict[str, Rgba], right: float, room: float) -> list[tuple[float, float, str, Rgba]]:
    """Right-aligned beside the title where there is `room` for it, else inside the box; a lone curve needs none."""
    names = [name for name in plot.series if not name.endswith(_PLANNED)]
    if len(names) < 2:
        return []
    em = sheet.em
    length = sum(sheet.width(name, TINY) + 0.5 * em for name in names)
    down = 0.05 * em if length > room else (0.05 - TITLE_EM) * em
    words = []
    for name in reversed(names):
        right -= sheet.width(name, TINY)
        words.append((right, down, name, colours[name]))
        right -= 0.5 * em
    return words


def colours_of(plot: Plot) -> dict[str, Rgba]:
    """One for each series; what is planned has the colour of what it is the plan for."""
    own = [name for name in plot.series if not name.endswith(_PLANNED)]
    colours = {name: LINES[number % len(LINES)] for number, name in enumerate(own)}
    return {name: colours.get(name.removesuffix(_PLANNED), LINES[-1]) for name in plot.series}


def span_of(values: Sequence[Floats]) -> tuple[float, float]:
    """Bottom and top of the axis in round numbers: from zero, or from close below where all lies close together far above zero."""
    ends = [(float(np.fmin.reduce(v)), float(np.fmax.reduce(v))) for v in values if len(v)]
    ends = [(low, high) for low, high in ends if math.isfinite(low) and math.isfinite(high)]
    if not ends:
        return 0.0, 1.0
    least, most = min(low for low, _ in ends), max(high for _, high in ends)
    if least < -0.01 * abs(most):
        size = round_up(max(most, -least))
        return -size, size
    if least > 0.75 * most:
        step = round_up(max(most - least, 0.05 * most))
        first = math.floor(least / step)
        return step * first, step * max(math.ceil(most / step), first + 1)
    return 0.0, round_up(most)


def round_up(value: float) -> float:
    """The next of 1, 1.5, 2, 3 ... times a power of ten."""
    if value <= 1e-9:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return next(top * power for top in _ROUND if top * power >= value * 0.999999)
