"""The keys of the scene at the foot of the picture: there at the start, gone once the player plays."""

from game.overlay.ink import Ink
from game.overlay.layout import free_span
from game.overlay.style import INK, PILL, alpha
from game.overlay.view import Shown, View

SHOW_S = 15.0
AFTER_FIRST_INPUT_S = 6.0
FADE_S = 1.5
SIZE = 0.9


def help_opacity(view: View) -> float:
    """1 at the start, 0 from 15 s of play on, or from 6 s after the first input if that comes earlier."""
    end = SHOW_S
    if view.first_input_s is not None:
        end = min(end, view.first_input_s + AFTER_FIRST_INPUT_S)
    return max(0.0, min(1.0, (end + FADE_S - view.now_s) / FADE_S))


def draw_help_keys(ink: Ink, view: View, shown: Shown, size: tuple[float, float]) -> None:
    """Key caps with their meaning in centred rows above the hint line."""
    opacity = help_opacity(view)
    if not view.help_keys or opacity <= 0.0 or shown.help or shown.menu:
        return
    em = ink.em
    left, right = free_span(shown, size, em)
    middle = (left + right) / 2
    rows = _rows(ink, view.help_keys, min(0.8 * size[0], right - left - 4.0 * em))
    row_height = 2.15 * em
    width = max(_row_width(ink, row) for row in rows) + 2.0 * em
    top = size[1] - 2.9 * em - row_height * len(rows)
    ink.box(middle - width / 2, top - 0.45 * em, width, row_height * len(rows) + 0.6 * em, alpha(PILL, opacity), 0.7)
    for number, row in enumerate(rows):
        x = middle - _row_width(ink, row) / 2
        for keys, meaning in row:
            x = _draw_pair(ink, x, top + number * row_height, keys, meaning, opacity)


def caps_of(keys: str) -> list[str]:
    """Key caps of one entry: `W A S D` is four keys, `left shift` and `Page Up` stay together."""
    words = keys.replace("/", " ").split()
    if all(len(word) <= 3 for word in words):
        return words
    return [keys.strip()]


def _pair_width(ink: Ink, keys: str, meaning: str) -> float:
    caps = sum(ink.key_cap_width(cap, SIZE) + 0.2 * ink.em for cap in caps_of(keys))
    return caps + 0.25 * ink.em + ink.width(meaning, SIZE) + 1.3 * ink.em


def _row_width(ink: Ink, row: list[tuple[str, str]]) -> float:
    return sum(_pair_width(ink, *pair) for pair in row) - 1.3 * ink.em


def _rows(ink: Ink, pairs: tuple[tuple[str, str], ...], longest: float) -> list[list[tuple[str, str]]]:
    """Split over as few rows as fit, about equally long."""
    total = sum(_pair_width(ink, *pair) for pair in pairs)
    count = max(1, -(-int(total) // max(1, int(longest))))
    rows: list[list[tuple[str, str]]] = [[]]
    for pair in pairs:
        wide = _row_width(ink, [*rows[-1], pair])
        if rows[-1] and (
            wide > longest or (_row_width(ink, rows[-1]) >= total / count - _pair_width(ink, *pair) / 2 and len(rows) < count)
        ):
            rows.append([])
        rows[-1].append(pair)
    return rows


def _draw_pair(ink: Ink, x: float, y: float, keys: str, meaning: str, opacity: float) -> float:
    for cap in caps_of(keys):
        x += ink.key_cap(x, y, cap, opacity, SIZE) + 0.2 * ink.em
    x += 0.25 * ink.em
    ink.text(x, y + 0.24 * ink.em, meaning, alpha(INK, opacity), SIZE, shadow=False)
    return x + ink.width(meaning, SIZE) + 1.3 * ink.em
