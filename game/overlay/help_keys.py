"""The keys of the scene on a card at the left: there at the start, gone once the player plays, never over the middle."""

from dataclasses import dataclass

from game.overlay.ink import Ink
from game.overlay.style import INK, PILL, alpha
from game.overlay.view import Shown, View

SHOW_S = 15.0
AFTER_FIRST_INPUT_S = 6.0
FADE_S = 1.5
SIZE = 0.9
ROW_EM = 1.95
GAP_EM = 0.2
TOP_EM = 5.2
FOOT_EM = 3.1


def help_opacity(view: View) -> float:
    """1 at the start, 0 from 15 s of play on, or from 6 s after the first input if that comes earlier."""
    end = SHOW_S
    if view.first_input_s is not None:
        end = min(end, view.first_input_s + AFTER_FIRST_INPUT_S)
    return max(0.0, min(1.0, (end + FADE_S - view.now_s) / FADE_S))


@dataclass(frozen=True)
class Column:
    """Rows of key caps with their meaning under each other; caps and width in overlay units."""

    rows: tuple[tuple[tuple[str, ...], str], ...]
    caps: float
    width: float


class HelpKeys:
    """Draws the scene's keys; lays them out anew only where they or the screen have changed."""

    def __init__(self) -> None:
        self._for: object = None
        self._columns: list[Column] = []

    def draw(self, ink: Ink, view: View, shown: Shown, size: tuple[float, float]) -> None:
        """A card in the lower left corner, above the hint line, on a screen of `size` overlay units. It gives way to the plots."""
        opacity = help_opacity(view)
        if not view.help_keys or opacity <= 0.0 or shown.help or shown.menu or shown.plots:
            return
        em = ink.em
        if self._for != (view.help_keys, em, size):
            self._for, self._columns = (view.help_keys, em, size), columns_of(ink, view.help_keys, size)
        height = ROW_EM * em * len(self._columns[0].rows)
        width = sum(column.width for column in self._columns) + 1.2 * em * (len(self._columns) - 1)
        x, top = 1.6 * em, size[1] - FOOT_EM * em - height
        ink.box(0.9 * em, top - 0.6 * em, width + 1.4 * em, height + 0.9 * em, alpha(PILL, opacity), 0.6)
        for column in self._columns:
            for number, (caps, meaning) in enumerate(column.rows):
                _draw_row(ink, x, top + number * ROW_EM * em, column.caps, caps, meaning, opacity)
            x += column.width + 1.2 * em


def caps_of(keys: str) -> tuple[str, ...]:
    """Key caps of one entry: `W A S D` is four keys, `left shift` and `Page Up` stay together."""
    words = keys.replace("/", " ").split()
    return tuple(words) if all(len(word) <= 3 for word in words) else (keys.strip(),)


def columns_of(ink: Ink, pairs: tuple[tuple[str, str], ...], size: tuple[float, float]) -> list[Column]:
    """As few columns as the height between status and hints allows, equally long."""
    most = max(1, int((size[1] - (TOP_EM + FOOT_EM) * ink.em) / (ROW_EM * ink.em)))
    count = -(-len(pairs) // most)
    each = -(-len(pairs) // count)
    rows = [(caps_of(keys), meaning) for keys, meaning in pairs]
    return [_column(ink, tuple(rows[start : start + each])) for start in range(0, len(rows), each)]


def _column(ink: Ink, rows: tuple[tuple[tuple[str, ...], str], ...]) -> Column:
    caps = max(sum(ink.key_cap_width(cap, SIZE) + GAP_EM * ink.em for cap in keys) for keys, _ in rows) + 0.35 * ink.em
    return Column(rows, caps, caps + max(ink.width(meaning, SIZE) for _, meaning in rows))


def _draw_row(ink: Ink, x: float, y: float, caps_width: float, caps: tuple[str, ...], meaning: str, opacity: float) -> None:
    at = x
    for cap in caps:
        at += ink.key_cap(at, y, cap, opacity, SIZE) + GAP_EM * ink.em
    ink.text(x + caps_width, y + 0.24 * ink.em, meaning, alpha(INK, opacity), SIZE, shadow=False)
