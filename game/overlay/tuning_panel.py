"""The panel at the right: every tunable by group, presets, save and load."""

from functools import lru_cache

from imgui_bundle import ImVec2, ImVec4, imgui

from game.overlay.docked import begin_docked
from game.overlay.layout import panel_area
from game.overlay.style import ACCENT, FAINT, Fonts, alpha
from game.overlay.tunable_widget import Place, draw_tunable
from game.overlay.tunable_words import group_title, matches
from game.overlay.view import Shown, View
from game.presets import PRESETS, matching_preset
from game.tunables import TUNABLES, Tunable

LABEL_EM = 9.0


class TuningPanel:
    """Draws itself while `shown.panel`. `places` says where each tunable's control was drawn in the last frame."""

    def __init__(self, fonts: Fonts) -> None:
        self._fonts = fonts
        self.places: dict[str, Place] = {}
        self.buttons: dict[str, Place] = {}
        self._preset: str | None = None
        self._preset_version = -1

    def draw(self, view: View, shown: Shown, size: tuple[float, float]) -> None:
        """At the right edge of a screen of `size` overlay units, over its whole height."""
        self.places.clear()
        self.buttons.clear()
        if not shown.panel:
            return
        em = imgui.get_style().font_size_base * imgui.get_style().font_scale_dpi
        begin_docked("tuning", panel_area(size, em))
        self._head(view, shown)
        foot = imgui.get_frame_height_with_spacing() if view.restart_pending else 0.0
        imgui.begin_child("tunables", ImVec2(0.0, -foot))
        groups = _groups(shown.filter)
        for group, tunables in groups.items():
            self._group(group, tunables, view, shown)
        if not groups:
            imgui.text_colored(ImVec4(*FAINT), f"nothing is called {shown.filter!r}")
        imgui.end_child()
        if view.restart_pending:
            self._restart_button(shown)
        imgui.end()

    def _head(self, view: View, shown: Shown) -> None:
        imgui.push_font(self._fonts.strong, 1.15 * imgui.get_style().font_size_base)
        imgui.text("Tune")
        imgui.pop_font()
        self._right_buttons(shown)
        imgui.set_next_item_width(-1.0)
        _, shown.filter = imgui.input_text_with_hint("##filter", "filter by name or meaning", shown.filter)
        self._note("filter")
        self._preset_row(view, shown)
        imgui.dummy(ImVec2(0.0, 0.1 * imgui.get_font_size()))

    def _restart_button(self, shown: Shown) -> None:
        """At the foot, so that nothing moves under the mouse while a slider is dragged."""
        imgui.push_style_color(imgui.Col_.button, ImVec4(*alpha(ACCENT, 0.45)))
        if imgui.button("Takes effect at restart: restart now", ImVec2(-1.0, 0.0)):
            shown.ask("restart")
        imgui.pop_style_color()
        self._note("restart")

    def _preset_row(self, view: View, shown: Shown) -> None:
        if self._preset_version != view.settings.version:
            self._preset, self._preset_version = matching_preset(view.settings), view.settings.version
        imgui.align_text_to_frame_padding()
        imgui.text_colored(ImVec4(*FAINT), "Preset")
        for name in PRESETS:
            imgui.same_line()
            imgui.push_style_color(
                imgui.Col_.button, ImVec4(*alpha(ACCENT, 0.55)) if name == self._preset else imgui.get_style_color_vec4(imgui.Col_.button)
            )
            if imgui.button(name):
                shown.ask("preset", name)
            imgui.pop_style_color()
            self._note(f"preset {name}")

    def _right_buttons(self, shown: Shown) -> None:
        captions = {"reset all": "Reset all", "save": "Save", "load": "Load"}
        style = imgui.get_style()
        widths = [imgui.calc_text_size(caption).x + 2 * style.frame_padding.x for caption in captions.values()]
        imgui.same_line(imgui.get_window_width() - style.window_padding.x - sum(widths) - style.item_spacing.x * (len(widths) - 1))
        for kind, caption in captions.items():
            if imgui.button(caption):
                shown.ask(kind)
            self._note(kind)
            imgui.same_line()
        imgui.new_line()

    def _group(self, group: str, tunables: list[Tunable], view: View, shown: Shown) -> None:
        if shown.filter:
            imgui.set_next_item_open(True)
        imgui.push_font(self._fonts.strong, 0.0)
        opened = imgui.collapsing_header(group_title(group), imgui.TreeNodeFlags_.default_open)
        imgui.pop_font()
        self._note(f"group {group}")
        if not opened:
            return
        imgui.indent(0.8 * imgui.get_font_size())
        for tunable in tunables:
            width = min(LABEL_EM * imgui.get_font_size(), 0.42 * imgui.get_content_region_avail().x)
            self.places[tunable.name] = draw_tunable(tunable, view.settings, self._fonts, shown, width)
        imgui.unindent(0.8 * imgui.get_font_size())
        imgui.dummy(ImVec2(0.0, 0.15 * imgui.get_font_size()))

    def _note(self, name: str) -> None:
        low, high = imgui.get_item_rect_min(), imgui.get_item_rect_max()
        self.buttons[name] = Place(low.x, low.y, high.x, high.y, imgui.is_item_visible())


@lru_cache(maxsize=8)
def _groups(wanted: str) -> dict[str, list[Tunable]]:
    groups: dict[str, list[Tunable]] = {}
    for tunable in TUNABLES.values():
        if matches(tunable, wanted):
            groups.setdefault(tunable.group, []).append(tunable)
    return groups
