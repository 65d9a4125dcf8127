"""A panel that stays where it is put."""

from imgui_bundle import ImVec2, imgui

from game.overlay.layout import Area


def begin_docked(name: str, area: Area, flags: int = 0) -> None:
    """Begin a window that fills `area` and can be neither moved nor sized nor folded, with more `flags`; end it with imgui.end()."""
    imgui.set_next_window_pos(ImVec2(area.left, area.top))
    imgui.set_next_window_size(ImVec2(area.width, area.height))
    fixed = imgui.WindowFlags_.no_title_bar | imgui.WindowFlags_.no_resize | imgui.WindowFlags_.no_move | imgui.WindowFlags_.no_collapse
    imgui.begin(name, None, fixed | flags)
