"""How the overlay looks: palette, fonts and sizes in em, scaled to the screen."""

from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from imgui_bundle import ImVec2, ImVec4, imgui

from game.assets import asset

FONT_PX: Final = 18.0
"""Text height in pixels at 720 lines of picture and scale 1."""

FONT_DIR: Final = asset("fonts")

Rgba = tuple[float, float, float, float]

INK: Final[Rgba] = (0.95, 0.95, 0.93, 1.0)
FAINT: Final[Rgba] = (0.72, 0.74, 0.76, 1.0)
PANEL: Final[Rgba] = (0.055, 0.065, 0.085, 0.88)
PILL: Final[Rgba] = (0.055, 0.065, 0.085, 0.66)
FIELD: Final[Rgba] = (0.16, 0.18, 0.22, 0.90)
ACCENT: Final[Rgba] = (1.00, 0.70, 0.26, 1.0)
COOL: Final[Rgba] = (0.40, 0.80, 0.96, 1.0)
WARN: Final[Rgba] = (1.00, 0.45, 0.36, 1.0)
GOOD: Final[Rgba] = (0.52, 0.86, 0.52, 1.0)


@dataclass(frozen=True)
class Fonts:
    """text for reading, strong for headings and key caps, display for the score."""

    text: imgui.ImFont
    strong: imgui.ImFont
    display: imgui.ImFont


def load_fonts() -> Fonts:
    """Load the shipped fonts into the current context; glyphs are drawn at whatever size is asked for later."""
    atlas = imgui.get_io().fonts
    text, strong, display = (
        atlas.add_font_from_file_ttf(str(FONT_DIR / f"{name}.otf"), FONT_PX)
        for name in ("Inter-Regular", "Inter-SemiBold", "InterDisplay-Bold")
    )
    return Fonts(text, strong, display)


def interface_scale(framebuffer_height: int, content_scale: float) -> float:
    """Size of the overlay against 720 lines at 96 dpi: grows with the picture, since a Kinect player stands two metres away."""
    lines = framebuffer_height / max(content_scale, 0.5)
    return max(content_scale, 0.5) * min(2.0, max(0.62, lines / 720.0))


def alpha(colour: Rgba, part: float) -> Rgba:
    """The colour with its opacity times `part`."""
    return (colour[0], colour[1], colour[2], colour[3] * part)


@lru_cache(maxsize=512)
def packed(colour: Rgba) -> int:
    """The colour as a draw list takes it."""
    return imgui.color_convert_float4_to_u32(ImVec4(*colour))


def apply_style(scale: float) -> None:
    """Set palette and sizes of the current context for a scale; may be called again with another one."""
    style = imgui.get_style()
    style.font_size_base = FONT_PX
    style.font_scale_dpi = scale
    _sizes(style, FONT_PX * scale)
    _colours(style)


def _sizes(style: imgui.Style, em: float) -> None:
    pairs = {
        "window_padding": (0.9, 0.8), "frame_padding": (0.55, 0.28), "item_spacing": (0.5, 0.36), "item_inner_spacing": (0.4, 0.3),
        "cell_padding": (0.3, 0.2), "window_min_size": (2.0, 2.0), "separator_text_padding": (1.0, 0.2),
    }  # fmt: skip
    for name, (x, y) in pairs.items():
        setattr(style, name, ImVec2(round(x * em), round(y * em)))
    lengths = {
        "window_rounding": 0.6, "child_rounding": 0.45, "popup_rounding": 0.5, "frame_rounding": 0.35, "grab_rounding": 0.3,
        "scrollbar_rounding": 0.4, "scrollbar_size": 0.7, "grab_min_size": 0.7, "indent_spacing": 0.9, "tab_rounding": 0.35,
        "selectable_rounding": 0.3, "log_slider_deadzone": 0.25,
    }  # fmt: skip
    for name, length in lengths.items():
        setattr(style, name, float(round(length * em)))
    style.window_border_size = style.popup_border_size = 1.0
    style.frame_border_size = 0.0
    style.window_title_align = ImVec2(0.0, 0.5)


def _colours(style: imgui.Style) -> None:
    col = imgui.Col_
    palette = {
        col.text: INK, col.text_disabled: FAINT, col.window_bg: PANEL, col.popup_bg: alpha(PANEL, 1.1), col.child_bg: (0, 0, 0, 0),
        col.border: (1, 1, 1, 0.10), col.frame_bg: FIELD, col.frame_bg_hovered: (0.22, 0.25, 0.30, 0.95),
        col.frame_bg_active: (0.26, 0.29, 0.35, 1.0), col.title_bg: PANEL, col.title_bg_active: PANEL, col.title_bg_collapsed: PANEL,
        col.slider_grab: alpha(ACCENT, 0.85), col.slider_grab_active: ACCENT, col.check_mark: ACCENT,
        col.button: FIELD, col.button_hovered: (0.28, 0.31, 0.37, 1.0), col.button_active: alpha(ACCENT, 0.7),
        col.header: (0.15, 0.17, 0.21, 0.85), col.header_hovered: (0.22, 0.25, 0.30, 0.95), col.header_active: (0.28, 0.31, 0.37, 1.0),
        col.scrollbar_bg: (0, 0, 0, 0.15), col.scrollbar_grab: (1, 1, 1, 0.16), col.scrollbar_grab_hovered: (1, 1, 1, 0.28),
        col.scrollbar_grab_active: (1, 1, 1, 0.36), col.separator: (1, 1, 1, 0.10), col.text_selected_bg: alpha(ACCENT, 0.35),
        col.nav_cursor: ACCENT, col.modal_window_dim_bg: (0, 0, 0, 0.45), col.resize_grip: (1, 1, 1, 0.08),
        col.checkbox_selected_bg: FIELD, col.input_text_cursor: INK,
    }  # fmt: skip
    for index, colour in palette.items():
        style.set_color_(index, ImVec4(*colour))
