"""What a depth camera sees, as points in the room and as a picture for the overlay."""

from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from game.drawables import DepthPoints, Layer
from game.intake.world_frame import sensor_to_world
from game.tunables import Settings
from kinect.body import Floats, Floor
from kinect.depth.depth_seen import depth_seen_by
from kinect.depth.disparity import NO_DATA, metres_table
from kinect.device_calibration import DeviceCalibration

BESIDE_M: Final = 0.9
"""To the character's left of where the sensor's picture would put the points, so that neither hides the other."""
REACH_M: Final = 4.5
PICTURE_STRIDE: Final = 2
NEAR_M, FAR_M = 0.6, 4.5
_NEAR, _MIDDLE, _FAR = np.array([255, 190, 105]), np.array([110, 200, 175]), np.array([38, 66, 150])
_NOTHING: Final = (14, 15, 20)


def depth_points(source: object, settings: Settings, mirrored: bool, place: Floats) -> tuple[Layer, ...]:
    """The layer of what `source` sees, at `place` (3,) m beside the character; none where it sees no depth or nobody asked.

    Levelled over the floor that was found, or over the lowest thing seen where none was, so that the player stands on the room's floor.
    """
    sees = depth_seen_by(source)
    if sees is None or not settings.switch("layer.points"):
        return ()
    frame = sees.depth()
    floor = sees.drawn_floor
    if frame is None or floor is None:
        return ()
    turn, shift = room_placement(floor, mirrored and settings.switch("intake.mirror"))
    lens = frame.intrinsics
    cloud = DepthPoints(
        frame.raw,
        metres_table(frame.calibration),
        lens.focal_px,
        (lens.centre_u, lens.centre_v),
        turn,
        shift + place + np.array([0.0, BESIDE_M, 0.0]),
        reach_m=REACH_M,
    )
    return (Layer("points", (cloud,)),)


def room_placement(floor: Floor, mirrored: bool) -> tuple[Floats, Floats]:
    """turn (3, 3) and shift (3,) from the sensor frame over this floor to the world frame, left and right swapped where mirrored."""
    turn, shift = sensor_to_world(floor)
    swap = np.array([1.0, -1.0 if mirrored else 1.0, 1.0])
    return (turn * swap).T, shift * swap


def depth_picture(source: object, settings: Settings) -> NDArray[np.uint8] | None:
    """(240, 320, 4) RGBA of what `source` sees, near warm and far cold; None where it sees no depth or nobody asked."""
    sees = depth_seen_by(source)
    frame = sees.depth() if sees is not None and settings.switch("layer.depth_picture") else None
    return None if frame is None else _inks(frame.calibration)[frame.raw[::PICTURE_STRIDE, ::PICTURE_STRIDE]]


@lru_cache(maxsize=4)
def _inks(calibration: DeviceCalibration) -> NDArray[np.uint8]:
    """A colour for each raw code, (2048, 4)."""
    metres = metres_table(calibration)
    away = np.clip(np.log(np.nan_to_num(metres, nan=FAR_M) / NEAR_M) / np.log(FAR_M / NEAR_M), 0.0, 1.0)
    ink = np.stack([np.interp(away, (0.0, 0.45, 1.0), (_NEAR[k], _MIDDLE[k], _FAR[k])) for k in range(3)], axis=1)
    table = np.full((NO_DATA + 1, 4), 255, dtype=np.uint8)
    table[:, :3] = np.where(np.isfinite(metres)[:, None], ink, _NOTHING)
    return table
