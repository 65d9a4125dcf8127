"""The view from above: support, soles by what each foot does, and the points that the balance is about."""

import math
from collections.abc import Iterator

from game.overlay.sheet import Sheet
from game.overlay.style import ACCENT, COOL, FAINT, GOOD, INK, Rgba, alpha
from game.scenes.scene import Plot

Places = list[tuple[float, float]]

LEAST_REACH_M, MARGIN_M = 0.2, 0.05
GRID_M = 0.1
LEGEND_EM = 2.2
SMALL, TINY = 0.7, 0.65

FEET: dict[str, tuple[Rgba, str]] = {
    "stands": (INK, "stands"),
    "follows": (COOL, "swings after yours"),
    "steps": (ACCENT, "own step"),
    "flies": ((0.80, 0.72, 0.98, 1.0), "flight"),
    "touches": (INK, "on the floor"),
    "lifted": (COOL, "lifted"),
}
"""Colour and words for each look of a foot."""

POINTS: dict[str, Rgba] = {"capture point": ACCENT, "pressure": COOL, "COM": INK}
OTHER: Rgba = (0.93, 0.50, 0.74, 1.0)
_GRID: Rgba = (1.0, 1.0, 1.0, 0.07)


class PlanPlot:
    """Draws one plot of kind "plan". Keeps where it looks, so that the view does not tremble."""

    def __init__(self) -> None:
        self._reach = LEAST_REACH_M
        self._middle = (0.0, 0.0)

    def draw(self, sheet: Sheet, plot: Plot, x: float, y: float, width: float, height: float) -> None:
        """Into a box of the sheet, the legend below included."""
        view = height - LEGEND_EM * sheet.em
        sheet.box(x, y, width, view, (0.0, 0.0, 0.0, 0.28), 0.3)
        sheet.clip(x, y, width, view)
        self._draw_view(sheet, plot, x, y, width, view)
        sheet.unclip()
        _draw_legend(sheet, plot, x, y + view + 0.25 * sheet.em)

    def _draw_view(self, sheet: Sheet, plot: Plot, x: float, y: float, width: float, height: float) -> None:
        shown = [
            (name, plot.looks.get(name) or _look_of(name, len(right)), right, forward)
            for name, (right, forward) in plot.series.items()
            if len(right)
        ]
        spots = [(name, look, right.tolist(), forward.tolist()) for name, look, right, forward in shown if look != "trail"]
        self._aim([(right, forward) for _, look, right, forward in spots if look != "other"], width / height)
        scale = height / 2.0 / self._reach
        left, top = x + width / 2 - scale * self._middle[0], y + height / 2 + scale * self._middle[1]
        _draw_grid(sheet, x, y, width, height, scale, left, top)
        for _, look, right, forward in shown:
            if look == "trail":
                sheet.curve(left + scale * right, top - scale * forward, alpha(INK, 0.45), 0.08 * sheet.em)
        for name, look, right, forward in spots:
            # a NaN anywhere makes the sum one
            if not math.isfinite(sum(right) + sum(forward)):
                continue
            places = [(left + scale * r, top - scale * f) for r, f in zip(right, forward, strict=True)]
            if look == "other" and len(places) == 1:
                _draw_other(sheet, places[0], x, y, width, height, scale)
            else:
                _draw_places(sheet, name, look, places)

    def _aim(self, curves: list[tuple[list[float], list[float]]], aspect: float) -> None:
        """Hold the view where everything fits; else look at its middle, as far as it reaches in steps of 5 cm."""
        right = [value for axis, _ in curves for value in axis if math.isfinite(value)]
        forward = [value for _, axis in curves for value in axis if math.isfinite(value)]
        if not right or not forward:
            return
        low, high = (min(right), min(forward)), (max(right), max(forward))
        half = self._reach * aspect - MARGIN_M, self._reach - MARGIN_M
        fits = all(self._middle[k] - half[k] <= low[k] and high[k] <= self._middle[k] + half[k] for k in range(2))
        need = MARGIN_M + max((high[0] - low[0]) / aspect, high[1] - low[1]) / 2.0
        if not fits or need < 0.6 * self._reach:
            self._middle = 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])
            self._reach = max(LEAST_REACH_M, 0.05 * math.ceil(need / 0.05))


def _look_of(name: str, count: int) -> str:
    if count == 1:
        return "point"
    return "area" if count > 2 and ("polygon" in name or "support" in name) else "trail"


def _draw_grid(sheet: Sheet, x: float, y: float, width: float, height: float, scale: float, left: float, top: float) -> None:
    em = sheet.em
    step = scale * GRID_M * (1.0 if GRID_M * scale > 0.7 * em else 5.0)
    for k in range(math.ceil((x - left) / step), math.floor((x + width - left) / step) + 1):
        sheet.box(left + k * step, y, 1.0, height, _GRID)
    for k in range(math.ceil((top - y - height) / step), math.floor((top - y) / step) + 1):
        sheet.box(x, top - k * step, width, 1.0, _GRID)
    end, bottom = x + width - 0.5 * em, y + height - 0.45 * em
    sheet.line(end - step, bottom, end, bottom, FAINT, 0.1 * em)
    sheet.words_to(end, bottom - 0.95 * em, f"{100 * step / scale:.0f} cm", FAINT, TINY)
    sheet.words(x + 0.4 * em, bottom - 0.55 * em, "up: ahead", FAINT, TINY)


def _draw_places(sheet: Sheet, name: str, look: str, places: Places) -> None:
    em = sheet.em
    if look == "point":
        sheet.dot(*places[0], 0.31 * em, (0.0, 0.0, 0.0, 0.8))
        sheet.dot(*places[0], 0.24 * em, POINTS.get(name, OTHER))
    elif look == "goal":
        sheet.ring(*places[0], 0.42 * em, POINTS.get(name.removesuffix(" wanted"), OTHER), 0.13 * em)
    elif look == "landing":
        sheet.shape(places, None, alpha(ACCENT, 0.6), 0.08 * em)
    elif look == "area":
        sheet.shape(places, alpha(GOOD, 0.18), alpha(GOOD, 0.8), 0.08 * em)
    else:
        colour = OTHER if look == "other" else FEET.get(look, FEET["stands"])[0]
        sheet.shape(places, alpha(colour, 0.16), colour, 0.1 * em)


def _draw_other(sheet: Sheet, place: tuple[float, float], x: float, y: float, width: float, height: float, scale: float) -> None:
    """Somebody else's COM: where it is, or at the edge nearest to it with how far beyond it lies."""
    em = sheet.em
    edge = 0.35 * em
    held = min(max(place[0], x + edge), x + width - edge), min(max(place[1], y + edge), y + height - edge)
    sheet.dot(*held, 0.22 * em, OTHER)
    beyond = math.dist(place, held) / scale
    if beyond > 0.01:
        words, top = f"{100 * beyond:.0f} cm beyond", min(held[1] - 0.3 * em, y + height - 0.9 * em)
        if held[0] < x + width / 2:
            sheet.words(held[0] + 0.5 * em, top, words, OTHER, TINY)
        else:
            sheet.words_to(held[0] - 0.5 * em, top, words, OTHER, TINY)


def _draw_legend(sheet: Sheet, plot: Plot, x: float, y: float) -> None:
    """Points first, filled where they are and rings where they are wanted; then areas."""
    em, right = sheet.em, x
    for name, colour in POINTS.items():
        if name not in plot.series:
            continue
        middle = y + 0.45 * em
        sheet.dot(right + 0.22 * em, middle, 0.2 * em, colour)
        right += 0.55 * em
        if f"{name} wanted" in plot.series:
            sheet.ring(right + 0.28 * em, middle, 0.24 * em, colour, 0.1 * em)
            right += 0.65 * em
        sheet.words(right, y, name, INK, SMALL)
        right += sheet.width(name, SMALL) + 0.45 * em
    right, y = x, y + 0.98 * em
    for colour, words in _areas(plot):
        sheet.box(right, y + 0.18 * em, 0.45 * em, 0.5 * em, colour, 0.1)
        sheet.words(right + 0.6 * em, y, words, INK, SMALL)
        right += 0.6 * em + sheet.width(words, SMALL) + 0.5 * em


def _areas(plot: Plot) -> Iterator[tuple[Rgba, str]]:
    if "support" in plot.series:
        yield GOOD, "support"
    seen = set(plot.looks.values())
    for look, (colour, words) in FEET.items():
        if look in seen:
            yield colour, words
    if "other" in seen:
        yield OTHER, "opponent"
