"""What weighs more while a body is thrown, told as scenes of its feet."""

import numpy as np
import pytest

from game.control.whole_body.bracing import CALM, MENDING, PUSHED_M_S2, ROUND, STRAIGHT, bracing
from game.control.whole_body.felt_push import FeltPush
from tests.control.whole_body.footing_scene import LEFT, STEPS, Scene


@pytest.fixture
def scene():
    return Scene()


@pytest.fixture
def felt():
    return FeltPush()


def test_who_is_not_pushed_is_calm(scene, felt):
    scene.go(0.2)
    assert bracing(scene.footing, felt) is CALM


def test_a_push_that_is_felt_braces_and_one_too_light_does_not(scene, felt):
    scene.go()
    felt.acceleration = np.array([0.0, 0.9 * PUSHED_M_S2])
    assert bracing(scene.footing, felt) is CALM
    felt.acceleration = np.array([0.0, 1.1 * PUSHED_M_S2])
    assert bracing(scene.footing, felt) is STRAIGHT


@pytest.mark.parametrize(("rounds", "expected"), [(False, STRAIGHT), (True, ROUND)])
def test_a_thrown_body_stays_braced_on_its_step_and_a_little_longer(scene, felt, rounds, expected):
    felt.thrown_s, scene.footing.saved_s, scene.footing.rounds = 0.1, 0.9 * expected.lasts_s, rounds
    assert bracing(scene.footing, felt) is expected
    scene.footing.saved_s = 1.1 * expected.lasts_s
    assert bracing(scene.footing, felt) is CALM


def test_a_step_round_the_other_leg_braces_without_a_push_too(scene, felt):
    scene.footing.saved_s, scene.footing.rounds = 0.0, True
    assert bracing(scene.footing, felt) is ROUND
    scene.footing.rounds = False
    assert bracing(scene.footing, felt) is CALM


def test_over_one_foot_the_place_of_the_com_goes_before_all_while_the_other_is_put_right(scene, felt):
    felt.thrown_s, scene.footing.saved_s = 0.1, 0.1
    foot = scene.footing.feet[LEFT]
    foot.enter(STEPS)
    assert bracing(scene.footing, felt) is MENDING
    assert MENDING.com[0] > 3.0 * STRAIGHT.com[0] and np.array_equal(MENDING.joints, STRAIGHT.joints)
