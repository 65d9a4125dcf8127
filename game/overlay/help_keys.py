"""The keys of the scene at the foot of the picture: there at the start, gone once the player plays."""

import math
from dataclasses import dataclass

from game.overlay.ink import Ink
from game.overlay.layout import free_span
from game.overlay.style import INK, PILL, alpha
from game.overlay.view import Shown, View

SHOW_S = 15.0
AFTER_FIRST_INPUT_S = 6.0
FADE_S = 1.5
SIZE = 0.9
GAP_EM = 1.3
MOST_ROWS = 4


def help_opacity(view: View) -> float:
    """1 at the start, 0 from 15 s of play on, or from 6 s after the first input if that comes earlier."""
    end = SHOW_S
    if view.first_input_s is not None:
        end = min(end, view.first_input_s + AFTER_FIRST_INPUT_S)
    return max(0.0, min(1.0, (end + FADE_S - view.now_s) / FADE_S))


class HelpKeys:
    """Draws the scene's keys; lays them out anew only where they, the screen or the panels have changed."""

    def __init__(self) -> None:
        self._for: object = None
        self._rows: list[Row] = []

    def draw(self, ink: Ink, view: View, shown: Shown, size: tuple[float, float]) -> None:
        """Key caps with their meaning in centred rows above the hint line, on a screen of `size` overlay units."""
        opacity = help_opacity(view)
        if not view.help_keys or opacity <= 0.0 or shown.help or shown.menu:
            return
        em = ink.em
        left, right = free_span(shown, size, em)
        longest = min(0.8 * size[0], right - left - 4.0 * em)
        if self._for != (view.help_keys, em, longest):
            self._for, self._rows = (view.help_keys, em, longest), rows_of(ink, view.help_keys, longest)
        if len(self._rows) > MOST_ROWS:  # wide panels are open: whoever tunes can look under F1
            return
        row_height = 2.15 * em
        width = max(row.width for row in self._rows) + 2.0 * em
        middle, height = (left + right) / 2, row_height * len(self._rows)
        top = size[1] - 2.9 * em - height
        ink.box(middle - width / 2, top - 0.45 * em, width, height + 0.6 * em, alpha(PILL, opacity), 0.7)
        for number, row in enumerate(self._rows):
            x = middle - row.width / 2
            for caps, meaning in row.pairs:
                x = _draw_pair(ink, x, top + number * row_height, caps, meaning, opacity)


@dataclass(frozen=True)
class Row:
    """Key caps with their meanings, side by side; width in overlay units."""

    pairs: tuple[tuple[tuple[str, ...], str], ...]
    width: float


def caps_of(keys: str) -> tuple[str, ...]:
    """Key caps of one entry: `W A S D` is four keys, `left shift` and `Page Up` stay together."""
    words = keys.replace("/", " ").split()
    return tuple(words) if all(len(word) <= 3 for word in words) else (keys.strip(),)


def rows_of(ink: Ink, pairs: tuple[tuple[str, str], ...], longest: float) -> list[Row]:
    """Split over as few rows as fit into `longest` overlay units, about equally long."""
    gap = GAP_EM * ink.em
    widths = [_pair_width(ink, caps_of(keys), meaning) for keys, meaning in pairs]
    goal = sum(widths) / max(1, math.ceil(sum(widths) / max(1.0, longest)))
    groups: list[list[int]] = [[]]
    used = 0.0
    for number, width in enumerate(widths):
        if groups[-1] and (used + width - gap > longest or used + width / 2 > goal):
            groups.append([])
            used = 0.0
        groups[-1].append(number)
        used += width
    return [Row(tuple((caps_of(pairs[n][0]), pairs[n][1]) for n in group), sum(widths[n] for n in group) - gap) for group in groups]


def _pair_width(ink: Ink, caps: tuple[str, ...], meaning: str) -> float:
    keys = sum(ink.key_cap_width(cap, SIZE) + 0.2 * ink.em for cap in caps)
    return keys + (0.25 + GAP_EM) * ink.em + ink.width(meaning, SIZE)


def _draw_pair(ink: Ink, x: float, y: float, caps: tuple[str, ...], meaning: str, opacity: float) -> float:
    for cap in caps:
        x += ink.key_cap(x, y, cap, opacity, SIZE) + 0.2 * ink.em
    x += 0.25 * ink.em
    ink.text(x, y + 0.24 * ink.em, meaning, alpha(INK, opacity), SIZE, shadow=False)
    return x + ink.width(meaning, SIZE) + GAP_EM * ink.em
