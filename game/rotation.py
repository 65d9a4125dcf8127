"""Unit quaternions (w, x, y, z) and rotation vectors, vectorised over leading axes, float64."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

IDENTITY: Floats = np.array([1.0, 0.0, 0.0, 0.0])


def multiply(a: Floats, b: Floats) -> Floats:
    """Hamilton product a b, (..., 4): first b, then a."""
    aw, ax, ay, az = a[..., 0], a[..., 1], a[..., 2], a[..., 3]
    bw, bx, by, bz = b[..., 0], b[..., 1], b[..., 2], b[..., 3]
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    out[..., 0] = aw * bw - ax * bx - ay * by - az * bz
    out[..., 1] = aw * bx + ax * bw + ay * bz - az * by
    out[..., 2] = aw * by - ax * bz + ay * bw + az * bx
    out[..., 3] = aw * bz + ax * by - ay * bx + az * bw
    return out


_CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])


def conjugate(q: Floats) -> Floats:
    """The inverse of a unit quaternion, (..., 4)."""
    return q * _CONJUGATE


def cross(a: Floats, b: Floats) -> Floats:
    """a x b, (..., 3); several times faster than numpy.cross on small arrays."""
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    a0, a1, a2 = a[..., 0], a[..., 1], a[..., 2]
    b0, b1, b2 = b[..., 0], b[..., 1], b[..., 2]
    out[..., 0] = a1 * b2 - a2 * b1
    out[..., 1] = a2 * b0 - a0 * b2
    out[..., 2] = a0 * b1 - a1 * b0
    return out


def rotate(q: Floats, v: Floats) -> Floats:
    """Vectors v (..., 3) turned by q (..., 4)."""
    t = 2.0 * cross(q[..., 1:], v)
    return v + q[..., :1] * t + cross(q[..., 1:], t)


def unrotate(q: Floats, v: Floats) -> Floats:
    """Vectors v (..., 3) turned by the inverse of q."""
    return rotate(conjugate(q), v)


def normalise(q: Floats) -> Floats:
    """Quaternions scaled to unit length."""
    return q / np.sqrt(np.sum(q * q, axis=-1, keepdims=True))


def exp(rotation_vector: Floats) -> Floats:
    """Rotation vector (..., 3) rad to unit quaternion; exact at zero."""
    angle = np.sqrt(np.sum(rotation_vector * rotation_vector, axis=-1, keepdims=True))
    half = 0.5 * angle
    return np.concatenate((np.cos(half), 0.5 * np.sinc(half / np.pi) * rotation_vector), axis=-1)


def log(q: Floats) -> Floats:
    """Unit quaternion to the shortest rotation vector (..., 3) rad, |angle| <= pi."""
    q = np.where(q[..., :1] < 0.0, -q, q)
    sine = np.sqrt(np.sum(q[..., 1:] * q[..., 1:], axis=-1, keepdims=True))
    angle = 2.0 * np.arctan2(sine, q[..., :1])
    scale = np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 2.0)
    return scale * q[..., 1:]


def between(a: Floats, b: Floats) -> Floats:
    """The smallest rotation that turns direction a (..., 3) to direction b; opposite directions turn about any normal."""
    a = a / np.sqrt(np.sum(a * a, axis=-1, keepdims=True))
    b = b / np.sqrt(np.sum(b * b, axis=-1, keepdims=True))
    w = 1.0 + np.sum(a * b, axis=-1, keepdims=True)
    axis = cross(a, b)
    if np.any(w < 1e-9):
        normal = cross(a, np.broadcast_to([1.0, 0.0, 0.0], a.shape))
        other = cross(a, np.broadcast_to([0.0, 1.0, 0.0], a.shape))
        longer = np.sum(normal**2, axis=-1, keepdims=True) > np.sum(other**2, axis=-1, keepdims=True)
        axis = np.where(w < 1e-9, np.where(longer, normal, other), axis)
        w = np.where(w < 1e-9, 0.0, w)
    return normalise(np.concatenate((w, axis), axis=-1))


def matrix(q: Floats) -> Floats:
    """Rotation matrices (..., 3, 3) of unit quaternions."""
    w, x, y, z = q[..., 0], q[..., 1], q[..., 2], q[..., 3]
    out = np.empty((*q.shape[:-1], 3, 3))
    xx, yy, zz, xy, xz, yz = x * x, y * y, z * z, x * y, x * z, y * z
    wx, wy, wz = w * x, w * y, w * z
    out[..., 0, 0] = 1.0 - 2.0 * (yy + zz)
    out[..., 0, 1] = 2.0 * (xy - wz)
    out[..., 0, 2] = 2.0 * (xz + wy)
    out[..., 1, 0] = 2.0 * (xy + wz)
    out[..., 1, 1] = 1.0 - 2.0 * (xx + zz)
    out[..., 1, 2] = 2.0 * (yz - wx)
    out[..., 2, 0] = 2.0 * (xz - wy)
    out[..., 2, 1] = 2.0 * (yz + wx)
    out[..., 2, 2] = 1.0 - 2.0 * (xx + yy)
    return out


def from_axes(y_axis: Floats, up: Floats) -> Floats:
    """The orientation (4,) whose z axis is `up` exactly and whose y axis lies nearest to `y_axis`; both (3,)."""
    z = up / np.sqrt(up @ up)
    x = cross(y_axis, z)
    x /= np.sqrt(x @ x)
    return from_matrix(np.stack((x, cross(z, x), z), axis=-1))


def from_matrix(m: Floats) -> Floats:
    """Unit quaternion (4,) of one rotation matrix (3, 3), by the largest of Shepperd's four divisors (1978)."""
    trace = m[0, 0] + m[1, 1] + m[2, 2]
    candidates = (trace, m[0, 0], m[1, 1], m[2, 2])
    k = int(np.argmax(candidates))
    if k == 0:
        q = np.array([1.0 + trace, m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]])
    else:
        i, j, l = k - 1, k % 3, (k + 1) % 3
        q = np.empty(4)
        q[0] = m[l, j] - m[j, l]
        q[1 + i] = 1.0 + m[i, i] - m[j, j] - m[l, l]
        q[1 + j] = m[j, i] + m[i, j]
        q[1 + l] = m[l, i] + m[i, l]
    return q / np.sqrt(q @ q)


def yaw(q: Floats) -> float:
    """Heading of q (4,), radians about world z: where its x axis points, seen from above."""
    w, x, y, z = (float(c) for c in q)
    return float(np.arctan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z)))


def about_z(angle_rad: float) -> Floats:
    """The quaternion (4,) of a turn about world z."""
    return np.array([np.cos(0.5 * angle_rad), 0.0, 0.0, np.sin(0.5 * angle_rad)])
