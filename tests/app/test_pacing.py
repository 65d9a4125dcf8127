"""Wall time becomes fixed updates: none lost below 50 ms, none too many above it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.pacing import LONGEST_CATCH_UP_S, UPDATE_S, StepPace, WallPace


def updates_over(times_s: np.ndarray) -> int:
    pace = WallPace()
    return sum(pace.due(float(t)).updates for t in times_s)


@pytest.mark.parametrize("seed", range(5))
def test_any_jitter_gives_the_same_number_of_updates(seed: int) -> None:
    rng = np.random.default_rng(seed)
    gaps = rng.uniform(0.001, LONGEST_CATCH_UP_S, 2000)
    times = np.concatenate([[0.0], np.cumsum(gaps)])
    times = np.append(times[times < 19.99], 19.995)
    assert updates_over(times) == int(19.995 * 60)


@given(st.lists(st.floats(0.0, 0.5), min_size=1, max_size=80))
def test_no_frame_owes_more_than_the_catch_up_and_blend_stays_between_0_and_1(gaps: list[float]) -> None:
    pace, now, total = WallPace(), 0.0, 0
    pace.due(now)
    for gap in gaps:
        now += gap
        due = pace.due(now)
        total += due.updates
        assert 0 <= due.updates <= LONGEST_CATCH_UP_S / UPDATE_S + 1
        assert 0.0 <= due.blend <= 1.0
    assert total <= sum(min(gap, LONGEST_CATCH_UP_S) for gap in gaps) / UPDATE_S + 1e-6


def test_blend_is_the_part_of_an_update_that_is_still_owed() -> None:
    pace = WallPace()
    pace.due(0.0)
    due = pace.due(1.25 * UPDATE_S)
    assert (due.updates, due.blend) == (1, pytest.approx(0.25))


def test_a_machine_that_keeps_up_is_not_called_slow_and_one_that_does_not_is() -> None:
    fast, slow = WallPace(), WallPace()
    for frame in range(120):
        fast.due(frame / 60)
        slow.due(frame * 0.1)
    assert fast.speed == pytest.approx(1.0)
    assert slow.speed == pytest.approx(0.5)


def test_time_spent_paused_is_not_caught_up() -> None:
    pace = WallPace()
    pace.due(0.0)
    pace.due(10.0, paused=True)
    assert pace.due(10.0 + UPDATE_S).updates == 1


def test_a_clock_that_runs_backwards_owes_nothing() -> None:
    pace = WallPace()
    pace.due(5.0)
    assert pace.due(4.0).updates == 0


def test_without_a_clock_every_frame_is_the_same() -> None:
    pace = StepPace(2)
    assert [pace.due(t).updates for t in (0.0, 7.0, 7.0)] == [2, 2, 2]
    assert pace.due(8.0, paused=True).updates == 0
