"""The panel at the left: what each stage of a frame costs, and the scene's live plots."""

import numpy as np
from imgui_bundle import ImVec2, ImVec4, imgui, implot
from numpy.typing import NDArray

from game.overlay.docked import begin_docked
from game.overlay.layout import plots_area
from game.overlay.stage_bar import draw_stage_bar
from game.overlay.style import Fonts, Rgba
from game.overlay.view import Shown, View
from game.scenes.scene import Plot

TIME_SPAN_S = 10.0
LINES: tuple[Rgba, ...] = (
    (1.00, 0.70, 0.26, 1.0), (0.40, 0.80, 0.96, 1.0), (0.56, 0.86, 0.50, 1.0), (0.93, 0.50, 0.74, 1.0),
    (0.80, 0.72, 0.98, 1.0), (0.95, 0.90, 0.55, 1.0), (0.98, 0.48, 0.38, 1.0), (0.55, 0.90, 0.85, 1.0),
)  # fmt: skip


def draw_plots(view: View, shown: Shown, fonts: Fonts, size: tuple[float, float]) -> None:
    """At the left edge of a screen of `size` overlay units, below the input's line."""
    if not shown.plots:
        return
    em = imgui.get_style().font_size_base * imgui.get_style().font_scale_dpi
    begin_docked("plots", plots_area(size, em))
    draw_stage_bar(view.stage_ms, fonts)
    for plot in view.plots:
        imgui.push_font(fonts.strong, 0.9 * imgui.get_style().font_size_base)
        title = plot.title[:1].upper() + plot.title[1:]
        imgui.text(f"{title}, {plot.unit}" if plot.unit else title)
        imgui.pop_font()
        imgui.push_font(None, 0.8 * imgui.get_style().font_size_base)
        if plot.kind == "plan":
            _plan(plot, em)
        else:
            _time(plot, em)
        imgui.pop_font()
    imgui.end()


def _time(plot: Plot, em: float) -> None:
    flags = implot.Flags_.no_title | implot.Flags_.no_menus | implot.Flags_.no_mouse_text
    if len(plot.series) < 2:
        flags |= implot.Flags_.no_legend
    if not implot.begin_plot(f"##{plot.title}", ImVec2(-1.0, 7.0 * em), flags):
        return
    implot.setup_axes("", "", implot.AxisFlags_.no_label, implot.AxisFlags_.no_label | implot.AxisFlags_.auto_fit)
    newest = max((float(x[-1]) for x, _ in plot.series.values() if len(x)), default=0.0)
    implot.setup_axis_limits(implot.ImAxis_.x1, newest - TIME_SPAN_S, newest, implot.Cond_.always)
    implot.setup_legend(implot.Location_.north_west, implot.LegendFlags_.horizontal)
    for number, (name, (x, y)) in enumerate(plot.series.items()):
        if len(x):
            implot.plot_line(name, _array(x), _array(y), _spec(LINES[number % len(LINES)], 1.6))
    implot.end_plot()


def _plan(plot: Plot, em: float) -> None:
    flags = implot.Flags_.no_title | implot.Flags_.no_menus | implot.Flags_.equal
    if not implot.begin_plot(f"##{plot.title}", ImVec2(-1.0, 12.5 * em), flags):
        return
    implot.setup_axes("right", "forward", 0, 0)
    centre, reach = _extent(plot)
    implot.setup_axis_limits(implot.ImAxis_.x1, centre[0] - reach, centre[0] + reach, implot.Cond_.always)
    implot.setup_axis_limits(implot.ImAxis_.y1, centre[1] - reach, centre[1] + reach, implot.Cond_.always)
    implot.setup_legend(implot.Location_.south, implot.LegendFlags_.outside | implot.LegendFlags_.horizontal)
    for number, (name, (x, y)) in enumerate(plot.series.items()):
        colour = LINES[number % len(LINES)]
        if len(x) == 1:
            implot.plot_scatter(name, _array(x), _array(y), _spec(colour, 1.5, marker=number))
        elif len(x) > 2 and ("polygon" in name or "support" in name):
            outline = np.append(x, x[0]), np.append(y, y[0])
            implot.plot_polygon(name, _array(x), _array(y), _spec(colour, 1.5, fill=0.22))
            implot.plot_line(name, _array(outline[0]), _array(outline[1]), _spec(colour, 1.5))
        elif len(x):
            implot.plot_line(name, _array(x), _array(y), _spec(colour, 1.5))
            implot.plot_scatter(name, _array(x[-1:]), _array(y[-1:]), _spec(colour, 1.5, marker=number))
    implot.end_plot()


def _extent(plot: Plot) -> tuple[NDArray[np.float64], float]:
    """Middle (2,) of all points and a half width that holds them, in steps, so that the frame does not tremble."""
    points = [np.column_stack([x, y]) for x, y in plot.series.values() if len(x)]
    if not points:
        return np.zeros(2), 0.25
    every = np.vstack(points)
    every = every[np.isfinite(every).all(axis=1)]
    if not len(every):
        return np.zeros(2), 0.25
    centre = np.round((every.min(axis=0) + every.max(axis=0)) / 2 / 0.05) * 0.05
    return centre, max(0.25, float(np.ceil(np.abs(every - centre).max() / 0.1 + 0.3) * 0.1))


def _array(values: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.ascontiguousarray(values, dtype=np.float64)


def _spec(colour: Rgba, weight: float, fill: float = 1.0, marker: int = -1) -> implot.Spec:
    spec = implot.Spec()
    spec.line_color = spec.fill_color = spec.marker_line_color = spec.marker_fill_color = ImVec4(*colour)
    spec.line_weight = weight
    spec.fill_alpha = fill
    if marker >= 0:
        spec.marker = (implot.Marker_.circle, implot.Marker_.cross, implot.Marker_.diamond, implot.Marker_.plus)[marker % 4]
        spec.marker_size = 5.0
    return spec
