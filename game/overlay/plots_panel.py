"""The panel at the left: what each stage of a frame costs, and the scene's live plots."""

from imgui_bundle import ImVec2, imgui

from game.overlay.docked import begin_docked
from game.overlay.layout import plots_area
from game.overlay.line_breaks import lines_within
from game.overlay.plan_plot import LEGEND_EM, PlanPlot
from game.overlay.sheet import Sheet
from game.overlay.stage_bar import draw_stage_bar
from game.overlay.still_layer import StillLayer
from game.overlay.style import FAINT, INK
from game.overlay.time_plots import GAP_EM, TITLE_EM, TimePlots, rows_of
from game.overlay.use_plot import draw_use
from game.overlay.view import Shown, View
from game.scenes.scene import Plot

REFRESHES_HZ = 15.0
PLAN_EM = (7.5, 12.0)
GRAPH_EM = (1.8, 4.0)
SMALL = 0.7
NOTE_EM = 0.9
PLAN_SHARE = 0.56
"""Of the width, where bars stand beside the view from above."""


class PlotsPanel:
    """Stages, the view from above with the bars beside it, then everything over time.

    It is built anew REFRESHES_HZ times a second and drawn as it is in between: nobody reads a curve faster.
    """

    def __init__(self) -> None:
        self._layer: StillLayer | None = None
        self._built: tuple[float, tuple[float, float], float] | None = None
        self._height = self._scrolled = 0.0
        self._over_time = TimePlots()
        self._plans: dict[str, PlanPlot] = {}
        self._said: tuple[str, float] = ("", 0.0)
        self._lines: list[str] = []

    def due(self, shown: Shown, now_s: float, size: tuple[float, float]) -> bool:
        """Whether the plots are shown and the frame at `now_s` is to show them anew, on a screen of `size` overlay units."""
        if not shown.plots:
            return False
        if self._built is None or self._built[1:] != (size, self._scrolled):
            return True
        return abs(now_s - self._built[0]) >= 1.0 / REFRESHES_HZ - 1e-3

    def build(self, view: View, shown: Shown, size: tuple[float, float], scale: float) -> None:
        """Before the frame of the overlay begins: what is to be seen of a view, where that is due."""
        if not shown.plots:
            self._built = None
        if not self.due(shown, view.now_s, size):
            return
        if self._layer is None:
            self._layer = StillLayer()
            self._sheet = Sheet(self._layer.fonts)
        self._built = view.now_s, size, self._scrolled
        with self._layer.building(size, scale):
            self._draw_panel(view, size)

    def draw(self, shown: Shown, size: tuple[float, float], em: float) -> None:
        """Within the frame of the overlay: at the left edge of the screen, a window that takes mouse and wheel for what was built."""
        if shown.plots:
            begin_docked("plots", plots_area(size, em), imgui.WindowFlags_.no_background)
            imgui.dummy(ImVec2(1.0, self._height))
            self._scrolled = imgui.get_scroll_y()
            imgui.end()

    def paint(self, shown: Shown) -> None:
        """After the frame of the overlay, and before that is painted: what was built, below it."""
        if shown.plots and self._layer is not None:
            self._layer.draw()

    def close(self) -> None:
        """Give everything back; the window must still be there."""
        if self._layer is not None:
            self._layer.close()
            self._layer = None

    def _draw_panel(self, view: View, size: tuple[float, float]) -> None:
        style = imgui.get_style()
        em = style.font_size_base * style.font_scale_dpi
        imgui.set_next_window_scroll(ImVec2(0.0, self._scrolled))
        begin_docked("plots", plots_area(size, em), imgui.WindowFlags_.no_scrollbar)
        start = imgui.get_cursor_pos_y()
        draw_stage_bar(view.stage_ms, self._sheet.fonts)
        upper = [plot for plot in view.plots if plot.kind in ("plan", "bars")]
        over_time = [plot for plot in view.plots if plot.kind == "time"]
        room = imgui.get_content_region_avail()
        # the window that takes the wheel may have a scroll bar there
        width = room.x - (style.scrollbar_size if self._height > room.y + imgui.get_cursor_pos_y() - start else 0.0)
        self._sheet.em = em
        notes = self._notes(upper, width)
        above = (TITLE_EM + LEGEND_EM + NOTE_EM * len(notes) + GAP_EM) * em if upper else 0.0
        rows = rows_of(len(over_time))
        plan, graph = _heights(bool(upper), rows, room.y - above - rows * (TITLE_EM + GAP_EM) * em, em)
        height = above + plan + rows * ((TITLE_EM + GAP_EM) * em + graph)
        self._height = imgui.get_cursor_pos_y() - start + height
        if height > 0.0 and self._sheet.begin(width, height):
            self._draw_upper(upper, width, (TITLE_EM + LEGEND_EM) * em + plan)
            for k, line in enumerate(notes):
                self._sheet.words(0.0, (TITLE_EM + LEGEND_EM + NOTE_EM * k) * em + plan, line, FAINT, SMALL)
            self._over_time.draw(self._sheet, over_time, above + plan, width, graph)
            self._sheet.end()
        imgui.end()

    def _draw_upper(self, plots: list[Plot], width: float, height: float) -> None:
        sheet, em, x = self._sheet, self._sheet.em, 0.0
        for plot in plots:
            share = 1.0 if len(plots) == 1 else (PLAN_SHARE if plot.kind == "plan" else 1.0 - PLAN_SHARE)
            room = share * width - 0.7 * em
            title = plot.title[:1].upper() + plot.title[1:]
            sheet.words(x, 0.0, title if plot.kind == "plan" else f"{title}, {plot.unit}", INK, 0.75, strong=True)
            box = x, TITLE_EM * em, room, height - (TITLE_EM + 0.2) * em
            if plot.kind == "plan":
                self._plans.setdefault(plot.title, PlanPlot()).draw(sheet, plot, *box)
            else:
                draw_use(sheet, plot, *box)
            x += room + 0.9 * em

    def _notes(self, plots: list[Plot], width: float) -> list[str]:
        """What has to be said about them, in lines over the whole width."""
        sheet, said = self._sheet, " ".join(plot.note for plot in plots if plot.note)
        if self._said != (said, width):
            self._said, self._lines = (said, width), lines_within(said, width, lambda text: sheet.width(text, SMALL))
        return self._lines


def _heights(upper: bool, rows: int, free: float, em: float) -> tuple[float, float]:
    """Of the view from above and of a box over time, so that all of them fill what is free, where that is enough."""
    plan = min(max(0.45 * free, PLAN_EM[0] * em), PLAN_EM[1] * em) if upper else 0.0
    return plan, min(max((free - plan) / max(1, rows), GRAPH_EM[0] * em), GRAPH_EM[1] * em)
