"""A panel that stays where it is put."""

from imgui_bundle import ImVec2, imgui

from game.overlay.layout import Area


def begin_docked(name: str, area: Area) -> None:
    """Begin a window that fills `area` and can be neither moved nor sized nor folded; end it with imgui.end()."""
    imgui.set_next_window_pos(ImVec2(area.left, area.top))
    imgui.set_next_window_size(ImVec2(area.width, area.height))
    flags = imgui.WindowFlags_
    imgui.begin(name, None, flags.no_title_bar | flags.no_resize | flags.no_move | flags.no_collapse)
