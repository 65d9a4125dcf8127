"""Depth pictures as points in the sensor frame."""

import numpy as np
import pytest

from kinect.depth.depth_frame import up_from_accelerometer
from kinect.depth.intrinsics import MICROSOFT_SDK, factory_intrinsics
from kinect.depth.point_cloud import organised_points, pixels_of, point_cloud
from kinect.device_calibration import TYPICAL

LENS = factory_intrinsics(TYPICAL)


def picture(*pixels: tuple[int, int, float]) -> np.ndarray:
    metres = np.full((480, 640), np.nan, dtype=np.float32)
    for u, v, z in pixels:
        metres[v, u] = z
    return metres


def test_the_factory_s_lens_sees_58_by_45_degrees() -> None:
    assert LENS.focal_px == pytest.approx(575.8, abs=0.05)
    assert np.degrees(2 * np.arctan((320 / LENS.focal_px, 240 / LENS.focal_px))) == pytest.approx((58.1, 45.3), abs=0.1)


def test_the_picture_s_left_is_the_sensor_s_left_and_its_top_is_up() -> None:
    (left_top,) = point_cloud(picture((100, 50, 2.0)), LENS)
    assert left_top == pytest.approx(((320 - 100) * 2.0 / LENS.focal_px, (240 - 50) * 2.0 / LENS.focal_px, 2.0), abs=1e-6)
    assert left_top[0] > 0.0 and left_top[1] > 0.0


def test_the_middle_of_the_picture_lies_straight_ahead() -> None:
    assert point_cloud(picture((320, 240, 3.0)), LENS)[0] == pytest.approx((0.0, 0.0, 3.0))


def test_only_what_was_seen_becomes_a_point() -> None:
    metres = picture((8, 4, 1.0), (9, 4, 1.0), (16, 12, 2.0))
    assert len(point_cloud(metres, LENS)) == 3 and len(point_cloud(metres, LENS, stride=4)) == 2
    organised = organised_points(metres, LENS, stride=4)
    assert organised.shape == (120, 160, 3) and np.isfinite(organised[..., 2]).sum() == 2
    assert organised[1, 2] == pytest.approx(point_cloud(metres, LENS)[0])


def test_points_return_to_their_pixels() -> None:
    rng = np.random.default_rng(3)
    pixels = np.column_stack((rng.integers(0, 640, 50), rng.integers(0, 480, 50)))
    pixels = np.unique(pixels, axis=0)
    metres = picture(*((int(u), int(v), 1.5) for u, v in pixels))
    back = pixels_of(point_cloud(metres, MICROSOFT_SDK), MICROSOFT_SDK)
    assert sorted(map(tuple, np.round(back).astype(int))) == sorted(map(tuple, pixels))
    assert np.abs(back - np.round(back)).max() < 1e-3


def test_gravity_points_the_way_the_motor_says() -> None:
    up = up_from_accelerometer((26, 804, 192))  # of a sensor whose motor reports 13 degrees up
    assert up is not None
    assert np.degrees(np.arctan2(up[2], up[1])) == pytest.approx(13.4, abs=0.1)


@pytest.mark.parametrize("counts", [(0, 0, 0), (0, 1400, 0), (100, 200, 100)])
def test_a_shaken_or_dead_accelerometer_says_nothing(counts: tuple[int, int, int]) -> None:
    assert up_from_accelerometer(counts) is None
