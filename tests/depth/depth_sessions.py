"""Small synthetic depth sessions, and how other programs would have written them to disk."""

import struct
from pathlib import Path

import numpy as np

from kinect.depth.depth_frame import DepthFrame
from kinect.depth.intrinsics import Intrinsics, factory_intrinsics
from kinect.device_calibration import TYPICAL, DeviceCalibration

STEP_TICKS = 2_002_155
DEVICE = DeviceCalibration(1.17, 0.00103, 0.0747, 203.0)
LENS = Intrinsics(581.0, 318.5, 243.25)


def raw_pictures(count: int, seed: int = 0) -> np.ndarray:
    """(count, 480, 640) uint16: slopes, steps and missing pixels, another one each frame."""
    rng = np.random.default_rng(seed)
    v, u = np.mgrid[0:480, 0:640]
    slope = 600 + u // 4 + v // 3
    out = np.stack([slope + 3 * k for k in range(count)]) + rng.integers(0, 2, (count, 480, 640))
    out[:, 100:180, 200:260] = 500
    out[rng.random(out.shape) < 0.02] = 2047
    out[:, :, 632:] = 2047
    return out.astype(np.uint16)


def session(count: int, *, first_ticks: int = 1000, accel: bool = True, typical: bool = False, seed: int = 0) -> list[DepthFrame]:
    """Frames as a sensor would give them, one step of its clock apart."""
    calibration, lens = (TYPICAL, factory_intrinsics(TYPICAL)) if typical else (DEVICE, LENS)
    return [
        DepthFrame(raw, k * STEP_TICKS / 60e6, (first_ticks + k * STEP_TICKS) % 2**32, (k, 804, 192) if accel else None, calibration, lens)
        for k, raw in enumerate(raw_pictures(count, seed))
    ]


def write_fakenect(folder: Path, frames: list[DepthFrame]) -> None:
    """As libfreenect's record program does: a depth file and an accelerometer file a frame, and the index."""
    folder.mkdir(parents=True, exist_ok=True)
    lines = []
    for k, frame in enumerate(frames):
        host = 1483969352.25 + frame.time_s
        accel, depth = f"a-{host - 0.001:.6f}-{frame.ticks}.dump", f"d-{host:.6f}-{frame.ticks}.pgm"
        colour = f"r-{host:.6f}-{frame.ticks}.ppm"
        x, y, z = frame.accel or (0, 819, 0)
        (folder / accel).write_bytes(struct.pack("<hhhbxi", x, y, z, 26, 0))
        (folder / depth).write_bytes(b"P5 640 480 65535\n" + frame.raw.astype("<u2").tobytes())
        lines += [accel, depth] + ([colour] if k % 2 else [])  # a colour file that is named but never needed
    (folder / "INDEX.txt").write_text("\n".join(lines) + "\n")


def same(one: DepthFrame, other: DepthFrame) -> bool:
    """The same picture, taken at the same time, by the same sensor."""
    return (
        np.array_equal(one.raw, other.raw)
        and abs(one.time_s - other.time_s) < 1e-6
        and (one.ticks, one.accel) == (other.ticks, other.accel)
        and (one.calibration, one.intrinsics) == (other.calibration, other.intrinsics)
    )
