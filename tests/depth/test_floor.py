"""The floor in a depth picture: found where it is seen, and never imagined."""

from dataclasses import replace

import numpy as np
import pytest

from kinect.body import Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.disparity import NO_DATA
from kinect.depth.floor import floor_in_frame
from kinect.depth.intrinsics import factory_intrinsics
from kinect.device_calibration import TYPICAL
from tests.depth.ray_cast_room import FURNITURE, Box, Stand, depth_frame, person
from tests.depth.recorded_depth import PERSON_RAW, recorded

STANDS = [
    Stand(0.9, -8.0),
    Stand(0.7, -3.0, 4.0),
    Stand(1.2, -9.7, 3.0),
    Stand(1.8, -21.0, -6.0),
    Stand(1.0, 1.0, -4.0),
    Stand(0.6, 0.0, 2.0),
    Stand(1.566, -17.436, -4.885),  # once crumbs of floor and rug together made a lower plane
]


def errors(floor: Floor, stand: Stand) -> tuple[float, float]:
    """Of the plane: degrees between the normals, metres between the heights."""
    lean = np.degrees(np.arccos(min(1.0, float(np.array(floor[:3]) @ stand.up()))))
    return float(lean), abs(floor.d - stand.height_m)


@pytest.mark.parametrize("stand", STANDS, ids=str)
def test_in_a_furnished_room_the_floor_is_found_to_half_a_degree_and_a_centimetre(stand: Stand) -> None:
    frame = depth_frame(stand, FURNITURE + person(0.2, 2.4), seed=STANDS.index(stand), accel_error_deg=2.0)
    for seen in (frame, replace(frame, accel=None)):
        finding = floor_in_frame(seen)
        assert finding.floor is not None, finding.why
        degrees, metres = errors(finding.floor, stand)
        assert degrees < 0.5 and metres < 0.01
        assert np.linalg.norm(finding.floor[:3]) == pytest.approx(1.0)


def test_a_lens_that_bends_the_picture_costs_less_than_a_degree_and_three_centimetres() -> None:
    for stand in STANDS[:3]:
        floor = floor_in_frame(depth_frame(stand, FURNITURE + person(0.2, 2.4), warp_codes=0.7)).floor
        assert floor is not None
        degrees, metres = errors(floor, stand)
        assert degrees < 1.0 and metres < 0.03


def test_the_same_picture_and_seed_give_the_same_floor() -> None:
    frame = depth_frame(STANDS[0], FURNITURE + person(0.2, 2.4), seed=0, accel_error_deg=2.0)
    assert floor_in_frame(frame, seed=3) == floor_in_frame(frame, seed=3)
    one, other = floor_in_frame(frame, seed=3).floor, floor_in_frame(frame, seed=4).floor
    assert one is not None and other is not None
    assert np.abs(np.subtract(one, other)).max() < 0.005, "chance decides little"


def test_a_sensor_that_looks_over_the_floor_sees_none() -> None:
    frame = depth_frame(Stand(1.1, 22.0), FURNITURE + person(0.2, 2.4))
    finding = floor_in_frame(frame)
    assert finding.floor is None and finding.why.startswith("no floor in view")


def test_a_table_before_the_sensor_is_not_the_floor() -> None:
    table = Box(0.0, 0.7, 1.4, (1.6, 0.04, 0.9))
    finding = floor_in_frame(depth_frame(Stand(1.4, -12.0), (table,)))
    assert finding.floor is None or errors(finding.floor, Stand(1.4, -12.0))[1] < 0.01


@pytest.mark.parametrize("raw", [NO_DATA, 0, 800, 1050])
def test_a_picture_of_nothing_or_of_one_wall_has_no_floor(raw: int) -> None:
    flat = np.full((480, 640), raw, dtype=np.uint16)
    assert floor_in_frame(DepthFrame(flat, 0.0, 0, (0, 819, 0), TYPICAL, factory_intrinsics(TYPICAL))).floor is None


def test_noise_has_no_floor() -> None:
    raw = np.random.default_rng(5).integers(400, 1040, (480, 640)).astype(np.uint16)
    assert floor_in_frame(DepthFrame(raw, 0.0, 0, None, TYPICAL, factory_intrinsics(TYPICAL))).floor is None


@pytest.mark.shared_data
def test_in_the_real_session_whose_floor_is_out_of_view_neither_ceiling_nor_seats_count_as_one() -> None:
    raw = np.load(recorded(PERSON_RAW))["raw11"]
    for k in range(0, len(raw), 21):
        for accel in ((27, 804, 192), None):
            frame = DepthFrame(raw[k], 0.0, 0, accel, TYPICAL, factory_intrinsics(TYPICAL))
            assert floor_in_frame(frame).floor is None
