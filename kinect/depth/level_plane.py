"""A level plane under the sensor: how far pieces of the picture lie from it, and the best fit through those that belong to it."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.body import Floats
from kinect.depth.disparity import InverseDepth
from kinect.depth.patches import Patches, plane_of

UNEVEN_M: Final = 0.008  # carpet, boards
NOISE_CODES: Final = 1.5
REFITS: Final = 4


@dataclass(frozen=True)
class LevelPlane:
    """normal (3,): unit, up, sensor frame; height_m: of the sensor above it; members (COUNT,) bool: the pieces that lie in it."""

    normal: Floats
    height_m: float
    members: NDArray[np.bool_]


def heights(points: Floats, normal: Floats, height_m: float | Floats) -> Floats:
    """Metres of points (P, 3) above a plane, (P,); or (P, N) for N planes: normal (3, N), height_m (N,)."""
    return points @ normal + height_m


def tolerance(points: Floats, normal: Floats, constants: InverseDepth) -> Floats:
    """Metres by which unevenness and the sensor's noise may part points (P, 3) from a plane of this normal, (P,) or (P, N).

    One code of disparity moves a point along its ray by z^2 / a, and so up or down by z / a of its depth below the sensor.
    """
    drop = np.abs(points @ normal)
    z = points[:, 2]
    return UNEVEN_M + NOISE_CODES * drop * (z if drop.ndim == 1 else z[:, None]) / constants.a


def refitted(
    patches: Patches, normal: Floats, height_m: float, among: NDArray[np.bool_], constants: InverseDepth, share: float
) -> LevelPlane | None:
    """The least-squares plane through all pixels of the pieces of `among` within a share of the tolerance, found anew a few times.

    Least squares of raw disparity, where the noise is even over the picture. None where the pieces do not hold a plane together.
    """
    members = among
    for _ in range(REFITS):
        near = np.abs(heights(patches.middle, normal, height_m)) < share * tolerance(patches.middle, normal, constants)
        members = among & near
        if np.count_nonzero(members) < 4:
            return None
        sums = patches.sums[members].sum(axis=0)
        if np.linalg.cond(sums) > 1e9:
            return None
        inverse = plane_of(np.linalg.solve(sums, patches.raw_sums[members].sum(axis=0)), constants)
        length = float(np.linalg.norm(inverse))
        if length < 1e-3:
            return None
        normal, height_m = -inverse / length, 1.0 / length
    return LevelPlane(normal, height_m, members)
