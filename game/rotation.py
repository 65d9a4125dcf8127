"""Unit quaternions (w, x, y, z), rotation matrices and rotation vectors, vectorised over leading axes, float64.

Products run through constant tensors and matmul: a handful of numpy calls whatever the number of rotations.
"""

import math

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

IDENTITY: Floats = np.array([1.0, 0.0, 0.0, 0.0])
_CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])
_TINY = 1e-60
"""Added to squared lengths: the limits at angle zero then come out of the ordinary formulas."""


def _left_product() -> Floats:
    """(4, 16): q @ it, as (4, 4), is the matrix of p -> q p."""
    table = np.zeros((4, 4, 4))
    for row, terms in enumerate(
        (((0, 0, 1), (1, 1, -1), (2, 2, -1), (3, 3, -1)), ((0, 1, 1), (1, 0, 1), (2, 3, 1), (3, 2, -1)),
         ((0, 2, 1), (1, 3, -1), (2, 0, 1), (3, 1, 1)), ((0, 3, 1), (1, 2, 1), (2, 1, -1), (3, 0, 1)))
    ):  # fmt: skip
        for a, b, sign in terms:
            table[a, row, b] = sign
    return table.reshape(4, 16)


def _left_cross() -> Floats:
    """(3, 9): a @ it, as (3, 3), is the matrix of b -> a x b."""
    table = np.zeros((3, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        table[i, k, j], table[i, j, k] = 1.0, -1.0
    return table.reshape(3, 9)


def _squares_to_matrix() -> Floats:
    """(16, 9): the outer product of a unit quaternion with itself to its rotation matrix."""
    table = np.zeros((4, 4, 3, 3))
    for i in range(3):
        table[0, 0, i, i] = 1.0
        for j in range(3):
            table[j + 1, j + 1, i, i] = 1.0 if i == j else -1.0
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        table[i + 1, j + 1, i, j] = table[i + 1, j + 1, j, i] = 2.0
        table[0, k + 1, i, j], table[0, k + 1, j, i] = -2.0, 2.0
    return table.reshape(16, 9)


_PRODUCT, _CROSS, _MATRIX = _left_product(), _left_cross(), _squares_to_matrix()


def multiply(a: Floats, b: Floats) -> Floats:
    """Hamilton product a b, (..., 4): first b, then a."""
    left = (a @ _PRODUCT).reshape(*a.shape[:-1], 4, 4)
    return (left @ b[..., None])[..., 0]


def conjugate(q: Floats) -> Floats:
    """The inverse of a unit quaternion, (..., 4)."""
    return q * _CONJUGATE


def cross(a: Floats, b: Floats) -> Floats:
    """a x b, (..., 3)."""
    return ((a @ _CROSS).reshape(*a.shape[:-1], 3, 3) @ b[..., None])[..., 0]


def matrix(q: Floats) -> Floats:
    """Rotation matrices (..., 3, 3) of unit quaternions."""
    squares = (q[..., :, None] * q[..., None, :]).reshape(*q.shape[:-1], 16)
    return (squares @ _MATRIX).reshape(*q.shape[:-1], 3, 3)


def turn(m: Floats, v: Floats) -> Floats:
    """Vectors v (..., 3) turned by rotation matrices m (..., 3, 3)."""
    return (m @ v[..., None])[..., 0]


def turn_back(m: Floats, v: Floats) -> Floats:
    """Vectors v (..., 3) turned by the inverse of rotation matrices m."""
    return (v[..., None, :] @ m)[..., 0, :]


def rotate(q: Floats, v: Floats) -> Floats:
    """Vectors v (..., 3) turned by q (..., 4)."""
    return turn(matrix(q), v)


def unrotate(q: Floats, v: Floats) -> Floats:
    """Vectors v (..., 3) turned by the inverse of q."""
    return turn_back(matrix(q), v)


def normalise(q: Floats) -> Floats:
    """Quaternions, or any vectors, scaled to unit length."""
    return q / np.sqrt((q * q).sum(-1, keepdims=True) + _TINY)


def exp(rotation_vector: Floats) -> Floats:
    """Rotation vector (..., 3) rad to unit quaternion; exact at zero."""
    half = 0.5 * np.sqrt((rotation_vector * rotation_vector).sum(-1, keepdims=True) + _TINY)
    out = np.empty((*rotation_vector.shape[:-1], 4))
    out[..., :1] = np.cos(half)
    out[..., 1:] = rotation_vector * (0.5 * np.sin(half) / half)
    return out


def log(q: Floats) -> Floats:
    """Unit quaternion to the shortest rotation vector (..., 3) rad, |angle| <= pi."""
    w, v = q[..., :1], q[..., 1:]
    sine = np.sqrt((v * v).sum(-1, keepdims=True) + _TINY)
    return v * (2.0 * np.arctan2(sine, np.abs(w)) / np.copysign(sine, w))


def between(a: Floats, b: Floats) -> Floats:
    """The smallest rotation (..., 4) that turns unit direction a (..., 3) to unit direction b; opposites turn about any normal."""
    q = np.empty(np.broadcast_shapes(a.shape[:-1], b.shape[:-1]) + (4,))
    q[..., 0] = 1.0 + (a * b).sum(-1)
    q[..., 1:] = cross(a, b)
    if (q[..., 0] < 1e-15).any():
        least = np.eye(3)[np.argmin(np.abs(a), axis=-1)]
        opposite = q[..., :1] < 1e-15
        q[..., 1:] = np.where(opposite, cross(a, least), q[..., 1:])
        q[..., :1] = np.where(opposite, 0.0, q[..., :1])
    return normalise(q)


def from_axes(y_axis: Floats, up: Floats) -> Floats:
    """The orientation (4,) whose z axis is `up` exactly and whose y axis lies nearest to `y_axis`; both (3,)."""
    z = up / math.sqrt(up @ up)
    x = cross(y_axis, z)
    x /= math.sqrt(x @ x)
    return from_matrix(np.array((x, cross(z, x), z)).T)


def from_matrix(m: Floats) -> Floats:
    """Unit quaternion (4,) of one rotation matrix (3, 3), by the largest of Shepperd's four divisors (1978)."""
    (a, b, c), (d, e, f), (g, h, i) = m.tolist()
    parts = (
        (1.0 + a + e + i, h - f, c - g, d - b),
        (h - f, 1.0 + a - e - i, b + d, c + g),
        (c - g, b + d, 1.0 + e - a - i, f + h),
        (d - b, c + g, f + h, 1.0 + i - a - e),
    )
    best = max(range(4), key=lambda k: parts[k][k])
    q = np.array(parts[best])
    return q / math.sqrt(q @ q)


def yaw(q: Floats) -> float:
    """Heading of q (4,), radians about world z: where its x axis points, seen from above."""
    w, x, y, z = q.tolist()
    return math.atan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z))


def about_z(angle_rad: float) -> Floats:
    """The quaternion (4,) of a turn about world z."""
    return np.array([math.cos(0.5 * angle_rad), 0.0, 0.0, math.sin(0.5 * angle_rad)])
