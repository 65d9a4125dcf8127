"""What reading a Kinect costs is measured; how fast this machine is, is no test."""

from kinect.usb.reader_cost import reader_cost


def test_every_frame_that_the_driver_finished_is_counted_and_the_simulation_is_not_charged_to_it() -> None:
    cost = reader_cost(1.0)
    counters = cost.counters
    assert 0 < cost.frames <= counters.frames_complete + counters.frames_partial
    assert 0.0 < cost.cpu_share < cost.with_simulation
    assert counters.opens_failed == counters.callback_errors == counters.stream_restarts == 0
