"""Words, toasts and plots: what the overlay says is what the scene and the tunables say."""

import numpy as np
import pytest

from game.overlay.toasts import FADE_S, STAY_S, Toasts
from game.overlay.tunable_words import command_words, decimals, label, matches, number_format, rounded, value_words
from game.scenes.scene import Plot
from game.tunables import TUNABLES, Settings
from tests.app.bouncing_box import BouncingBox
from tests.overlay.conftest import PlayBox


def test_a_label_drops_group_and_unit() -> None:
    assert label(TUNABLES["balance.ankle_clamp_rad"]) == "ankle clamp"
    assert label(TUNABLES["ik.target_clamp_m"]) == "target clamp"
    assert label(TUNABLES["balance.w_com"]) == "w com"


@pytest.mark.parametrize("name", [n for n, t in TUNABLES.items() if not t.choices and not isinstance(t.default, bool)])
def test_a_slider_shows_its_default_to_about_a_hundredth_of_the_range(name: str) -> None:
    tunable = TUNABLES[name]
    shown = float((number_format(tunable) % tunable.default).split()[0])
    assert shown == pytest.approx(float(tunable.default), abs=0.01 * (tunable.high - tunable.low))
    assert decimals(tunable) <= 6
    assert rounded(tunable, float(np.float32(tunable.high))) <= tunable.high


def test_single_precision_leaves_no_trace() -> None:
    assert rounded(TUNABLES["balance.w_vel"], float(np.float32(0.1))) == 0.1


@pytest.mark.parametrize("name", TUNABLES)
def test_the_command_line_words_of_a_tunable_set_it_to_the_same_value(name: str) -> None:
    settings = Settings()
    option, _, assignment = command_words(TUNABLES[name], settings).partition(" ")
    assert option == "--set"
    target, _, value = assignment.partition("=")
    other = Settings()
    other.set(target, value)
    expected = settings.get(name)
    assert other.get(name) == (expected if isinstance(expected, str) else pytest.approx(expected, rel=1e-5))


def test_values_are_shown_in_words() -> None:
    assert value_words(TUNABLES["intake.mirror"], True) == "on"
    assert value_words(TUNABLES["pd.kp_hat"], 800.0) == "800 N m/rad"


def test_the_filter_finds_by_meaning() -> None:
    assert matches(TUNABLES["ik.damping"], "least squares")
    assert not matches(TUNABLES["ik.damping"], "friction")


def test_a_message_shows_once_and_fades() -> None:
    toasts = Toasts()
    toasts.follow(("a",), 0.0)
    toasts.follow(("a", "b"), 3.0)
    assert [t.text for t in toasts.visible(3.0)] == ["a", "b"]
    assert [t.text for t in toasts.visible(STAY_S + 0.01)] == ["b"]
    assert 0.0 < toasts.visible(3.0 + STAY_S - FADE_S / 2)[0].opacity(3.0 + STAY_S - FADE_S / 2) < 1.0
    toasts.follow(("b", "c"), 9.0)
    assert [t.text for t in toasts.visible(9.0)] == ["c"]


def test_the_banner_shows_when_the_score_changes(play_box: PlayBox) -> None:
    scene = BouncingBox()
    pilot = play_box(scene=scene)
    pilot.frames(3)
    assert pilot.overlay.hud._banner is None
    scene.points, scene.said = "You 3 : 1 Rival", (*scene.said, "Rival fell")
    pilot.frames(1)
    assert pilot.overlay.hud._banner is not None
    assert pilot.overlay.hud._banner[0] == "Rival fell"
    pilot.frames(60 * 3)
    assert pilot.overlay.hud._banner is None


def test_plots_of_every_shape_draw_without_a_fault(play_box: PlayBox) -> None:
    t, none, hole = np.linspace(0, 3, 50), np.zeros(0), np.array([0.0, np.nan, 1.0])
    plots = (
        Plot("empty", "m", {"nothing": (none, none)}),
        Plot("holes", "rad", {"a": (np.arange(3.0), hole)}),
        Plot("strided", "N", {"a": (np.column_stack([t, t])[:, 0], t), "b": (t, -t)}),
        Plot("plan", "m", {"support polygon": (none, none), "COM": (np.array([np.nan]), np.array([0.0]))}, kind="plan"),
        Plot("trail", "m", {"COM path": (t, t), "support polygon": (np.array([0, 1, 1.0]), np.array([0, 0, 1.0]))}, kind="plan"),
    )
    pilot = play_box()
    pilot.app.scene.plots = lambda: plots  # type: ignore[method-assign]
    pilot.overlay.shown.plots = True
    before = pilot.app.output.read()
    pilot.frames(4)
    assert (pilot.app.output.read() != before).any()


def test_a_message_said_twice_is_shown_twice_and_old_ones_do_not_come_back() -> None:
    toasts = Toasts()
    toasts.follow(("Rival fell",), 0.0)
    toasts.follow(("Rival fell", "Rival fell"), 20.0)
    assert [(t.text, t.came_s) for t in toasts.visible(20.0)] == [("Rival fell", 20.0)]
    toasts.follow(("Rival fell",), 40.0)
    assert toasts.visible(40.0) == []


def test_the_inputs_status_is_one_line_and_never_a_message_as_well(play_box: PlayBox) -> None:
    scene = BouncingBox()
    pilot = play_box(scene=scene)
    scene.said = ("The puppet follows keys (a kick)", "It fell after 2.0 s")
    pilot.frames(1)
    scene.said = ("The puppet follows keys", "It fell after 2.0 s")
    pilot.frames(1)
    assert [t.text for t in pilot.overlay.hud.toasts.visible(pilot.app.now_s)] == ["It fell after 2.0 s"]
