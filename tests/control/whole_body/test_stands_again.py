"""A body laid on the floor, any way up, stands again by its own torques; a weak one stays down and the game can tell."""

import numpy as np
import pytest

from game import rotation
from game.control.whole_body.on_the_floor import MOST_TRIES, Stage
from game.control.whole_body.whole_body import WholeBody
from game.report.up_again import is_down
from game.scenes.mirror import Mirror
from game.tunables import Settings
from tests.physics.standing import idle_joints
from tests.scenes.staged import make_scene, run_s

TURNS = {"back": (0.0, -1.5, 0.0), "front": (0.0, 1.5, 0.0), "right side": (1.5, 0.0, 0.0), "left side": (-1.5, 0.0, 0.0)}


def laid_down(turn, seconds, **settings):
    """The scene, so many seconds after its figure was laid on the floor."""
    values = {"physics.self_collision": True, "intake.mirror": False} | {name.replace("__", "."): value for name, value in settings.items()}
    scene = make_scene("mirror", "performer:standing", Settings(values))
    assert isinstance(scene, Mirror)
    scene.enter()
    run_s(scene, 0.3)
    world = scene.simulation.world
    world.place(0, np.array([0.0, 0.0, 0.25]), rotation.exp(np.array(turn)), idle_joints())
    run_s(scene, 0.3 + seconds)
    return scene


@pytest.mark.parametrize("turn", TURNS.values(), ids=TURNS)
def test_it_stands_again(turn):
    scene = laid_down(turn, 0.0)
    assert not any("stands again" in said for said in scene.messages())
    run_s(scene, 14.3)
    simulation = scene.simulation
    fighter, world = simulation.fighters[0], simulation.world
    assert isinstance(fighter.strategy, WholeBody) and fighter.strategy.floor.stage is Stage.UP
    assert world.meter.contacts is not None
    assert not is_down(world.characters[0], fighter.target, world.meter.contacts.parts_on_floor(0))
    assert world.meter.unexplained_force_n[0] < 1e-6 and world.guard_actions == 0
    assert any("stands again" in said for said in scene.messages())
    scene.leave()


def test_a_weak_body_tries_and_then_stays_down_for_good():
    scene = laid_down(TURNS["front"], 25.0, whole_body__strength=0.2)
    strategy = scene.simulation.fighters[0].strategy
    assert isinstance(strategy, WholeBody) and strategy.stays_down and strategy.floor.tries == MOST_TRIES
    assert any("cannot get up" in said for said in scene.messages())
    scene.leave()
