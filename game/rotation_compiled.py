"""Single rotations for compiled loops: quaternions (w, x, y, z), matrices, rotation vectors. See `game.rotation` for arrays of them."""

import math

import numpy as np

from game.compiled import compiled

Floats = np.ndarray


@compiled
def multiply(a: Floats, b: Floats) -> Floats:
    """Hamilton product (4,): first b, then a."""
    out = np.empty(4)
    out[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3]
    out[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2]
    out[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1]
    out[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]
    return out


@compiled
def conjugate(q: Floats) -> Floats:
    """The inverse of a unit quaternion."""
    out = -q
    out[0] = q[0]
    return out


@compiled
def cross(a: Floats, b: Floats) -> Floats:
    """a x b, (3,)."""
    out = np.empty(3)
    out[0] = a[1] * b[2] - a[2] * b[1]
    out[1] = a[2] * b[0] - a[0] * b[2]
    out[2] = a[0] * b[1] - a[1] * b[0]
    return out


@compiled
def add_cross(out: Floats, a: Floats, b: Floats) -> None:
    """out += a x b, (3,)."""
    out[0] += a[1] * b[2] - a[2] * b[1]
    out[1] += a[2] * b[0] - a[0] * b[2]
    out[2] += a[0] * b[1] - a[1] * b[0]


@compiled
def dot(a: Floats, b: Floats) -> float:
    """a . b of (3,) vectors."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled
def length(a: Floats) -> float:
    """|a| of a (3,) vector."""
    return math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])


@compiled
def matrix(q: Floats) -> Floats:
    """(3, 3) of a unit quaternion."""
    w, x, y, z = q[0], q[1], q[2], q[3]
    m = np.empty((3, 3))
    m[0, 0] = w * w + x * x - y * y - z * z
    m[1, 1] = w * w - x * x + y * y - z * z
    m[2, 2] = w * w - x * x - y * y + z * z
    m[0, 1], m[1, 0] = 2.0 * (x * y - w * z), 2.0 * (x * y + w * z)
    m[0, 2], m[2, 0] = 2.0 * (x * z + w * y), 2.0 * (x * z - w * y)
    m[1, 2], m[2, 1] = 2.0 * (y * z - w * x), 2.0 * (y * z + w * x)
    return m


@compiled
def turn(m: Floats, v: Floats) -> Floats:
    """m v."""
    out = np.empty(3)
    for i in range(3):
        out[i] = m[i, 0] * v[0] + m[i, 1] * v[1] + m[i, 2] * v[2]
    return out


@compiled
def add_turned(out: Floats, m: Floats, v: Floats) -> None:
    """out += m v."""
    for i in range(3):
        out[i] += m[i, 0] * v[0] + m[i, 1] * v[1] + m[i, 2] * v[2]


@compiled
def turn_back(m: Floats, v: Floats) -> Floats:
    """The transpose of m times v."""
    out = np.empty(3)
    for i in range(3):
        out[i] = m[0, i] * v[0] + m[1, i] * v[1] + m[2, i] * v[2]
    return out


@compiled
def product(a: Floats, b: Floats) -> Floats:
    """a b of (3, 3) matrices."""
    out = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            out[i, j] = a[i, 0] * b[0, j] + a[i, 1] * b[1, j] + a[i, 2] * b[2, j]
    return out


@compiled
def normalise(q: Floats) -> Floats:
    """Scaled to unit length."""
    total = 0.0
    for c in q:
        total += c * c
    return q / math.sqrt(total + 1e-60)


@compiled
def exp(v: Floats) -> Floats:
    """Rotation vector (3,) to unit quaternion; exact at zero."""
    half = 0.5 * math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + 1e-60)
    scale = 0.5 * math.sin(half) / half
    out = np.empty(4)
    out[0] = math.cos(half)
    for i in range(3):
        out[i + 1] = v[i] * scale
    return out


@compiled
def log(q: Floats) -> Floats:
    """Unit quaternion to the shortest rotation vector (3,)."""
    sine = math.sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3] + 1e-60)
    scale = 2.0 * math.atan2(sine, abs(q[0])) / (sine if q[0] >= 0.0 else -sine)
    out = np.empty(3)
    for i in range(3):
        out[i] = q[i + 1] * scale
    return out


@compiled
def turn_to(a: Floats, b: Floats) -> tuple[float, float, float]:
    """log(conjugate(a) b): the shortest rotation vector from orientation a to orientation b, in the frame of a; makes no arrays."""
    w = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
    x = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2]
    y = a[0] * b[2] + a[1] * b[3] - a[2] * b[0] - a[3] * b[1]
    z = a[0] * b[3] - a[1] * b[2] + a[2] * b[1] - a[3] * b[0]
    sine = math.sqrt(x * x + y * y + z * z + 1e-60)
    scale = 2.0 * math.atan2(sine, abs(w)) / (sine if w >= 0.0 else -sine)
    return x * scale, y * scale, z * scale


@compiled
def turns_to(before: Floats, after: Floats) -> Floats:
    """(3 n,) `turn_to` from each of `before` (n, 4) to each of `after` (n, 4)."""
    out = np.empty(3 * len(before))
    for j in range(len(before)):
        out[3 * j], out[3 * j + 1], out[3 * j + 2] = turn_to(before[j], after[j])
    return out


@compiled
def turn_by(a: Floats, b: Floats) -> tuple[float, float, float]:
    """log(b conjugate(a)): the rotation vector of `turn_to` in the frame in which both orientations are given; makes no arrays."""
    w = b[0] * a[0] + b[1] * a[1] + b[2] * a[2] + b[3] * a[3]
    x = -b[0] * a[1] + b[1] * a[0] - b[2] * a[3] + b[3] * a[2]
    y = -b[0] * a[2] + b[1] * a[3] + b[2] * a[0] - b[3] * a[1]
    z = -b[0] * a[3] - b[1] * a[2] + b[2] * a[1] + b[3] * a[0]
    sine = math.sqrt(x * x + y * y + z * z + 1e-60)
    scale = 2.0 * math.atan2(sine, abs(w)) / (sine if w >= 0.0 else -sine)
    return x * scale, y * scale, z * scale


@compiled
def between(a: Floats, b: Floats) -> Floats:
    """The smallest rotation (4,) that turns unit direction a to unit direction b; opposites turn about any normal."""
    q = np.empty(4)
    q[0] = 1.0 + dot(a, b)
    q[1:] = cross(a, b)
    if q[0] < 1e-9:
        least = np.zeros(3)
        least[np.argmin(np.abs(a))] = 1.0
        q[0] = 0.0
        q[1:] = cross(a, least)
    return normalise(q)


@compiled
def yaw(q: Floats) -> float:
    """Heading of q, radians about world z."""
    return math.atan2(2.0 * (q[1] * q[2] + q[0] * q[3]), 1.0 - 2.0 * (q[2] * q[2] + q[3] * q[3]))


@compiled
def wrapped(angle_rad: float) -> float:
    """The same direction within half a turn, of an angle within one and a half: of the difference of two headings."""
    if angle_rad > math.pi:
        return angle_rad - 2.0 * math.pi
    return angle_rad + 2.0 * math.pi if angle_rad < -math.pi else angle_rad


@compiled
def turn_within(heading_rad: float, from_rad: float, most_rad: float) -> float:
    """rad that a heading has to turn to lie no farther than `most_rad` from another one; 0 where it does."""
    off = wrapped(heading_rad - from_rad)
    return min(max(off, -most_rad), most_rad) - off


@compiled
def about_z(angle_rad: float) -> Floats:
    """The quaternion of a turn about world z."""
    q = np.zeros(4)
    q[0], q[3] = math.cos(0.5 * angle_rad), math.sin(0.5 * angle_rad)
    return q


@compiled
def from_axes(y_axis: Floats, up: Floats) -> Floats:
    """The orientation (4,) whose z axis is `up` exactly and whose y axis lies nearest to `y_axis`, by Shepperd's method (1978)."""
    z = normalise(up)
    x = normalise(cross(y_axis, z))
    y = cross(z, x)
    trace = x[0] + y[1] + z[2]
    q = np.empty(4)
    if trace >= x[0] and trace >= y[1] and trace >= z[2]:
        q[0], q[1], q[2], q[3] = 1.0 + trace, y[2] - z[1], z[0] - x[2], x[1] - y[0]
    elif x[0] >= y[1] and x[0] >= z[2]:
        q[0], q[1], q[2], q[3] = y[2] - z[1], 1.0 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2]
    elif y[1] >= z[2]:
        q[0], q[1], q[2], q[3] = z[0] - x[2], y[0] + x[1], 1.0 + y[1] - x[0] - z[2], z[1] + y[2]
    else:
        q[0], q[1], q[2], q[3] = x[1] - y[0], z[0] + x[2], z[1] + y[2], 1.0 + z[2] - x[0] - y[1]
    return normalise(q)
