"""What a depth picture shows of the room it was taken in: how much of it can be seen, and whom its lower edge cuts off."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from kinect.body import Floor
from kinect.depth.depth_frame import DepthFrame

BLIND_COLUMNS: Final = 8
EDGE_ROWS: Final = 20
CUT_NEARER_M: Final = 3.0
CUT_ABOVE_M: Final = 0.15
CUT_WIDE_M: Final = 0.12
CUT_TALL_M: Final = 0.5


@dataclass(frozen=True)
class CutOff:
    """Something tall that leaves the picture at its lower edge: how far away (m), and how high over the floor it is cut (m)."""

    away_m: float
    above_floor_m: float


def valid_share(frame: DepthFrame) -> float:
    """Share of the pixels that could hold a distance and do, 0 to 1."""
    return float(np.isfinite(frame.metres()[:, :-BLIND_COLUMNS]).mean())


def floor_from_m(frame: DepthFrame, floor: Floor) -> float:
    """How far away, along the sensor's z, the floor comes into the picture at its lower edge; infinite where it never does."""
    fall = floor.c - floor.b * _down(frame)
    return -floor.d / fall if fall < 0.0 else float("inf")


def cut_off(frame: DepthFrame, floor: Floor) -> CutOff | None:
    """What stands so near that the picture's lower edge cuts it off, as legs are; a low table does not count. None where nothing does."""
    metres = frame.metres()
    lens = frame.intrinsics
    edge = metres[-EDGE_ROWS:, :-BLIND_COLUMNS]
    seen = np.isfinite(edge)
    away = np.where(seen, edge, 0.0).sum(axis=0) / np.maximum(seen.sum(axis=0), 1)
    x = -(np.arange(len(away)) - lens.centre_u) / lens.focal_px
    above = (floor.a * x - floor.b * _down(frame) + floor.c) * away + floor.d
    tall = (np.abs(metres[:, :-BLIND_COLUMNS] - away) < 0.3).sum(axis=0) * away / lens.focal_px
    cut = (seen.sum(axis=0) > EDGE_ROWS // 2) & (away < CUT_NEARER_M) & (above > CUT_ABOVE_M) & (tall > CUT_TALL_M)
    if not np.any(cut) or float((away[cut] / lens.focal_px).sum()) < CUT_WIDE_M:
        return None
    return CutOff(float(np.median(away[cut])), float(np.median(above[cut])))


def _down(frame: DepthFrame) -> float:
    """How far a ray through the middle of the lowest rows falls, per metre along z."""
    return (frame.metres().shape[0] - EDGE_ROWS / 2 - frame.intrinsics.centre_v) / frame.intrinsics.focal_px
