"""Small flat pieces of the depth picture: 8 x 8 pixels each, fitted where the noise is even, in raw disparity.

A plane is linear in raw (see kinect/depth/disparity.py), so each piece is a least-squares fit raw = c0 + c1 du + c2 dv,
and pieces of one plane can be fitted together from their sums alone, without going back to the pixels.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.body import Floats
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.disparity import FARTHEST_CODE, InverseDepth, inverse_depth
from kinect.depth.intrinsics import HEIGHT, WIDTH, Intrinsics

SIDE: Final = 8
ROWS, COLUMNS = HEIGHT // SIDE, WIDTH // SIDE
COUNT: Final = ROWS * COLUMNS
FEWEST_PIXELS: Final = 24
ROUGHEST_CODES: Final = 1.2  # rms about its own plane; an edge, a foot or a shadow is rougher

_OFFSET = np.arange(SIDE) - (SIDE - 1) / 2.0
_DV, _DU = (grid.reshape(-1) for grid in np.meshgrid(_OFFSET, _OFFSET, indexing="ij"))
_BASIS = np.stack((np.ones(SIDE * SIDE), _DU, _DV))  # (3, 64)
_PRODUCTS = np.stack([_BASIS[i] * _BASIS[j] for i in range(3) for j in range(3)])  # (9, 64)


@dataclass(frozen=True)
class Patches:
    """What the pieces of one picture hold, row by row, COUNT of them.

    sums (COUNT, 3, 3) and raw_sums (COUNT, 3): the normal equations of raw over (1, a, b), where a = (u - centre_u) / focal and
    b = (v - centre_v) / focal. pixels (COUNT,): how many had data. middle (COUNT, 3): a point on the piece, metres, sensor frame.
    normal (COUNT, 3): unit, facing the sensor. distance (COUNT,): of the piece's plane from the sensor, metres.
    flat (COUNT,) bool: enough pixels, and one plane explains them; only there are normal and distance meaningful.
    """

    sums: Floats
    raw_sums: Floats
    pixels: NDArray[np.int64]
    middle: Floats
    normal: Floats
    distance: Floats
    flat: NDArray[np.bool_]


def patches_of(frame: DepthFrame) -> Patches:
    """The pieces of a depth picture."""
    raw = frame.raw.reshape(ROWS, SIDE, COLUMNS, SIDE).swapaxes(1, 2).reshape(COUNT, SIDE * SIDE)
    seen = (raw <= FARTHEST_CODE).astype(np.float64)
    pixels = seen.sum(axis=1)
    values = raw * seen
    mean = values.sum(axis=1) / np.maximum(pixels, 1.0)
    values -= mean[:, None] * seen
    sums = (seen @ _PRODUCTS.T).reshape(COUNT, 3, 3)
    raw_sums = values @ _BASIS.T
    enough = pixels >= FEWEST_PIXELS
    fitted = np.zeros((COUNT, 3))
    solvable = enough & (np.linalg.det(sums) > 1.0)
    fitted[solvable] = np.linalg.solve(sums[solvable], raw_sums[solvable, :, None])[..., 0]
    misfit = np.einsum("ij,ij->i", values, values) - np.einsum("ij,ij->i", fitted, raw_sums)
    flat = solvable & (misfit < ROUGHEST_CODES**2 * pixels)
    raw_sums += mean[:, None] * sums[:, 0]
    fitted[:, 0] += mean
    return _in_rays(sums, raw_sums, fitted, pixels, flat, frame.intrinsics, inverse_depth(frame.calibration))


def plane_of(code_plane: Floats, constants: InverseDepth) -> Floats:
    """Inverse plane p (..., 3), with p . point = 1 in the sensor frame, of raw = c0 + c1 a + c2 b given as (..., 3)."""
    a, b = constants
    return np.stack((code_plane[..., 1], code_plane[..., 2], b - code_plane[..., 0]), axis=-1) / a


def _in_rays(
    sums: Floats,
    raw_sums: Floats,
    fitted: Floats,
    pixels: Floats,
    flat: NDArray[np.bool_],
    intrinsics: Intrinsics,
    constants: InverseDepth,
) -> Patches:
    """From offsets inside each piece to ray coordinates a, b, where all pieces share one basis."""
    v, u = np.mgrid[0:ROWS, 0:COLUMNS].reshape(2, -1) * SIDE + (SIDE - 1) / 2.0
    a0, b0 = (u - intrinsics.centre_u) / intrinsics.focal_px, (v - intrinsics.centre_v) / intrinsics.focal_px
    shift = np.zeros((COUNT, 3, 3))
    shift[:, 0, 0] = 1.0
    shift[:, 1, 0], shift[:, 2, 0] = a0, b0
    shift[:, 1, 1] = shift[:, 2, 2] = 1.0 / intrinsics.focal_px
    slope = fitted[:, 1:] * intrinsics.focal_px
    code_plane = np.column_stack((fitted[:, 0] - slope[:, 0] * a0 - slope[:, 1] * b0, slope))
    inverse = plane_of(code_plane, constants)
    length = np.maximum(np.linalg.norm(inverse, axis=1), 1e-9)
    with np.errstate(divide="ignore"):
        z = np.where(pixels > 0, constants.a / np.maximum(constants.b - fitted[:, 0], 1e-6), np.nan)
    middle = np.column_stack((-a0, -b0, np.ones(COUNT))) * z[:, None]
    turned = shift @ sums @ shift.swapaxes(1, 2)
    return Patches(
        turned, (shift @ raw_sums[..., None])[..., 0], pixels.astype(np.int64), middle, -inverse / length[:, None], 1.0 / length, flat
    )
