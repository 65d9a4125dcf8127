"""What a player reads while playing: score, upright time, input, messages, keys."""

from game.overlay.help_keys import HelpKeys
from game.overlay.ink import Ink
from game.overlay.layout import free_span
from game.overlay.line_breaks import lines_within
from game.overlay.style import ACCENT, COOL, FAINT, GOOD, INK, PILL, WARN, Rgba, alpha
from game.overlay.toasts import Toasts
from game.overlay.view import Shown, View

BANNER_S = 2.5
MIDDLE_EM = 6.0
"""Half the width that score and upright time take in the middle of the top."""
HINT = (("Tab", "tune"), ("F1", "keys"), ("Esc", "menu"))


class Hud:
    """Draws the writing over the picture. Keeps only what it needs to fade things in and out."""

    def __init__(self) -> None:
        self.toasts = Toasts()
        self._help_keys = HelpKeys()
        self._score: str | None = None
        self._banner: tuple[str, float] | None = None

    def draw(self, ink: Ink, view: View, shown: Shown, size: tuple[float, float]) -> None:
        """Everything, onto a screen of `size` overlay units."""
        self.toasts.follow(tuple(text for text in view.messages if text != view.status), view.now_s)
        self._follow_score(view)
        for label in view.labels:
            width = ink.width(label.text, 0.85)
            ink.text(label.x - width / 2, label.y - 0.5 * ink.em, label.text, label.colour, 0.85)
        if not shown.hud:
            return
        self._draw_score(ink, view, shown, size)
        self._draw_left(ink, view, shown, size[0] / 2 - MIDDLE_EM * ink.em)
        if self._banner is not None and not shown.menu:
            self._draw_banner(ink, view, size)
        self._help_keys.draw(ink, view, shown, size)
        self._draw_hint(ink, shown, size)

    def _follow_score(self, view: View) -> None:
        if view.score != self._score:
            if self._score is not None and view.score is not None and view.messages:
                self._banner = (view.messages[-1], view.now_s)
                self.toasts.drop(view.messages[-1])
            self._score = view.score
        if self._banner is not None and not 0 <= view.now_s - self._banner[1] < BANNER_S:
            self._banner = None

    def _draw_score(self, ink: Ink, view: View, shown: Shown, size: tuple[float, float]) -> None:
        em, y = ink.em, 0.9 * ink.em
        middle = size[0] / 2
        if view.score:
            width = ink.width(view.score, 2.0, ink.fonts.display)
            middle = _clear_of_panels(shown, size, em, width / 2 + 1.1 * em)
            ink.box(middle - width / 2 - 1.1 * em, y, width + 2.2 * em, 2.9 * em, PILL, 0.7)
            ink.text(middle - width / 2, y + 0.38 * em, view.score, INK, 2.0, ink.fonts.display, shadow=False)
            y += 3.2 * em
        if view.upright_s is not None:
            y = self._draw_upright(ink, view, middle, y)
        for text, colour in _badges(view) if not shown.menu else ():
            width = ink.width(text, 0.95, ink.fonts.strong) + 1.3 * 0.95 * em
            y += ink.pill(middle - width / 2, y, text, colour, 0.95, font=ink.fonts.strong) + 0.3 * em

    def _draw_upright(self, ink: Ink, view: View, middle: float, y: float) -> float:
        em, value = ink.em, f"{view.upright_s:.1f} s"
        word = "fell after" if view.fell else "upright"
        big = 1.5 if not view.score else 1.0
        left, right = ink.width(word, 0.9), ink.width(value.replace("1", "0"), big, ink.fonts.display)
        total = left + 0.5 * em + right
        x, height = middle - total / 2, (big * 1.3 + 0.5) * em
        ink.box(x - 0.8 * em, y, total + 1.6 * em, height, PILL, 0.5)
        ink.text(x, y + height / 2 - 0.56 * em, word, FAINT, 0.9, shadow=False)
        colour = WARN if view.fell else INK
        ink.text(x + left + 0.5 * em, y + height / 2 - 0.62 * big * em, value, colour, big, ink.fonts.display, shadow=False)
        return y + height + 0.3 * em

    def _draw_left(self, ink: Ink, view: View, shown: Shown, right: float) -> None:
        em = ink.em
        x = y = 0.9 * em
        if view.status:
            lines = lines_within(view.status, max(right - x - 2.5 * em, 12.0 * em), lambda text: ink.width(text, 0.95))
            width = max(ink.width(line, 0.95) for line in lines)
            ink.box(x, y, width + 2.5 * em, (1.75 + 1.3 * (len(lines) - 1)) * em, PILL, 0.5)
            ink.dot(x + 0.95 * em, y + 0.87 * em, 0.28, WARN if view.interrupted else GOOD)
            for k, line in enumerate(lines):
                ink.text(x + 1.6 * em, y + (0.32 + 1.3 * k) * em, line, INK, 0.95, shadow=False)
            y += (2.1 + 1.3 * (len(lines) - 1)) * em
        if shown.plots:
            return
        for toast in self.toasts.visible(view.now_s):
            y += ink.pill(x, y, toast.text, INK, 0.95, toast.opacity(view.now_s)) + 0.3 * em

    def _draw_banner(self, ink: Ink, view: View, size: tuple[float, float]) -> None:
        assert self._banner is not None
        text, came = self._banner
        age = view.now_s - came
        opacity = min(1.0, age / 0.15, (BANNER_S - age) / 0.5)
        scale = min(2.6, 0.86 * size[0] / max(1.0, ink.width(text, 1.0, ink.fonts.display)))
        width, y = ink.width(text, scale, ink.fonts.display), 0.27 * size[1]
        ink.box(0, y - 0.5 * ink.em, size[0], (1.2 * scale + 1.0) * ink.em, alpha((0.03, 0.04, 0.06, 0.62), opacity), 0)
        ink.text((size[0] - width) / 2, y, text, alpha(ACCENT, opacity), scale, ink.fonts.display)

    def _draw_hint(self, ink: Ink, shown: Shown, size: tuple[float, float]) -> None:
        if shown.menu or shown.help:
            return
        em, x, y = ink.em, 1.35 * ink.em, size[1] - 2.0 * ink.em
        width = sum(ink.key_cap_width(key, 0.75) + ink.width(meaning, 0.82) + 1.25 * em for key, meaning in HINT) - 0.9 * em
        ink.box(0.9 * em, y - 0.27 * em, width + 0.9 * em, 1.8 * em, PILL, 0.5)
        for key, meaning in HINT:
            x += ink.key_cap(x, y, key, 1.0, 0.75) + 0.35 * em
            ink.text(x, y + 0.12 * em, meaning, INK, 0.82, shadow=False)
            x += ink.width(meaning, 0.82) + 0.9 * em


def _clear_of_panels(shown: Shown, size: tuple[float, float], em: float, reach: float) -> float:
    """The middle of the screen, or of what the panels leave free where `reach` to either side would touch one."""
    left, right = free_span(shown, size, em)
    middle = size[0] / 2
    return middle if left <= middle - reach and middle + reach <= right else (left + right) / 2


def _badges(view: View) -> list[tuple[str, Rgba]]:
    badges: list[tuple[str, Rgba]] = []
    if view.interrupted:
        badges.append(("paused until the sensor is back", WARN))
    elif view.paused:
        badges.append(("paused", ACCENT))
    elif view.time_s < 0:
        badges.append(("get ready", COOL))
    elif view.finished:
        badges.append(("end of the recording: R plays it again", COOL))
    if view.speed < 0.93 and not view.paused:
        badges.append((f"slow: this machine keeps {view.speed * 100:.0f} % of real time", WARN))
    return badges
