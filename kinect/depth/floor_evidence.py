"""What a level plane must show before it counts as the floor, and not as a seat, a table or a shelf."""

from typing import Final, NamedTuple

import numpy as np

from kinect.body import Floats
from kinect.depth.disparity import InverseDepth
from kinect.depth.level_plane import LevelPlane, heights, tolerance
from kinect.depth.patches import Patches

LOWEST_M: Final = 0.3  # a sensor this near to a plane stands on it
HIGHEST_M: Final = 3.0
CELL_M: Final = 0.1
LEAST_AREA_M2: Final = 0.5
LEAST_LENGTH_M: Final = 1.0
LEAST_WIDTH_M: Final = 0.6  # a seat is 0.45 m
MOST_BELOW: Final = 0.1  # of the plane's own size; a glossy floor mirrors a little of the room


class Objection(NamedTuple):
    """Why a plane is no floor, in words; small: only because too little of it is seen, so that it may be drawn as one."""

    why: str
    small: bool = False


def objection(patches: Patches, plane: LevelPlane, constants: InverseDepth) -> Objection | None:
    """What speaks against the plane, or None where it is a floor."""
    h = plane.height_m
    if not LOWEST_M <= h <= HIGHEST_M:
        return Objection(f"the widest level surface is {h:.2f} m below the sensor, where a floor would be {LOWEST_M} to {HIGHEST_M} m")
    area, length, width = _extent(patches, plane)
    if area < LEAST_AREA_M2 / 4.0:
        return Objection("nothing level and wide is seen below the sensor")
    if _share_below(patches, plane, constants) > MOST_BELOW:
        return Objection(f"things are seen below the level surface {h:.2f} m under the sensor")
    if area < LEAST_AREA_M2 or length < LEAST_LENGTH_M or width < LEAST_WIDTH_M:
        seen = f"only {length:.1f} by {width:.1f} m ({area:.1f} square metres)"
        return Objection(f"of the level surface {h:.2f} m below the sensor {seen} is seen", small=True)
    return None


def _extent(patches: Patches, plane: LevelPlane) -> tuple[float, float, float]:
    """Area (square metres, in cells that are covered), length and width (metres, without the outermost twentieths) of the members."""
    forward = np.array([0.0, 0.0, 1.0]) - plane.normal[2] * plane.normal
    forward /= np.linalg.norm(forward)
    side = np.cross(plane.normal, forward)
    on_plane = patches.middle[plane.members] @ np.column_stack((side, forward))
    cells = np.unique(np.floor(on_plane / CELL_M).astype(np.int64), axis=0)
    placed = (cells + 0.5) * CELL_M
    placed = placed - placed.mean(axis=0)
    axes = np.linalg.eigh(placed.T @ placed)[1]
    low, high = np.quantile(placed @ axes, (0.05, 0.95), axis=0)
    width, length = sorted(float(v) for v in high - low)
    return len(cells) * CELL_M**2, length, width


def _share_below(patches: Patches, plane: LevelPlane, constants: InverseDepth) -> float:
    """Pixels of pieces that lie clearly below the plane, as a share of the plane's own pixels."""
    above: Floats = heights(patches.middle, plane.normal, plane.height_m)
    margin = 0.03 + 2.0 * tolerance(patches.middle, plane.normal, constants)
    under = np.isfinite(above) & (above < -margin)
    return float(patches.pixels[under].sum() / patches.pixels[plane.members].sum())
