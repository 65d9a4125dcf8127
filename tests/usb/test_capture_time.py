"""Seconds from ticks."""

import itertools

import pytest

from kinect.usb.capture_time import DEPTH_PERIOD_TICKS, WRAP, CaptureTime


def test_ticks_of_sixty_megahertz_count_from_the_first_frame() -> None:
    time = CaptureTime()
    assert time.seconds(7_000_000, 100.0) == 0.0
    assert time.seconds(7_000_000 + DEPTH_PERIOD_TICKS, 100.02) == pytest.approx(0.03336925)


def test_five_minutes_of_frames_grow_evenly_through_four_wraps_of_the_counter() -> None:
    time = CaptureTime()
    period = DEPTH_PERIOD_TICKS / 60e6
    for k in range(9000):
        assert time.seconds((WRAP - 5 + k * DEPTH_PERIOD_TICKS) % WRAP, k * period + 3.0) == pytest.approx(k * period, abs=1e-6)


def test_after_a_replugging_the_hosts_clock_bridges_the_gap() -> None:
    time = CaptureTime()
    time.seconds(3_000_000_000, 10.0)
    assert time.seconds(1_000, 14.0) == pytest.approx(4.0)
    assert time.seconds(1_000 + DEPTH_PERIOD_TICKS, 14.01) == pytest.approx(4.03336925)


def test_time_grows_even_where_a_stamp_is_broken() -> None:
    time = CaptureTime()
    times = [time.seconds(t, 0.033 * i) for i, t in enumerate([100, 100, 50, 4_000_000_000, 2_000_000, 2_000_000])]
    assert all(b > a for a, b in itertools.pairwise(times)) and times[-1] < 1.0
