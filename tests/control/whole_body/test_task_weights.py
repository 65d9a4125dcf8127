"""What a tick's tasks weigh: a body that braces itself is softer and turns less, one that flies is held less firmly."""

import numpy as np
import pytest

from game.characters.strength import joint_strength
from game.control.whole_body.bracing import CALM, MENDING, ROUND, STRAIGHT
from game.control.whole_body.task_weights import HOLD_IN_THE_AIR, TaskWeights
from game.tunables import Settings
from tests.physics.standing import original

TICK_S = 1.0 / 60.0


@pytest.fixture
def weights():
    return TaskWeights(Settings(), np.array(joint_strength(original())))


def damping_ratio(numbers):
    return numbers.pose_damping / (2.0 * numbers.pose_stiffness**0.5)


@pytest.mark.parametrize("braced", [STRAIGHT, ROUND, MENDING])
def test_who_braces_is_softer_and_damped_alike(weights, braced):
    calm, thrown = (weights.numbers(True, False, way, TICK_S) for way in (CALM, braced))
    assert thrown.pose_stiffness < 0.7 * calm.pose_stiffness
    assert damping_ratio(thrown) == pytest.approx(damping_ratio(calm))
    assert thrown.pelvis_weight > calm.pelvis_weight and thrown.spin_weight < calm.spin_weight


def test_a_calm_body_weighs_its_tasks_by_the_tunables(weights):
    numbers = weights.numbers(True, False, CALM, TICK_S)
    assert numbers.pose_stiffness == Settings().number("whole_body.pose_stiffness")
    assert numbers.hold == Settings().number("whole_body.hold")


def test_who_flies_is_held_less_firmly(weights):
    stands, flies = (weights.numbers(True, flying, CALM, TICK_S) for flying in (False, True))
    assert flies == stands._replace(hold=HOLD_IN_THE_AIR * stands.hold)


def test_who_lands_does_not_turn(weights):
    turns, lands = weights.numbers(True, False, CALM, TICK_S), weights.numbers(False, False, STRAIGHT, TICK_S)
    assert lands == turns._replace(back_rate=0.0)
