"""What the live plots remember: the last ten seconds, in order, and nothing that changes behind anybody's back."""

import numpy as np

from game.scenes.history import FRAMES_PER_SAMPLE, SAMPLES, History


def filled(count: int) -> History:
    history = History(("number", "square"))
    for k in range(count):
        history.add(0.1 * k, np.array([float(k), float(k * k)]))
    return history


def test_an_empty_history_holds_no_samples() -> None:
    history = History(("a",))
    assert (history.length, history.count) == (0, 0)
    assert history.latest().shape == (2, 0)


def test_samples_come_back_oldest_first() -> None:
    time_s, number, square = filled(7).latest()
    assert time_s.tolist() == [0.1 * k for k in range(7)]
    assert number.tolist() == list(range(7))
    assert square.tolist() == [k * k for k in range(7)]


def test_only_the_newest_are_kept_and_they_span_ten_seconds() -> None:
    for more in (1, SAMPLES // 2, SAMPLES + 3):
        history = filled(SAMPLES + more)
        assert history.latest()[1].tolist() == list(range(more, SAMPLES + more))
        assert (history.length, history.count) == (SAMPLES, SAMPLES + more)
    assert SAMPLES * FRAMES_PER_SAMPLE / 60.0 == 10.0


def test_what_was_handed_out_stays_as_it_was() -> None:
    history = filled(SAMPLES)
    handed = history.latest()
    before = handed.copy()
    for k in range(SAMPLES):
        history.add(100.0 + k, np.array([np.nan, 0.0]))
    assert np.array_equal(handed, before)
    assert np.isnan(history.latest()[1]).all()
