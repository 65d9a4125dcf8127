"""The whole strategy: performers seen through a third of a sensor's noise are followed to the end, by torques that joints have."""

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

from game.characters.skeleton import JOINTS
from game.characters.strength import joint_strength
from game.control.whole_body.whole_body import WholeBody
from game.tunables import Settings
from tests.physics.standing import original
from tests.scenes.staged import make_scene

MOTIONS = ("waving", "stepping", "jump")


@dataclass(frozen=True)
class Run:
    """report of the scene; asked (n, 42) torques of each control tick, acted (n, 42) of each physics step, N m, from the release on."""

    report: dict[str, object]
    asked: np.ndarray
    acted: np.ndarray


@cache
def performed(motion: str) -> Run:
    settings = Settings({"balance.strategy": "whole-body", "sensor.noise": 1.0 / 3.0})
    scene = make_scene("mirror", f"performer:{motion}", settings)
    scene.enter()
    simulation = scene.simulation  # type: ignore[attr-defined]
    world, strategy = simulation.world, simulation.fighters[0].strategy
    assert isinstance(strategy, WholeBody)
    asked, acted = [], []
    take_step = world.step

    def step() -> None:
        take_step()
        if not simulation.hanging:
            asked.append(strategy.torque.copy())
            acted.append(world.actuation.torque[6:].copy())

    world.step = step
    while not scene.finished:
        scene.fixed_update()
    scene.leave()
    return Run(scene.report(), np.array(asked), np.array(acted))


def excess(torque: np.ndarray) -> tuple[float, str]:
    """The largest torque beyond the strength of its joint (N m; negative inside), and of which axis."""
    low, high = Settings().number("whole_body.strength") * np.array(joint_strength(original()))
    beyond = np.maximum(low - torque, torque - high).max(axis=0)
    row = int(np.argmax(beyond))
    return float(beyond[row]), f"{JOINTS[row // 3]} {'xyz'[row % 3]}"


@pytest.mark.slow
@pytest.mark.parametrize("motion", MOTIONS)
def test_a_performer_is_followed_upright_to_the_end(motion: str) -> None:
    report = performed(motion).report
    assert report["fell_at_s"] is None
    assert report["upright_s"] == report["clip_s"]


@pytest.mark.slow
@pytest.mark.parametrize("motion", MOTIONS)
def test_nothing_but_the_joints_moves_the_character(motion: str) -> None:
    assert performed(motion).report["unexplained_force_max_n"] < 1e-6  # type: ignore[operator]


@pytest.mark.slow
@pytest.mark.parametrize("motion", MOTIONS)
def test_no_joint_is_asked_for_more_than_it_has(motion: str) -> None:
    beyond, where = excess(performed(motion).asked)
    assert beyond <= 1e-9, f"{where} is asked for {beyond:.1f} N m too much"


@pytest.mark.slow
@pytest.mark.parametrize(
    "motion",
    ["waving", "stepping", "jump"],
)
def test_no_joint_ever_gives_more_than_it_has(motion: str) -> None:
    """Of every physics step: what was asked for, and the damping that holds it between the ticks."""
    beyond, where = excess(performed(motion).acted)
    assert beyond <= 1e-9, f"{where} gives {beyond:.1f} N m too much"
