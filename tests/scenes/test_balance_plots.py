"""What the live plots show is what the body does and what its strategy plans, and what a strategy does not plan is said in words."""

import numpy as np
import pytest

from game.scenes.mirror import Mirror
from game.scenes.scene import Plot
from game.tunables import Settings
from tests.scenes.staged import make_scene, run_s

STRATEGIES = ("whole-body", "ankle", "virtual-actuation", "none")


def mirror(spec: str, seconds: float, **values: str) -> Mirror:
    scene = make_scene("mirror", spec, Settings({name.replace("__", "."): value for name, value in values.items()}))
    scene.enter()
    run_s(scene, seconds)
    assert isinstance(scene, Mirror)
    return scene


def by_title(scene: Mirror) -> dict[str, Plot]:
    return {plot.title: plot for plot in scene.plots()}


@pytest.fixture(scope="module")
def standing() -> Mirror:
    return mirror("performer:standing", 2.5)


@pytest.fixture(scope="module")
def strolling() -> tuple[Mirror, set[str]]:
    """A mirror of somebody who steps, and every look its feet had on the way."""
    scene = mirror("performer:stepping", 1.0)
    looks: set[str] = set()
    while scene.time_s < 4.0:
        scene.fixed_update()
        looks |= {look for name, look in scene.plots()[0].looks.items() if name in ("left foot", "right foot")}
    return scene, looks


def test_who_stands_still_bears_his_weight_on_both_feet_as_planned(standing: Mirror) -> None:
    loads = {name: curve[1] for name, curve in by_title(standing)["foot loads"].series.items()}
    both = (loads["left"] + loads["right"])[-10:]
    assert both == pytest.approx(np.full(10, 100.0), abs=3.0)
    for side in ("left", "right"):
        assert loads[side][-10:] == pytest.approx(loads[f"{side} planned"][-10:], abs=8.0)


def test_who_stands_still_is_drawn_with_every_point_over_the_support(standing: Mirror) -> None:
    plan = by_title(standing)["balance from above"]
    right, forward = plan.series["support"]
    for name in ("COM", "capture point", "capture point wanted", "pressure", "pressure wanted"):
        x, y = plan.series[name]
        assert right.min() < x[0] < right.max() and forward.min() < y[0] < forward.max(), name
    assert (plan.looks["left foot"], plan.looks["right foot"]) == ("stands", "stands")
    assert plan.series["left foot"][0].max() < plan.series["right foot"][0].min(), "right is to the right"


def test_feet_that_follow_the_player_s_are_drawn_so_and_the_load_goes_over(strolling: tuple[Mirror, set[str]]) -> None:
    scene, looks = strolling
    assert {"stands", "follows"} <= looks
    loads = by_title(scene)["foot loads"].series
    assert loads["left"][1].min() < 3.0 and loads["right"][1].min() < 3.0
    assert loads["left"][1].max() > 90.0 and loads["right"][1].max() > 90.0


def test_torques_stay_within_the_limits_and_the_most_is_not_below_the_present(strolling: tuple[Mirror, set[str]]) -> None:
    use = by_title(strolling[0])["torque use"]
    now, most = use.series["now"][1], use.series["most"][1]
    assert len(use.names) == len(now) == 14
    assert now.min() >= 0.0 and 5.0 < most.max() <= 100.0 + 1e-6
    hardest = by_title(strolling[0])["hardest joint"].series["use"][1]
    assert hardest.max() == pytest.approx(most.max())


def test_a_flight_is_drawn_as_one_and_without_a_pressure() -> None:
    scene = mirror("performer:jump", 2.0)
    flown = False
    while scene.time_s < 6.0 and not flown:
        scene.fixed_update()
        plan = scene.plots()[0]
        flown = "flies" in plan.looks.values() and not plan.series.keys() & {"pressure", "pressure wanted"}
    assert flown


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_what_a_strategy_does_not_plan_is_left_out_and_said(strategy: str) -> None:
    plots = by_title(mirror("performer:standing", 0.5, balance__strategy=strategy))
    plan, loads, errors = plots["balance from above"], plots["foot loads"], plots["errors"]
    planned = strategy == "whole-body"
    assert ("capture point wanted" in plan.series) == ("pressure wanted" in plan.series) == planned
    assert ("left planned" in loads.series) == ("capture point" in errors.series) == planned
    assert ("COM wanted" in plan.series) == ("COM" in errors.series) == (strategy in ("ankle", "virtual-actuation"))
    assert {"capture point", "COM", "support"} <= plan.series.keys() and {"left", "right"} <= loads.series.keys()
    assert planned or f"Strategy {strategy}" in plan.note
    assert ("limit at its speed" in plots["torque use"].note) == planned


def test_a_strategy_exchanged_live_takes_its_plan_with_it() -> None:
    settings = Settings()
    scene = make_scene("mirror", "performer:standing", settings)
    scene.enter()
    run_s(scene, 0.5)
    settings.set("balance.strategy", "ankle")
    run_s(scene, 1.0)
    assert isinstance(scene, Mirror)
    plots = by_title(scene)
    assert "capture point wanted" not in plots["balance from above"].series
    planned = plots["foot loads"].series["left planned"][1]
    assert np.isfinite(planned).any() and np.isnan(planned[-4:]).all(), "the curve ends where the plan did"
    scene.leave()


def test_in_the_hang_nothing_is_planned_yet() -> None:
    scene = mirror("performer:standing", -0.5)
    assert scene.plots()[0].note == "The plan begins at the release."
    assert by_title(scene)["foot loads"].series["left"][1][-1] == 0.0


def test_a_fallen_body_plans_nothing() -> None:
    scene = mirror("performer:standing", 0.2)
    strategy = scene.simulation.fighters[0].strategy
    strategy.floor.fall()  # type: ignore[attr-defined]
    run_s(scene, 0.3)
    plan = scene.plots()[0]
    assert plan.note == "It has fallen: nothing is planned." and "capture point wanted" not in plan.series
