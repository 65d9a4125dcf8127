"""Depth pictures to points in the sensor frame."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from kinect.depth.intrinsics import HEIGHT, WIDTH, Intrinsics


@lru_cache(maxsize=8)
def rays(intrinsics: Intrinsics, stride: int = 1) -> NDArray[np.float32]:
    """Where each pixel looks: (480 / stride, 640 / stride, 3) float32, the point at 1 m along z; read-only."""
    v, u = np.mgrid[0:HEIGHT:stride, 0:WIDTH:stride].astype(np.float64)
    x = -(u - intrinsics.centre_u) / intrinsics.focal_px
    y = -(v - intrinsics.centre_v) / intrinsics.focal_px
    out = np.stack((x, y, np.ones_like(x)), axis=-1).astype(np.float32)
    out.flags.writeable = False
    return out


def organised_points(metres: NDArray[np.float32], intrinsics: Intrinsics, stride: int = 1) -> NDArray[np.float32]:
    """A point for every `stride`-th pixel and row of a (480, 640) picture, (480 / stride, 640 / stride, 3) metres, sensor frame.

    NaN where there is no data.
    """
    return rays(intrinsics, stride) * metres[::stride, ::stride, None]


def point_cloud(metres: NDArray[np.float32], intrinsics: Intrinsics, stride: int = 1) -> NDArray[np.float32]:
    """The points that were seen, (N, 3) float32 metres, sensor frame, row by row."""
    z = metres[::stride, ::stride]
    seen = np.isfinite(z)
    return rays(intrinsics, stride)[seen] * z[seen][:, None]


def pixels_of(points: NDArray[np.floating], intrinsics: Intrinsics) -> NDArray[np.float64]:
    """Where points (..., 3) in the sensor frame appear: (..., 2) pixel coordinates u, v."""
    points = np.asarray(points, dtype=np.float64)
    across = points[..., :2] / points[..., 2:]
    return np.array((intrinsics.centre_u, intrinsics.centre_v)) - intrinsics.focal_px * across
