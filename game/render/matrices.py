"""4 x 4 transforms in plain floats: for one matrix at a time that is many times faster than numpy.

A Matrix is 16 floats, column by column as OpenGL reads them; clip space is OpenGL's (-1..1 on all axes, camera looks along -z).
"""

import math

Matrix = tuple[float, ...]
Vector = tuple[float, float, float]


def subtract(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a: Vector) -> Vector:
    """a scaled to length 1; the zero vector stays zero."""
    length = math.sqrt(dot(a, a)) or 1.0
    return (a[0] / length, a[1] / length, a[2] / length)


def multiply(a: Matrix, b: Matrix) -> Matrix:
    """The product a b."""
    return tuple(a[r] * b[c] + a[r + 4] * b[c + 1] + a[r + 8] * b[c + 2] + a[r + 12] * b[c + 3] for c in (0, 4, 8, 12) for r in range(4))


def look_at(eye: Vector, target: Vector, up: Vector = (0.0, 0.0, 1.0)) -> Matrix:
    """World to camera: camera at eye, looking at target (m)."""
    forward = unit(subtract(target, eye))
    right = unit(cross(forward, up))
    above = cross(right, forward)
    return (
        *(right[0], above[0], -forward[0], 0.0),
        *(right[1], above[1], -forward[1], 0.0),
        *(right[2], above[2], -forward[2], 0.0),
        *(-dot(right, eye), -dot(above, eye), dot(forward, eye), 1.0),
    )


def perspective(fov_rad: float, aspect: float, near: float, far: float) -> Matrix:
    """Camera to clip space; fov_rad is the vertical field of view, aspect is width / height."""
    scale = 1.0 / math.tan(fov_rad / 2.0)
    depth = near - far
    return (scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, (far + near) / depth, -1.0, 0, 0, 2.0 * far * near / depth, 0.0)


def orthographic(half_width: float, half_height: float, near: float, far: float) -> Matrix:
    """Camera to clip space without perspective; half sizes in metres."""
    depth = far - near
    return (1.0 / half_width, 0, 0, 0, 0, 1.0 / half_height, 0, 0, 0, 0, -2.0 / depth, 0, 0, 0, -(far + near) / depth, 1.0)


def transform(matrix: Matrix, point: Vector) -> tuple[float, float, float, float]:
    """Homogeneous image of a point."""
    x, y, z = point
    a, b, c, d = (matrix[i] * x + matrix[i + 4] * y + matrix[i + 8] * z + matrix[i + 12] for i in range(4))
    return (a, b, c, d)
