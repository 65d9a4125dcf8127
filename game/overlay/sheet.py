"""A sheet inside a panel to draw on: shapes and words by the window's draw list, curves by ImPlot, which takes whole arrays."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from imgui_bundle import ImVec2, ImVec4, imgui, implot
from numpy.typing import NDArray

from game.overlay.style import INK, Fonts, Rgba, packed

Floats = NDArray[np.float64]


class Sheet:
    """Positions and sizes in overlay units from the sheet's top left, x right, y down; em is the height of the panel's text."""

    def __init__(self, fonts: Fonts) -> None:
        self.fonts = fonts
        self.em = 1.0
        self._left = self._top = 0.0
        self._curves = 0
        self._widths: dict[tuple[str, bool], float] = {}

    def begin(self, width: float, height: float) -> bool:
        """Take up the next `height` of the current window; False where it is out of sight and there is nothing to draw or to end."""
        style = imgui.get_style()
        self.em, self._curves = style.font_size_base * style.font_scale_dpi, 0
        start = imgui.get_cursor_screen_pos()
        self._left, self._top = start.x, start.y
        implot.push_style_var(implot.StyleVar_.plot_padding, ImVec2(0.0, 0.0))
        implot.push_style_color(implot.Col_.plot_bg, _NOTHING)
        implot.push_style_color(implot.Col_.plot_border, _NOTHING)
        implot.push_style_color(implot.Col_.frame_bg, _NOTHING)
        shown = implot.begin_plot("##sheet", ImVec2(width, height), implot.Flags_.canvas_only | implot.Flags_.no_inputs)
        if not shown:
            self._restore_style()
            return False
        bare = implot.AxisFlags_.no_decorations
        implot.setup_axes("", "", bare, bare | implot.AxisFlags_.invert)
        implot.setup_axes_limits(0.0, width, 0.0, height, implot.Cond_.always)
        implot.setup_finish()
        self.ink = implot.get_plot_draw_list()
        return True

    def end(self) -> None:
        implot.end_plot()
        self._restore_style()

    @staticmethod
    def _restore_style() -> None:
        implot.pop_style_color(3)
        implot.pop_style_var()

    def at(self, x: float, y: float) -> ImVec2:
        """On the screen."""
        return ImVec2(self._left + x, self._top + y)

    def curve(self, x: Floats, y: Floats, colour: Rgba, weight: float = 1.5) -> None:
        """Through the places (n,), (n,); NaN interrupts it."""
        self._curves += 1
        implot.plot_line(_NAMES[self._curves % len(_NAMES)], x, y, _pen(colour, weight))

    def words(self, x: float, y: float, text: str, colour: Rgba = INK, size: float = 0.75, strong: bool = False) -> None:
        """One line with its top left at (x, y); size in em, rounded to whole units, where letters are sharp."""
        font = self.fonts.strong if strong else self.fonts.text
        self.ink.add_text(font, round(size * self.em), ImVec2(self._left + x, self._top + y), packed(colour), text)

    def words_to(self, x: float, y: float, text: str, colour: Rgba = INK, size: float = 0.75, strong: bool = False) -> None:
        """One line with its top right at (x, y)."""
        self.words(x - self.width(text, size, strong), y, text, colour, size, strong)

    def width(self, text: str, size: float = 0.75, strong: bool = False) -> float:
        """Of one line of text."""
        key = (text, strong)
        known = self._widths.get(key)
        if known is None:
            if len(self._widths) > 1000:
                self._widths.clear()
            # in em, measured once: letters of a vector font grow with its size
            imgui.push_font(self.fonts.strong if strong else self.fonts.text, imgui.get_style().font_size_base)
            known = self._widths[key] = imgui.calc_text_size(text).x / imgui.get_font_size()
            imgui.pop_font()
        return known * round(size * self.em)

    def box(self, x: float, y: float, width: float, height: float, colour: Rgba, rounding: float = 0.0) -> None:
        x, y = self._left + x, self._top + y
        self.ink.add_rect_filled(ImVec2(x, y), ImVec2(x + width, y + height), packed(colour), rounding * self.em)

    def line(self, x: float, y: float, to_x: float, to_y: float, colour: Rgba, weight: float = 1.0) -> None:
        self.ink.add_line(self.at(x, y), self.at(to_x, to_y), packed(colour), weight)

    def dot(self, x: float, y: float, radius: float, colour: Rgba) -> None:
        self.ink.add_circle_filled(self.at(x, y), radius, packed(colour))

    def ring(self, x: float, y: float, radius: float, colour: Rgba, weight: float) -> None:
        self.ink.add_circle(self.at(x, y), radius, packed(colour), 0, weight)

    def shape(self, corners: Sequence[tuple[float, float]], fill: Rgba | None, edge: Rgba | None, weight: float = 1.5) -> None:
        """A convex polygon, its corners in order either way round."""
        points: list[Any] = [self.at(x, y) for x, y in corners]
        if fill is not None:
            self.ink.add_convex_poly_filled(points, packed(fill))
        if edge is not None:
            self.ink.add_polyline(points, packed(edge), weight, imgui.ImDrawFlags_.closed)

    def clip(self, x: float, y: float, width: float, height: float) -> None:
        """Draw nothing outside this box until `unclip`."""
        self.ink.push_clip_rect(self.at(x, y), self.at(x + width, y + height), True)

    def unclip(self) -> None:
        self.ink.pop_clip_rect()


_NOTHING = ImVec4(0.0, 0.0, 0.0, 0.0)
_NAMES = tuple(f"##{number}" for number in range(128))


@lru_cache(maxsize=256)
def _pen(colour: Rgba, weight: float) -> implot.Spec:
    spec = implot.Spec()
    spec.line_color = ImVec4(*colour)
    spec.line_weight = weight
    return spec
