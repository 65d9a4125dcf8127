"""The stand-in is seen over the floor that the sensor found, and levelling it gives the same quiet player whatever the tilt."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.floor_level import level_over_floor, seen_over_floor
from game.inputs.stand_in import StandIn
from kinect.body import Floor


def tilted_floor(pitch_rad: float, roll_rad: float, height_m: float) -> Floor:
    """What a sensor at this height sees that looks up by `pitch_rad` and is turned by `roll_rad`."""
    up = np.array([math.sin(roll_rad), math.cos(roll_rad) * math.cos(pitch_rad), math.cos(roll_rad) * math.sin(pitch_rad)])
    a, b, c = up.tolist()
    return Floor(a, b, c, height_m)


@given(st.floats(-0.5, 0.5), st.floats(-0.3, 0.3), st.floats(0.3, 2.0))
def test_levelling_undoes_what_the_tilted_sensor_sees(pitch: float, roll: float, height: float) -> None:
    level = np.random.default_rng(0).normal(size=(20, 3))
    floor = tilted_floor(pitch, roll, height)
    np.testing.assert_allclose(level_over_floor(seen_over_floor(level, floor), floor), level, atol=1e-12)


def test_every_frame_carries_the_floor_of_its_time_and_the_player_does_not_move_when_it_is_found() -> None:
    stand_in, floor = StandIn(), tilted_floor(0.2, -0.05, 1.1)
    before = stand_in.poll(0.5, None)
    after = stand_in.poll(1.0, floor)
    assert len(before) == 16 and len(after) == 15
    assert all(frame.floor == floor for frame in after)
    own = before[-1].floor
    assert own is not None
    placed = [level_over_floor(frame.positions, frame.floor or own) for frame in (*before, *after)]
    for positions in placed:
        np.testing.assert_allclose(positions, placed[0], atol=1e-9)
    assert not np.allclose(before[-1].positions, after[0].positions), "the tilted sensor was to see him elsewhere"


def test_frames_come_thirty_a_second_and_each_once() -> None:
    stand_in = StandIn()
    times = [frame.time_s for until in (0.1, 0.1, 0.35) for frame in stand_in.poll(until, None)]
    assert times == pytest.approx(np.arange(len(times)) / 30.0) and times[-1] <= 0.35 + 1e-9 < times[-1] + 1 / 30
