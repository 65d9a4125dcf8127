"""Raw disparity to metres and back."""

import numpy as np
import pytest

from kinect.depth.disparity import FARTHEST_CODE, NO_DATA, inverse_depth, metres_from_raw, metres_table, raw_from_metres
from kinect.device_calibration import TYPICAL, DeviceCalibration


@pytest.mark.parametrize(
    ("raw", "metres"), [(400, 0.501), (600, 0.706), (800, 1.194), (900, 1.824), (950, 2.478), (1000, 3.864), (1040, 6.99)]
)
def test_a_typical_device_places_known_codes_at_known_distances(raw: int, metres: float) -> None:
    assert metres_table(TYPICAL)[raw] == pytest.approx(metres, abs=0.0006 if metres < 5 else 0.006)


def test_the_table_is_the_formula_of_the_drivers() -> None:
    device = DeviceCalibration(1.17, 0.00103, 0.0747, 203.0)
    raw = np.arange(FARTHEST_CODE + 1)
    m = (raw / 4 - device.const_shift - 0.375) * device.zero_plane_pixel_size_m
    z = device.zero_plane_distance_m * device.baseline_m / (device.baseline_m - m)
    assert metres_table(device)[: FARTHEST_CODE + 1] == pytest.approx(z, rel=1e-6)


def test_a_larger_code_is_always_farther() -> None:
    table = metres_table(TYPICAL)
    assert table.shape == (2048,) and table.dtype == np.float32
    assert np.all(np.diff(table[: FARTHEST_CODE + 1]) > 0.0) and table[0] > 0.0


def test_codes_past_the_farthest_mean_no_data() -> None:
    assert np.all(np.isnan(metres_table(TYPICAL)[FARTHEST_CODE + 1 :]))
    assert np.isnan(metres_from_raw(np.array([NO_DATA], dtype=np.uint16), TYPICAL)[0])


def test_codes_beyond_a_device_s_own_infinity_mean_no_data() -> None:
    near_sighted = DeviceCalibration(1.2, 0.001042, 0.075, 180.0)
    infinity = int(np.ceil(inverse_depth(near_sighted).b))
    table = metres_table(near_sighted)
    assert infinity < FARTHEST_CODE and np.all(np.isnan(table[infinity:])) and np.all(table[:infinity] > 0.0)


def test_every_code_survives_the_way_to_metres_and_back() -> None:
    raw = np.arange(FARTHEST_CODE + 1, dtype=np.uint16)
    assert np.array_equal(raw_from_metres(metres_from_raw(raw, TYPICAL), TYPICAL), raw)


def test_what_no_code_can_say_becomes_no_data() -> None:
    assert np.all(raw_from_metres([np.nan, 0.0, -1.0, 0.1, 20.0, np.inf], TYPICAL) == NO_DATA)
