"""The windows in the middle: the Esc menu and the F1 list of keys."""

from imgui_bundle import ImVec2, ImVec4, imgui

from game.overlay.style import ACCENT, FAINT, Fonts, alpha
from game.overlay.tunable_widget import Place
from game.overlay.view import Shown, View
from game.shortcuts import MOUSE_HELP, SHORTCUTS

FIXED = (
    imgui.WindowFlags_.no_title_bar
    | imgui.WindowFlags_.no_resize
    | imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_collapse
    | imgui.WindowFlags_.always_auto_resize
)


class Menu:
    """Draws the menu while `shown.menu`; `buttons` says where each button was drawn in the last frame."""

    def __init__(self, fonts: Fonts) -> None:
        self._fonts = fonts
        self.buttons: dict[str, Place] = {}

    def draw(self, view: View, shown: Shown, size: tuple[float, float]) -> None:
        """In the middle of a screen of `size` overlay units, over a dimmed picture."""
        self.buttons.clear()
        if not shown.menu:
            return
        em = imgui.get_style().font_size_base * imgui.get_style().font_scale_dpi
        _dim(size)
        _centre(size)
        imgui.begin("menu", None, FIXED)
        if imgui.is_window_appearing():
            imgui.set_window_focus()
            imgui.set_nav_cursor_visible(True)  # it was a key or a gamepad that opened the menu
        wide = ImVec2(min(19.0 * em, 0.8 * size[0]), 0.0)
        _heading("Topple", self._fonts, 1.9, self._fonts.display)
        big = ImVec2(wide.x, 2.1 * em)
        if self._button("Continue", big):
            shown.menu = False
        imgui.set_item_default_focus()
        if self._button("Restart", big):
            shown.ask("restart")
            shown.menu = False
        self._scenes(view, shown, wide.x)
        self._inputs(view, shown, wide.x)
        if self._button("Tune every number", wide):
            shown.panel, shown.menu = True, False
        if self._button("Keys and shortcuts", wide):
            shown.help, shown.menu = True, False
        if self._button("Quit", wide):
            shown.ask("quit")
        imgui.end()

    def _scenes(self, view: View, shown: Shown, width: float) -> None:
        if not view.scenes:
            return
        _heading("Scene", self._fonts)
        gap = imgui.get_style().item_spacing.x
        each = (width - gap * (len(view.scenes) - 1)) / len(view.scenes)
        for number, scene in enumerate(view.scenes):
            if number:
                imgui.same_line()
            chosen = scene == view.scene
            imgui.push_style_color(
                imgui.Col_.button, ImVec4(*alpha(ACCENT, 0.55)) if chosen else imgui.get_style_color_vec4(imgui.Col_.button)
            )
            if self._button(scene, ImVec2(each, 0.0)) and not chosen:
                shown.ask("scene", scene)
                shown.menu = False
            imgui.pop_style_color()

    def _inputs(self, view: View, shown: Shown, width: float) -> None:
        _heading("Input", self._fonts)
        if view.status:
            imgui.push_text_wrap_pos(imgui.get_cursor_pos_x() + width)
            imgui.text_colored(ImVec4(*FAINT), view.status)
            imgui.pop_text_wrap_pos()
        if view.inputs:
            imgui.set_next_item_width(width)
            if imgui.begin_combo("##input", view.input_spec or "choose an input"):
                for spec in view.inputs:
                    picked, _ = imgui.selectable(spec, spec == view.input_spec)
                    if picked:
                        shown.ask("input", spec)
                        shown.menu = False
                imgui.end_combo()
            self._note("input")
        imgui.text_colored(ImVec4(*FAINT), "or drop a recording onto the window")
        imgui.dummy(ImVec2(0.0, 0.4 * imgui.get_font_size()))

    def _button(self, caption: str, size: ImVec2) -> bool:
        pressed = imgui.button(caption, size)
        self._note(caption)
        return pressed

    def _note(self, name: str) -> None:
        low, high = imgui.get_item_rect_min(), imgui.get_item_rect_max()
        self.buttons[name] = Place(low.x, low.y, high.x, high.y, imgui.is_item_visible())


def draw_help(view: View, shown: Shown, fonts: Fonts, size: tuple[float, float]) -> None:
    """Every key: the scene's own at the left, the window's at the right."""
    if not shown.help:
        return
    _dim(size)
    _centre(size)
    imgui.begin("help", None, FIXED)
    _heading("Keys", fonts, 1.5, fonts.display)
    if imgui.begin_table("columns", 2, imgui.TableFlags_.sizing_fixed_fit):
        imgui.table_next_column()
        _heading("Play", fonts)
        _pairs("play", (*view.help_keys, *MOUSE_HELP), fonts)
        imgui.table_next_column()
        _heading("Window", fonts)
        cameras = [("1-9", "cameras: " + ", ".join(view.cameras))] if view.cameras else []
        window = [(s.shown, s.meaning) for s in SHORTCUTS.values() if not s.action.startswith("camera")]
        _pairs("window", (*window, *cameras), fonts)
        imgui.end_table()
    imgui.text_colored(ImVec4(*FAINT), "F1 closes this")
    imgui.end()


def _pairs(name: str, pairs: tuple[tuple[str, str], ...], fonts: Fonts) -> None:
    em = imgui.get_font_size()
    if not imgui.begin_table(name, 2, imgui.TableFlags_.sizing_fixed_fit, ImVec2(21.0 * em, 0.0)):
        return
    imgui.table_setup_column("key", imgui.TableColumnFlags_.width_fixed, 5.8 * em)
    imgui.table_setup_column("meaning", imgui.TableColumnFlags_.width_stretch)
    for keys, meaning in pairs:
        imgui.table_next_column()
        imgui.push_font(fonts.strong, 0.0)
        imgui.text_colored(ImVec4(*ACCENT), keys)
        imgui.pop_font()
        imgui.table_next_column()
        imgui.text_wrapped(meaning)
    imgui.end_table()


def _heading(text: str, fonts: Fonts, size: float = 1.0, font: imgui.ImFont | None = None) -> None:
    imgui.dummy(ImVec2(0.0, 0.15 * imgui.get_font_size()))
    imgui.push_font(font or fonts.strong, size * imgui.get_style().font_size_base)
    imgui.text(text)
    imgui.pop_font()


def _dim(size: tuple[float, float]) -> None:
    imgui.get_background_draw_list().add_rect_filled(ImVec2(0, 0), ImVec2(*size), imgui.get_color_u32(imgui.Col_.modal_window_dim_bg))


def _centre(size: tuple[float, float]) -> None:
    imgui.set_next_window_pos(ImVec2(size[0] / 2, size[1] / 2), imgui.Cond_.always, ImVec2(0.5, 0.5))
    imgui.set_next_window_size_constraints(ImVec2(0.0, 0.0), ImVec2(0.96 * size[0], 0.96 * size[1]))
