"""Milliseconds of each stage against the 16.7 ms of a 60 Hz frame, as one bar."""

from collections.abc import Mapping

from imgui_bundle import ImVec2, ImVec4, imgui

from game.overlay.style import ACCENT, COOL, FAINT, GOOD, INK, WARN, Fonts, Rgba, packed
from game.stage_times import FRAME_BUDGET_MS

COLOURS: tuple[Rgba, ...] = (ACCENT, COOL, GOOD, (0.93, 0.50, 0.74, 1.0), (0.80, 0.72, 0.98, 1.0), (0.95, 0.90, 0.55, 1.0))


def draw_stage_bar(stage_ms: Mapping[str, float], fonts: Fonts) -> None:
    """A heading with the sum, the bar with a mark at the budget, and one coloured entry per stage."""
    total = sum(stage_ms.values())
    imgui.push_font(fonts.strong, 0.9 * imgui.get_style().font_size_base)
    imgui.text("Time per frame, ms")
    imgui.pop_font()
    imgui.same_line()
    imgui.push_font(None, 0.9 * imgui.get_style().font_size_base)
    imgui.text_colored(ImVec4(*(WARN if total > FRAME_BUDGET_MS else FAINT)), f"{total:.1f} of {FRAME_BUDGET_MS:.1f}")
    imgui.pop_font()
    em, start = imgui.get_font_size(), imgui.get_cursor_screen_pos()
    width, height = imgui.get_content_region_avail().x, 0.8 * em
    longest = max(FRAME_BUDGET_MS * 1.15, total)
    canvas = imgui.get_window_draw_list()
    canvas.add_rect_filled(start, ImVec2(start.x + width, start.y + height), packed((1, 1, 1, 0.07)), 0.2 * em)
    x = start.x
    for number, ms in enumerate(stage_ms.values()):
        end = x + width * ms / longest
        canvas.add_rect_filled(
            ImVec2(x, start.y), ImVec2(max(x + 1.0, end - 1.0), start.y + height), packed(COLOURS[number % len(COLOURS)])
        )
        x = end
    mark = start.x + width * FRAME_BUDGET_MS / longest
    canvas.add_line(ImVec2(mark, start.y - 0.15 * em), ImVec2(mark, start.y + height + 0.15 * em), packed(INK), max(1.0, em / 10))
    imgui.dummy(ImVec2(width, height + 0.1 * em))
    _legend(stage_ms, start.x + width)


def _legend(stage_ms: Mapping[str, float], right: float) -> None:
    imgui.push_font(None, 0.85 * imgui.get_style().font_size_base)
    em = imgui.get_font_size()
    for number, (stage, ms) in enumerate(stage_ms.items()):
        words = f"{stage} {ms:.2f}"
        if number:
            imgui.same_line(0.0, 0.9 * em)
            if imgui.get_cursor_screen_pos().x + imgui.calc_text_size(words).x > right:
                imgui.new_line()
        imgui.text_colored(ImVec4(*COLOURS[number % len(COLOURS)]), words)
    imgui.pop_font()
    imgui.dummy(ImVec2(0.0, 0.2 * em))
