"""The player's camera: orbits a target, pans, zooms, glides between presets and never leaves the room."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game.render.matrices import Matrix, Vector, cross, look_at, multiply, perspective, subtract, transform, unit
from game.scenes.scene import CameraHint

NEAR_M, FAR_M = 0.1, 40.0
_LOWEST_M = 0.12
_NEAREST_M, _FARTHEST_M = 0.6, 12.0
_STEEPEST_RAD = math.radians(88.0)
_PRESET_FOV_DEG = 40.0


@dataclass(frozen=True)
class Room:
    """The block of air a camera may be in: low and high corner (m). Higher than the ceiling, which is seen only from below."""

    low: Vector = (-3.1, -3.05, _LOWEST_M)
    high: Vector = (3.55, 3.0, 6.0)


@dataclass(frozen=True)
class _Place:
    target: Vector
    azimuth: float
    height: float
    distance: float
    fov_deg: float


def _place(hint: CameraHint) -> _Place:
    x, y, z = subtract(hint.eye, hint.target)
    distance = math.sqrt(x * x + y * y + z * z)
    return _Place(hint.target, math.atan2(y, x), math.asin(z / distance) if distance else 0.0, distance, hint.fov_deg)


class Camera:
    """Where the picture is taken from. Angles in radians, lengths in metres, world frame."""

    def __init__(self, hint: CameraHint, room: Room | None = None) -> None:
        self.room = room or Room()
        self._now = self._from = self._to = _place(hint)
        self._glide_s = self._glided_s = 0.0

    @property
    def target(self) -> Vector:
        return self._now.target

    @property
    def eye(self) -> Vector:
        """Where the camera stands: on its orbit, or where the orbit meets floor or wall."""
        at = self._now
        level = math.cos(at.height)
        way = (math.cos(at.azimuth) * level, math.sin(at.azimuth) * level, math.sin(at.height))
        reach = min(_free_distance(at.target, way, self.room), at.distance)
        return (at.target[0] + way[0] * reach, at.target[1] + way[1] * reach, at.target[2] + way[2] * reach)

    def orbit(self, azimuth_rad: float, height_rad: float) -> None:
        """Walk round the target (positive: counter-clockwise seen from above) and climb."""
        at = self._now
        height = max(-0.2, min(_STEEPEST_RAD, at.height + height_rad))
        self._settle(_Place(at.target, at.azimuth + azimuth_rad, height, at.distance, at.fov_deg))

    def pan(self, right: float, up: float) -> None:
        """Shift camera and target by parts of the picture height."""
        at = self._now
        forward = unit(subtract(at.target, self.eye))
        side = unit(cross(forward, (0.0, 0.0, 1.0)))
        above = cross(side, forward)
        metres = 2.0 * at.distance * math.tan(math.radians(at.fov_deg) / 2.0)
        moved = (at.target[i] + metres * (right * side[i] + up * above[i]) for i in range(3))
        x, y, z = (max(low, min(high, value)) for value, low, high in zip(moved, self.room.low, self.room.high, strict=True))
        self._settle(_Place((x, y, z), at.azimuth, at.height, at.distance, at.fov_deg))

    def zoom(self, factor: float) -> None:
        """Multiply the distance to the target; below 1 goes nearer."""
        at = self._now
        distance = max(_NEAREST_M, min(_FARTHEST_M, at.distance * factor))
        self._settle(_Place(at.target, at.azimuth, at.height, distance, at.fov_deg))

    def go_to(self, hint: CameraHint, seconds: float = 0.0) -> None:
        """Cut to a preset, or glide there within `seconds` of `advance`."""
        goal = _place(hint)
        turn = (goal.azimuth - self._now.azimuth + math.pi) % (2.0 * math.pi) - math.pi  # the short way round
        self._from = self._now
        self._to = _Place(goal.target, self._now.azimuth + turn, goal.height, goal.distance, goal.fov_deg)
        self._glide_s, self._glided_s = seconds, 0.0
        if seconds <= 0.0:
            self._settle(goal)

    def follow(self, target: Vector, dt: float, time_constant_s: float = 0.6) -> None:
        """Drift the target towards a moving point, as a person holding the camera would."""
        share = 1.0 - math.exp(-dt / time_constant_s)
        at = self._now
        x, y, z = (a + share * (b - a) for a, b in zip(at.target, target, strict=True))
        self._now = _Place((x, y, z), at.azimuth, at.height, at.distance, at.fov_deg)

    def advance(self, dt: float) -> None:
        """Let `dt` seconds of a glide pass."""
        if self._glide_s <= 0.0:
            return
        self._glided_s = min(self._glided_s + dt, self._glide_s)
        t = self._glided_s / self._glide_s
        s = t * t * (3.0 - 2.0 * t)
        a, b = self._from, self._to
        x, y, z = (p + s * (q - p) for p, q in zip(a.target, b.target, strict=True))
        pairs = ((a.azimuth, b.azimuth), (a.height, b.height), (a.distance, b.distance), (a.fov_deg, b.fov_deg))
        mixed = (p + s * (q - p) for p, q in pairs)
        azimuth, height, distance, fov = mixed
        self._now = _Place((x, y, z), azimuth, height, distance, fov)
        if t >= 1.0:
            self._glide_s = 0.0

    def fov_rad(self, fov_deg: float = _PRESET_FOV_DEG) -> float:
        """Vertical field of view; `fov_deg` is what the player set where a preset asks for 40 degrees."""
        wider = math.tan(math.radians(fov_deg) / 2.0) / math.tan(math.radians(_PRESET_FOV_DEG) / 2.0)
        return 2.0 * math.atan(math.tan(math.radians(self._now.fov_deg) / 2.0) * wider)

    def view(self) -> Matrix:
        """World to camera."""
        return look_at(self.eye, self._now.target)

    def view_projection(self, aspect: float, fov_deg: float = _PRESET_FOV_DEG) -> Matrix:
        """World to clip space; aspect is width / height of the picture."""
        return multiply(perspective(self.fov_rad(fov_deg), aspect, NEAR_M, FAR_M), self.view())

    def project(self, point: NDArray[np.float64], size: tuple[int, int], fov_deg: float = _PRESET_FOV_DEG) -> tuple[float, float] | None:
        """Pixel (from the left, from the top) of a world point (3,) in a picture of (width, height), None behind the camera."""
        x, y, _, w = transform(self.view_projection(size[0] / size[1], fov_deg), (float(point[0]), float(point[1]), float(point[2])))
        if w <= NEAR_M:
            return None
        return (0.5 + 0.5 * x / w) * size[0], (0.5 - 0.5 * y / w) * size[1]

    def _settle(self, place: _Place) -> None:
        self._now = self._from = self._to = place
        self._glide_s = 0.0


def _free_distance(start: Vector, way: Vector, room: Room) -> float:
    """How far from start along the unit vector `way` before a face of the room is met; never less than 0.3 m."""
    free = math.inf
    for at, step, low, high in zip(start, way, room.low, room.high, strict=True):
        if abs(step) > 1e-9:
            free = min(free, ((high if step > 0.0 else low) - at) / step)
    return max(free, 0.3)
