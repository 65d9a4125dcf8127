"""Depth pictures of furnished rooms whose floor is known, ray-cast with the noise, rounding, shadows and holes of a Kinect v1.

Room frame: x to the sensor's left, y up, z away, origin on the floor under the sensor. Boxes stand on the floor, turned about y.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from kinect.body import Floats
from kinect.depth.depth_frame import COUNTS_PER_G, DepthFrame
from kinect.depth.disparity import NO_DATA, inverse_depth
from kinect.depth.intrinsics import HEIGHT, WIDTH, Intrinsics, factory_intrinsics
from kinect.device_calibration import TYPICAL

NOISE_CODES = 0.35
BASELINE_PX_M = TYPICAL.focal_px * TYPICAL.baseline_m


@dataclass(frozen=True)
class Box:
    """centre x, z and bottom y (m), size x, y, z (m), turned by turn_deg about the vertical."""

    x: float
    y: float
    z: float
    size: tuple[float, float, float]
    turn_deg: float = 0.0


@dataclass(frozen=True)
class Stand:
    """How the sensor stands: height_m over the floor, pitch up and roll (its left side up), degrees."""

    height_m: float
    pitch_deg: float
    roll_deg: float = 0.0

    def to_room(self) -> Floats:
        """(3, 3): sensor axes to room axes."""
        p, r = np.radians((self.pitch_deg, self.roll_deg))
        pitch = np.array([[1, 0, 0], [0, np.cos(p), np.sin(p)], [0, -np.sin(p), np.cos(p)]])
        roll = np.array([[np.cos(r), -np.sin(r), 0], [np.sin(r), np.cos(r), 0], [0, 0, 1]])
        return pitch @ roll

    def up(self) -> Floats:
        """(3,) unit up in the sensor frame: the true normal of the floor."""
        return self.to_room().T @ np.array([0.0, 1.0, 0.0])


def person(x: float, z: float) -> tuple[Box, ...]:
    legs = tuple(Box(x + side, 0.0, z, (0.13, 0.85, 0.14)) for side in (-0.12, 0.12))
    feet = tuple(Box(x + side, 0.0, z - 0.08, (0.1, 0.08, 0.26)) for side in (-0.12, 0.12))
    return (*legs, *feet, Box(x, 0.85, z, (0.4, 0.6, 0.22)), Box(x, 1.5, z, (0.16, 0.24, 0.2)))


def chair(x: float, z: float, turn_deg: float) -> tuple[Box, ...]:
    return (
        Box(x, 0.4, z, (0.45, 0.06, 0.45), turn_deg),
        Box(x, 0.0, z, (0.08, 0.4, 0.08)),
        Box(x, 0.46, z + 0.2, (0.45, 0.45, 0.05), turn_deg),
    )


FURNITURE: tuple[Box, ...] = (
    Box(1.6, 0.0, 3.0, (0.9, 0.42, 2.0)),  # sofa seat along the left wall
    Box(1.95, 0.42, 3.0, (0.25, 0.45, 2.0)),  # its back
    Box(-1.3, 0.68, 3.4, (1.4, 0.04, 0.8), 12.0),  # table top
    *(Box(-1.3 + dx, 0.0, 3.4 + dz, (0.06, 0.68, 0.06), 12.0) for dx in (-0.6, 0.6) for dz in (-0.3, 0.3)),
    *chair(-0.9, 2.7, 30.0),
    *(Box(0.2, level, 4.6, (1.2, 0.03, 0.35)) for level in (0.1, 0.5, 0.9, 1.3)),  # a shelf
    Box(0.4, 0.0, 2.6, (1.6, 0.012, 1.4), 8.0),  # a rug
)


@lru_cache(maxsize=64)
def depth_frame(
    stand: Stand, boxes: tuple[Box, ...] = FURNITURE, *, seed: int = 0, accel_error_deg: float = 0.0, warp_codes: float = 0.0
) -> DepthFrame:
    """What a typical device shows of the boxes in a room 4.4 m wide, 5 m deep and 2.5 m high."""
    rng = np.random.default_rng(seed)
    intrinsics = factory_intrinsics(TYPICAL)
    inverse = _inverse_depth(stand, boxes, intrinsics)
    a, b = inverse_depth(TYPICAL)
    code = b - a * inverse + warp_codes * _lens_warp()
    raw = np.round(code + rng.normal(0.0, NOISE_CODES, code.shape))
    lost = _in_shadow(inverse) | (inverse <= 0.0) | (inverse > 1.0 / 0.45) | (raw > 1040) | (rng.random(code.shape) < 0.01)
    lost[:, WIDTH - 8 :] = True
    raw = np.where(lost, NO_DATA, np.clip(raw, 0, NO_DATA)).astype(np.uint16)
    raw.flags.writeable = False
    return DepthFrame(raw, 0.0, 0, _accelerometer(stand, accel_error_deg, rng), TYPICAL, intrinsics)


def _lens_warp() -> Floats:
    """A smooth bend of the picture between -1 and 1, as lenses leave it: rings about the centre."""
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    return np.cos(2.0 * np.pi * np.hypot(u - WIDTH / 2, v - HEIGHT / 2) / 500.0)


def _inverse_depth(stand: Stand, boxes: tuple[Box, ...], intrinsics: Intrinsics) -> Floats:
    """1 / z of the first surface each pixel meets, (480, 640); 0 where none."""
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH].astype(np.float64)
    x, y = -(u - intrinsics.centre_u) / intrinsics.focal_px, -(v - intrinsics.centre_v) / intrinsics.focal_px
    ahead = stand.to_room() @ np.stack((x, y, np.ones_like(x))).reshape(3, -1)
    eye = np.array([0.0, stand.height_m, 0.0])
    nearest = _slabs(eye, ahead, np.array([-2.2, 0.0, -1.0]), np.array([2.2, 2.5, 5.0]))[1]
    for box in boxes:
        np.minimum(nearest, _enter(eye, ahead, box), out=nearest)
    return (1.0 / nearest).reshape(HEIGHT, WIDTH)


def _slabs(eye: Floats, ahead: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """Where rays from eye (3,) along ahead (3, N) enter and leave a box, in lengths of ahead, (N,) each."""
    enter, leave = np.full(ahead.shape[1], -np.inf), np.full(ahead.shape[1], np.inf)
    for axis in range(3):
        step = 1.0 / np.where(ahead[axis] == 0.0, 1e-12, ahead[axis])
        one, two = (low[axis] - eye[axis]) * step, (high[axis] - eye[axis]) * step
        np.maximum(enter, np.minimum(one, two), out=enter)
        np.minimum(leave, np.maximum(one, two), out=leave)
    return enter, leave


def _enter(eye: Floats, ahead: Floats, box: Box) -> Floats:
    turn = np.radians(box.turn_deg)
    about = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
    half = np.array(box.size) / 2.0
    centre = np.array([box.x, box.y + half[1], box.z])
    enter, leave = _slabs(about @ (eye - centre), about @ ahead if box.turn_deg else ahead, -half, half)
    return np.where((enter > 0.0) & (enter < leave), enter, np.inf)


def _in_shadow(inverse: Floats) -> np.ndarray:
    """Pixels whose surface the pattern cannot reach: something nearer to their right hides it from the emitter."""
    hidden = np.zeros(inverse.shape, dtype=bool)
    for k in range(1, 41):
        hidden[:, :-k] |= inverse[:, k:] - inverse[:, :-k] > k / BASELINE_PX_M
    return hidden


def _accelerometer(stand: Stand, error_deg: float, rng: np.random.Generator) -> tuple[int, int, int]:
    up = stand.up()
    aside = np.cross(up, rng.normal(size=3))
    felt = up + np.tan(np.radians(error_deg)) * aside / np.linalg.norm(aside)
    x, y, z = np.round(COUNTS_PER_G * felt / np.linalg.norm(felt)).astype(int)
    return int(x), int(y), int(z)
