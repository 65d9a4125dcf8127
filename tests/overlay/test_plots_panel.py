"""The panel of live plots: its axes and colours, how often it is built, and that it lies where it should."""

import numpy as np
import pytest
from imgui_bundle import imgui

from game.overlay.layout import plots_area
from game.overlay.plan_plot import LEAST_REACH_M, PlanPlot
from game.overlay.plots_panel import REFRESHES_HZ
from game.overlay.time_plots import colours_of, round_up, span_of
from game.overlay.use_plot import _rows
from game.scenes.scene import Plot
from tests.overlay.conftest import PlayBox
from tests.overlay.pilot import Pilot

T = np.linspace(0.0, 9.0, 100)


def some_plots(count: int) -> tuple[Plot, ...]:
    square = np.array([-0.1, 0.1, 0.1, -0.1]), np.array([-0.1, -0.1, 0.1, 0.1])
    spot = np.array([0.05]), np.array([0.0])
    plan = Plot(
        "from above", "m", {"support": square, "left foot": square, "COM": spot, "COM wanted": spot}, kind="plan",
        looks={"support": "area", "left foot": "steps", "COM": "point", "COM wanted": "goal"}, note="A sentence about it.",
    )  # fmt: skip
    names = ("spine", "hip left", "hip right")
    share = np.arange(3.0), np.array([10.0, 50.0, 120.0])
    bars = Plot("use", "%", {"now": share, "most": share}, kind="bars", names=names)
    curves = tuple(
        Plot(f"curve {k}", "N", {"a": (T, np.sin(T)), "a planned": (T, np.cos(T))}, looks={"a planned": "planned"}) for k in range(count)
    )
    return (plan, bars, *curves)


def open_panel(pilot: Pilot, plots: tuple[Plot, ...]) -> list[float]:
    """Show the panel; the list grows by the time of each frame whose plots were asked for."""
    asked: list[float] = []

    def hand_out() -> tuple[Plot, ...]:
        asked.append(pilot.app.now_s)
        return plots

    pilot.app.scene.plots = hand_out  # type: ignore[method-assign]
    pilot.overlay.shown.plots = True
    pilot.frames(2)
    return asked


@pytest.mark.parametrize(("value", "top"), [(0.0, 1.0), (1.0, 1.0), (1.2, 1.5), (173.0, 200.0), (0.031, 0.04), (7.6, 10.0)])
def test_an_axis_ends_at_the_next_round_number(value: float, top: float) -> None:
    assert round_up(value) == pytest.approx(top)


def test_an_axis_begins_at_zero_unless_all_lies_close_together_far_above_it() -> None:
    assert span_of([np.array([0.0, 0.4, np.nan])]) == (0.0, 0.4)
    low, high = span_of([np.array([0.93, 0.96])])
    assert 0.85 <= low <= 0.93 and 0.96 <= high <= 1.05
    assert span_of([np.array([-3.0, 1.0])]) == (-3.0, 3.0)
    assert span_of([np.array([-1e-9, 1.0])]) == (0.0, 1.0), "a rounding error below zero is no reason to show what is below"
    assert span_of([np.array([np.nan]), np.zeros(0)]) == (0.0, 1.0)
    for low, high in (span_of([np.array([v, v])]) for v in (1e-12, 0.97, 5.0, 1e6)):
        assert low < high


def test_what_is_planned_has_the_colour_of_what_it_is_the_plan_for() -> None:
    colours = colours_of(Plot("loads", "%", {name: (T, T) for name in ("left", "right", "left planned", "right planned")}))
    assert colours["left"] == colours["left planned"] != colours["right"] == colours["right planned"]


def test_left_and_right_share_a_row() -> None:
    rows = _rows(("spine", "hip left", "hip right"), 20.0)
    assert [word for word, _ in rows.words] == ["spine", "hip"]
    spine, left, right = rows.middle
    assert spine < 10.0 < left < right < 20.0 and right - left > rows.thick


def test_the_view_from_above_holds_still_while_everything_fits() -> None:
    plan = PlanPlot()
    plan._aim([([-0.1, 0.1], [0.0, 0.2])], 1.5)
    middle, reach = plan._middle, plan._reach
    assert middle == pytest.approx((0.0, 0.1)) and reach == LEAST_REACH_M
    plan._aim([([-0.12, 0.08], [0.02, 0.2])], 1.5)
    assert plan._middle == middle
    plan._aim([([0.9, 1.1], [0.0, 1.0])], 1.5)
    assert plan._middle == pytest.approx((1.0, 0.5)) and plan._reach > 0.5
    plan._aim([([np.nan], [np.nan])], 1.5)
    assert plan._middle == pytest.approx((1.0, 0.5))


def test_plots_are_asked_for_fifteen_times_a_second_and_never_while_hidden(play_box: PlayBox) -> None:
    pilot = play_box()
    asked = open_panel(pilot, some_plots(4))
    first = len(asked)
    assert first >= 1, "at once when the panel is opened"
    pilot.frames(60)
    assert len(asked) - first == pytest.approx(REFRESHES_HZ, abs=1)
    pilot.overlay.shown.plots = False
    pilot.frames(30)
    hidden = len(asked)
    pilot.frames(30)
    assert len(asked) == hidden


def test_the_panel_is_drawn_in_every_frame_and_gone_once_it_is_closed(play_box: PlayBox) -> None:
    pilot = play_box()
    pilot.app.scene.drawables = lambda blend: ()  # type: ignore[method-assign]
    pilot.frames(5)
    area = plots_area(pilot.overlay.size, 18.0 * pilot.overlay.scale)
    rows, columns = slice(int(area.top) + 20, int(area.top + area.height) - 20), slice(int(area.left) + 5, int(area.right) - 5)

    def panel() -> np.ndarray:
        return pilot.app.output.read()[rows, columns].astype(int)

    open_panel(pilot, some_plots(4))
    for _ in range(6):
        pilot.frames(1)
        assert panel().mean() < 100.0, "dark where the backdrop is bright, whether or not it was built in this frame"
        assert panel().max() > 200
    pilot.overlay.shown.plots = False
    pilot.frames(2)
    assert panel().mean() > 100.0


def test_the_menu_lies_over_the_plots(play_box: PlayBox) -> None:
    pilot = play_box(size=(640, 360))
    open_panel(pilot, some_plots(4))
    plain = pilot.app.output.read()[60:300, 20:200].astype(int)
    pilot.overlay.shown.menu = True
    pilot.frames(3)
    dimmed = pilot.app.output.read()[60:300, 20:200].astype(int)
    assert np.percentile(dimmed, 99) < 0.8 * np.percentile(plain, 99)


def test_more_plots_than_fit_are_reached_by_the_wheel(play_box: PlayBox) -> None:
    pilot = play_box()
    open_panel(pilot, some_plots(30))
    area = plots_area(pilot.overlay.size, 18.0 * pilot.overlay.scale)
    before = pilot.app.output.read()
    pilot.move(area.left + area.width / 2, area.top + area.height / 2)
    assert pilot.overlay.wants_mouse
    pilot.wheel(-5.0)
    pilot.frames(3)
    assert pilot.overlay.plots._scrolled > 50.0
    moved = pilot.app.output.read() != before
    assert moved[int(area.top) + 20 : int(area.top) + 300, int(area.left) : int(area.right)].any()


@pytest.mark.parametrize(("width", "height", "content_scale"), [(1280, 720, 1.0), (1920, 1080, 2.0), (2560, 1440, 2.0)])
def test_the_plots_of_a_scene_fit_without_scrolling(
    play_box: PlayBox, monkeypatch: pytest.MonkeyPatch, width: int, height: int, content_scale: float
) -> None:
    monkeypatch.setattr("glfw.get_window_content_scale", lambda _window: (content_scale, content_scale))
    pilot = play_box(size=(width, height))
    open_panel(pilot, some_plots(8))
    style = imgui.get_style()
    inner = plots_area(pilot.overlay.size, 18.0 * pilot.overlay.scale).height - 2 * style.window_padding.y
    assert 0.8 * inner < pilot.overlay.plots._height <= inner
