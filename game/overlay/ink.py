"""Words, pills and key caps straight onto the picture, in em."""

from imgui_bundle import ImVec2, imgui

from game.overlay.style import FIELD, FONT_PX, INK, PILL, Fonts, Rgba, alpha, packed

SHADOW: Rgba = (0.0, 0.0, 0.0, 0.75)


class Ink:
    """Draws behind all windows. Positions are in overlay units from the top left, sizes in em (text heights)."""

    def __init__(self, fonts: Fonts, scale: float) -> None:
        self.fonts = fonts
        self.em = FONT_PX * scale
        self._list = imgui.get_background_draw_list()
        self._widths: dict[tuple[str, float, int], float] = {}

    def begin(self) -> None:
        """Take up this frame's sheet; call it once a frame."""
        self._list = imgui.get_background_draw_list()

    def width(self, text: str, size: float = 1.0, font: imgui.ImFont | None = None) -> float:
        """Width of one line of text, overlay units."""
        key = (text, size, id(font))
        known = self._widths.get(key)
        if known is not None:
            return known
        if len(self._widths) > 1000:
            self._widths.clear()
        imgui.push_font(font or self.fonts.text, size * FONT_PX)
        width = self._widths[key] = imgui.calc_text_size(text).x
        imgui.pop_font()
        return width

    def text(
        self, x: float, y: float, text: str, colour: Rgba = INK, size: float = 1.0, font: imgui.ImFont | None = None, shadow: bool = True
    ) -> None:
        """One line with its top left at (x, y); a soft shadow keeps it readable over anything."""
        font = font or self.fonts.text
        if shadow:
            off = max(1.0, self.em * size * 0.06)
            self._list.add_text(font, size * self.em, ImVec2(x, y + off), packed(alpha(SHADOW, colour[3])), text)
        self._list.add_text(font, size * self.em, ImVec2(x, y), packed(colour), text)

    def box(self, x: float, y: float, width: float, height: float, colour: Rgba = PILL, rounding: float = 0.5) -> None:
        """A filled rounded box; rounding in em."""
        self._list.add_rect_filled(ImVec2(x, y), ImVec2(x + width, y + height), packed(colour), rounding * self.em)

    def outline(self, x: float, y: float, width: float, height: float, colour: Rgba, rounding: float = 0.5) -> None:
        """The edge of a rounded box."""
        self._list.add_rect(ImVec2(x, y), ImVec2(x + width, y + height), packed(colour), rounding * self.em, max(1.0, self.em / 16))

    def dot(self, x: float, y: float, radius: float, colour: Rgba) -> None:
        """A filled circle about (x, y); radius in em."""
        self._list.add_circle_filled(ImVec2(x, y), radius * self.em, packed(colour))

    def pill(
        self, x: float, y: float, text: str, colour: Rgba = INK, size: float = 1.0, opacity: float = 1.0, font: imgui.ImFont | None = None
    ) -> float:
        """A line of text in a rounded box with its top left at (x, y); returns the box's height."""
        em = self.em * size
        height = 1.75 * em
        self.box(x, y, self.width(text, size, font) + 1.3 * em, height, alpha(PILL, opacity), 0.5 * size)
        self.text(x + 0.65 * em, y + 0.36 * em, text, alpha(colour, opacity), size, font, shadow=False)
        return height

    def key_cap_width(self, key: str, size: float = 0.9) -> float:
        """Width of a key cap, overlay units."""
        em = self.em * size
        return max(1.7 * em, self.width(key, size, self.fonts.strong) + 0.9 * em)

    def key_cap(self, x: float, y: float, key: str, opacity: float = 1.0, size: float = 0.9) -> float:
        """A key with its name on it; returns its width. It is 1.7 em high, times `size`."""
        em = self.em * size
        width, height = self.key_cap_width(key, size), 1.7 * em
        self.box(x, y + 0.14 * em, width, height, alpha((0.0, 0.0, 0.0, 0.85), opacity), 0.36 * size)
        self.box(x, y, width, height - 0.06 * em, alpha(FIELD, opacity * 1.1), 0.36 * size)
        self.outline(x, y, width, height - 0.06 * em, alpha((1.0, 1.0, 1.0, 0.28), opacity), 0.36 * size)
        inner = self.width(key, size, self.fonts.strong)
        self.text(x + (width - inner) / 2, y + 0.32 * em, key, alpha(INK, opacity), size, self.fonts.strong, shadow=False)
        return width
