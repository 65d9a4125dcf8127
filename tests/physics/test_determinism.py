"""Equal settings give equal bits; time steps fill a frame; every integrator runs."""

import hashlib

import numpy as np
import pytest

from game.physics.world import steps_per_frame
from tests.physics.standing import run, swing, thrash, unexplained, world_of


@pytest.mark.parametrize("motion", [swing, thrash])
def test_equal_worlds_take_equal_steps_to_the_last_bit(motion):
    first, second = world_of((0, 0, 0), (0.4, 0, 0)), world_of((0, 0, 0), (0.4, 0, 0))
    np.testing.assert_array_equal(run(first, 240, motion), run(second, 240, motion))
    assert first.state_sha256 == second.state_sha256


def test_the_hash_is_over_the_state_of_every_step():
    world = world_of((0, 0, 0))
    states = run(world, 50)
    assert world.state_sha256 == hashlib.sha256(states.tobytes()).hexdigest()


def test_looking_at_a_world_does_not_change_it():
    watched, alone = world_of((0, 0, 0)), world_of((0, 0, 0))
    for _ in range(60):
        run(watched, 2)
        watched.refresh()
        _ = watched.characters[0].com_velocity, watched.characters[0].mass_matrix, watched.meter.partners, watched.state_sha256
    run(alone, 120)
    assert watched.state_sha256 == alone.state_sha256


@pytest.mark.parametrize("change", [{"physics__friction": 0.5}, {"physics__step_s": 1 / 960}, {"physics__integrator": "euler"}])
def test_other_settings_give_another_hash(change):
    worlds = world_of((0, 0, 0)), world_of((0, 0, 0), **change)
    for world in worlds:
        run(world, 120, thrash)
    assert worlds[0].state_sha256 != worlds[1].state_sha256


@pytest.mark.parametrize(
    ("wanted", "steps"),
    [(1 / 480, 8), (1 / 60, 1), (0.002, 8), (0.0025, 7), (0.0001, 167), (0.00001, 1667), (0.005, 3), (0.0123, 1), (0.011, 2)],
)
def test_a_time_step_is_rounded_until_whole_steps_fill_a_frame(wanted, steps):
    world = world_of((0, 0, 1.0), physics__step_s=wanted)
    assert steps_per_frame(wanted) == world.steps_per_frame == steps
    assert world.step_s * world.steps_per_frame == pytest.approx(1 / 60, rel=1e-14)


@pytest.mark.parametrize(
    ("integrator", "step_s"), [("discrete", 1 / 480), ("implicitfast", 1 / 2000), ("euler", 1 / 2000), ("explicit", 1 / 20000)]
)
def test_every_integrator_keeps_a_body_on_its_feet_and_honest(integrator, step_s):
    world = world_of((0, 0, 0), physics__integrator=integrator, physics__step_s=step_s)
    run(world, round(0.1 / world.step_s))
    assert world.characters[0].com_height() > 0.9
    force, torque = unexplained(world)
    assert force < 1e-6 and torque < 1e-6 and world.guard_actions == 0
