"""What the doctor reads off a depth picture of a simulated room."""

import math
from dataclasses import dataclass

import numpy as np
import pytest

from game.commands.kinect_sight import cut_off, floor_from_m, valid_share
from kinect.body import Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.intrinsics import factory_intrinsics
from kinect.device_calibration import TYPICAL
from kinect.usb.simulated_room import Room


@dataclass(frozen=True)
class Furnished(Room):
    """With something as wide as a table at so many metres, so high (m)."""

    table_m: float = 1.6
    table_high_m: float = 0.45

    def depth(self, k: int) -> np.ndarray:
        z = super().depth(k)
        v = (np.arange(480) - 240.0)[:, None] / TYPICAL.focal_px
        high = self.height_m - v * self.table_m
        hit = (high < self.table_high_m) & (np.abs(np.arange(640) - 320) < 150)[None, :]
        return np.where(hit, np.minimum(z, self.table_m), z)


def picture(room: Room) -> DepthFrame:
    return DepthFrame(room.disparity(0), 0.0, 0, room.counts, TYPICAL, factory_intrinsics(TYPICAL))


def floor_of(room: Room) -> Floor:
    return Floor(0.0, math.cos(room.pitch_rad), math.sin(room.pitch_rad), room.height_m)


@pytest.mark.parametrize("valid", [0.1, 0.5, 0.97])
def test_the_share_that_is_seen_is_what_the_room_lets_be_seen(valid: float) -> None:
    assert valid_share(picture(Room(valid=valid))) == pytest.approx(valid, abs=0.01)


def test_a_picture_of_nothing_has_no_share() -> None:
    assert valid_share(picture(Room(valid=0.0))) == 0.0


@pytest.mark.parametrize("away", [1.0, 1.3, 1.6])
@pytest.mark.parametrize("pitch_deg", [0.0, 8.0])
def test_a_person_too_near_is_cut_off_where_the_picture_ends(away: float, pitch_deg: float) -> None:
    room = Room(person_m=away, pitch_rad=math.radians(pitch_deg))
    found = cut_off(picture(room), floor_of(room))
    assert found is not None and found.away_m == pytest.approx(away, abs=0.12)
    lowest = -math.atan2(229.5, TYPICAL.focal_px) + room.pitch_rad
    assert found.above_floor_m == pytest.approx(room.height_m + away * math.tan(lowest), abs=0.05)


@pytest.mark.parametrize("away", [2.3, 2.6, 3.2])
def test_a_person_far_enough_is_not_cut_off(away: float) -> None:
    room = Room(person_m=away)
    assert cut_off(picture(room), floor_of(room)) is None


def test_a_low_table_cut_off_is_no_person() -> None:
    room = Furnished()
    assert cut_off(picture(room), floor_of(room)) is None
    assert cut_off(picture(Furnished(table_high_m=1.2)), floor_of(room)) is not None


@pytest.mark.parametrize(("height", "pitch_deg"), [(0.6, 0.0), (0.9, -8.0), (1.8, -20.0), (1.2, 10.0)])
def test_the_floor_begins_where_the_lowest_ray_meets_it(height: float, pitch_deg: float) -> None:
    room = Room(height_m=height, pitch_rad=math.radians(pitch_deg), person_m=30.0, wall_m=8.0)
    begins = floor_from_m(picture(room), floor_of(room))
    lowest_rows = room.depth(0)[465:475]
    assert begins == pytest.approx(float(np.median(lowest_rows)), rel=0.03)


def test_a_sensor_that_looks_up_never_sees_the_floor() -> None:
    room = Room(pitch_rad=math.radians(30.0))
    assert floor_from_m(picture(room), floor_of(room)) == math.inf
