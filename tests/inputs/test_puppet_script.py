"""The scripted puppet boxes by its seed alone."""

from itertools import islice

import numpy as np

from game.inputs.puppet_controls import PuppetControls
from game.inputs.puppet_script import FIRST_STILL_S, ScriptedPuppet, bout
from kinect.body import Floats, Joint


def played(seed: int, seconds: float = 12.0, every_s: float = 1.0) -> Floats:
    source = ScriptedPuppet(seed)
    return np.array([f.positions for k in range(round(seconds / every_s) + 1) for f in source.poll(k * every_s)])


def test_equal_seeds_box_the_same_bout_however_they_are_polled_and_others_another():
    first = played(4)
    np.testing.assert_array_equal(first, played(4, every_s=0.125))
    assert not np.allclose(first, played(5))


def test_it_stands_still_first_so_that_it_can_be_measured():
    still = played(7)[: int(30 * FIRST_STILL_S)]
    assert np.abs(still - still[0]).max() < 1e-3


def test_every_bout_has_punches_leans_and_the_feet_mostly_on_the_floor():
    for seed in range(4):
        world = played(seed, 20.0)
        speed = np.linalg.norm(np.gradient(world, 1.0 / 30.0, axis=0), axis=2)
        assert speed[:, [Joint.WRIST_LEFT, Joint.WRIST_RIGHT]].max() > 1.8
        assert speed.max() < 5.0
        assert np.ptp(world[:, Joint.SHOULDER_CENTER], axis=0).max() > 0.1
        lifted = world[:, [Joint.FOOT_LEFT, Joint.FOOT_RIGHT], 1] + 0.9 - 0.02 > 0.01
        assert lifted.any(axis=1).mean() < 0.2


def test_a_bout_asks_for_nothing_impossible():
    for seconds, controls in islice(bout(1), 500):
        assert 0.05 < seconds < 3.0
        assert isinstance(controls, PuppetControls)
        assert -1.0 <= controls.lean_forward <= 1.0 and -1.0 <= controls.lean_left <= 1.0
        assert 0.0 <= controls.crouch <= 1.0 and not controls.jump
