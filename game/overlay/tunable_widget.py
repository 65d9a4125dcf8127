"""One tunable as a slider, a checkbox or a choice, with its tooltip and its reset."""

from dataclasses import dataclass

from imgui_bundle import ImVec2, ImVec4, imgui

from game.overlay.style import ACCENT, FAINT, Fonts, packed
from game.overlay.tunable_words import command_words, label, number_format, range_words, rounded, value_words
from game.overlay.view import Shown
from game.tunables import Settings, Tunable


@dataclass(frozen=True)
class Place:
    """Where a widget was drawn, overlay units; visible: not scrolled out of sight."""

    left: float
    top: float
    right: float
    bottom: float
    visible: bool


def draw_tunable(tunable: Tunable, settings: Settings, fonts: Fonts, shown: Shown, label_width: float) -> Place:
    """A row: the name at the left (marked where it differs from the default), the control at the right. Writes into `settings`."""
    imgui.push_id(tunable.name)
    changed = settings.get(tunable.name) != tunable.default
    left = imgui.get_cursor_screen_pos().x
    imgui.align_text_to_frame_padding()
    imgui.push_style_color(imgui.Col_.text, ImVec4(*(ACCENT if changed else imgui.get_style_color_vec4(imgui.Col_.text))))
    imgui.text(label(tunable))
    imgui.pop_style_color()
    _tooltip(tunable, settings, fonts)
    imgui.same_line()
    imgui.set_cursor_screen_pos(ImVec2(left + label_width, imgui.get_cursor_screen_pos().y))
    imgui.set_next_item_width(-1.0)
    _control(tunable, settings)
    low, high = imgui.get_item_rect_min(), imgui.get_item_rect_max()
    place = Place(low.x, low.y, high.x, high.y, imgui.is_item_visible())
    if changed:
        middle = ImVec2(left - 0.45 * imgui.get_font_size(), (low.y + high.y) / 2)
        imgui.get_window_draw_list().add_circle_filled(middle, 0.16 * imgui.get_font_size(), packed(ACCENT))
    _tooltip(tunable, settings, fonts)
    _context_menu(tunable, settings, shown)
    imgui.pop_id()
    return place


def _control(tunable: Tunable, settings: Settings) -> None:
    name = tunable.name
    if isinstance(tunable.default, bool):
        touched, on = imgui.checkbox("##value", settings.switch(name))
        if touched:
            settings.set(name, on)
    elif tunable.choices:
        if imgui.begin_combo("##value", settings.choice(name)):
            for choice in tunable.choices:
                picked, _ = imgui.selectable(choice, choice == settings.choice(name))
                if picked:
                    settings.set(name, choice)
            imgui.end_combo()
    else:
        flags = imgui.SliderFlags_.always_clamp | (imgui.SliderFlags_.logarithmic if tunable.log else 0)
        touched, value = imgui.slider_float("##value", settings.number(name), tunable.low, tunable.high, number_format(tunable), flags)
        if touched:
            settings.set(name, rounded(tunable, value))


def _context_menu(tunable: Tunable, settings: Settings, shown: Shown) -> None:
    if not imgui.begin_popup_context_item("reset"):
        return
    if imgui.menu_item_simple(f"Reset to {value_words(tunable, tunable.default)}"):
        settings.reset([tunable.name])
    if imgui.menu_item_simple(f"Copy {command_words(tunable, settings)}"):
        imgui.set_clipboard_text(command_words(tunable, settings))
        shown.ask("say", f"Copied {command_words(tunable, settings)}")
    imgui.end_popup()


def _tooltip(tunable: Tunable, settings: Settings, fonts: Fonts) -> None:
    if imgui.is_item_active() or not imgui.is_item_hovered(imgui.HoveredFlags_.for_tooltip) or not imgui.begin_tooltip():
        return
    imgui.push_text_wrap_pos(26.0 * imgui.get_font_size())
    imgui.push_font(fonts.strong, 0.0)
    imgui.text(tunable.name)
    imgui.pop_font()
    imgui.text(tunable.meaning[:1].upper() + tunable.meaning[1:] + ".")
    imgui.separator()
    faint = ImVec4(*FAINT)
    imgui.text_colored(faint, f"unit: {tunable.unit or 'none'}    default: {value_words(tunable, tunable.default)}")
    imgui.text_colored(faint, f"valid: {range_words(tunable)}")
    imgui.text_colored(faint, command_words(tunable, settings))
    if tunable.restart:
        imgui.text_colored(ImVec4(*ACCENT), "takes effect at restart")
    if not tunable.choices and not isinstance(tunable.default, bool):
        imgui.text_colored(faint, "Ctrl+click types a value, right click resets")
    imgui.pop_text_wrap_pos()
    imgui.end_tooltip()
