"""The last states can be had back to the last bit."""

import numpy as np
import pytest

from game.physics.state_ring import StateRing
from tests.physics.standing import run, swing, thrash, world_of


@pytest.mark.parametrize("ago", [0, 7, 60])
def test_a_restored_world_takes_the_same_steps_again_bit_for_bit(ago):
    world = world_of((0, 0, 0), (0.4, 0, 0))
    run(world, 120, thrash)
    # the ring's newest entry is the state before the last step, with the torques of the step before it
    again = ago + 1
    world.step_count -= again
    held = [world.actuation._goal.copy(), world.actuation._held.copy()]
    start = world.ring.state(ago).copy()
    world.ring.restore(ago)
    world.meter.accept_state()
    assert np.array_equal(start[1 : 1 + world.model.nq], world.data.qpos)
    fresh = np.concatenate([run(world, 1, lambda *_: None) for _ in range(5)])
    world.ring.restore(4)
    world.meter.accept_state()
    np.testing.assert_array_equal(np.concatenate([run(world, 1, lambda *_: None) for _ in range(5)]), fresh)
    for before, after in zip(held, (world.actuation._goal, world.actuation._held), strict=True):
        np.testing.assert_array_equal(before, after)


def test_it_keeps_the_newest_states_only():
    world = world_of((0, 0, 0))
    ring = StateRing(world.model, world.data, length=10)
    places = []
    for _ in range(25):
        ring.push()
        places.append(world.data.qpos.copy())
        run(world, 1, swing)
    assert len(ring) == 10
    for ago in range(10):
        np.testing.assert_array_equal(ring.state(ago)[1 : 1 + world.model.nq], places[-1 - ago])


def test_restoring_forgets_what_came_later():
    world = world_of((0, 0, 0))
    run(world, 20)
    third = world.ring.state(3).copy()
    world.ring.restore(3)
    assert len(world.ring) == 17
    np.testing.assert_array_equal(world.ring.state(0), third)


@pytest.mark.parametrize("ago", [-1, 20, 500])
def test_a_state_that_is_not_remembered_is_refused_in_words(ago):
    world = world_of((0, 0, 0))
    run(world, 20)
    with pytest.raises(IndexError, match="only 20 states are remembered"):
        world.ring.restore(ago)


def test_a_second_of_steps_at_480_hz_is_remembered():
    world = world_of((0, 0, 0))
    run(world, 500)
    assert len(world.ring) == 480
