"""What reading a Kinect costs is measured; how fast this machine is, is no test."""

from kinect.usb.reader_cost import reader_cost
from kinect.usb.sensor_options import SensorOptions


def test_every_frame_that_the_driver_finished_is_counted_and_the_simulation_is_not_charged_to_it() -> None:
    cost = reader_cost(1.0)
    counters = cost.counters
    handed_on = counters.frames_complete + counters.frames_partial - counters.frames_overrun
    # what came before the clock ran and what came too late to be asked for is no more than the reader keeps each time
    assert handed_on - 2 * SensorOptions().kept_frames <= cost.frames <= handed_on
    assert cost.frames > 0
    assert 0.0 < cost.cpu_share < cost.with_simulation
    assert counters.opens_failed == counters.callback_errors == counters.stream_restarts == 0
