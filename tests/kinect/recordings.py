"""A small made-up recording, and the raw arrays of its file, for the tests of this room."""

from pathlib import Path

import numpy as np

from kinect.body import Floor
from kinect.clip import Clip, checked_clip

SHARED = Path(__file__).resolve().parents[2] / ".." / "shared" / "data" / "clips"


def standing_joints() -> np.ndarray:
    """(20, 3) a person 2.5 m from a level sensor 0.9 m above the floor, ankles 0.08 m above it."""
    heights = [0.97, 1.05, 1.45, 1.63, 1.40, 1.11, 0.85, 0.77, 1.40, 1.11, 0.85, 0.77, 0.90, 0.48, 0.08, 0.02, 0.90, 0.48, 0.08, 0.02]
    sides = [0.0, 0.0, 0.0, 0.0, -0.18, -0.2, -0.2, -0.2, 0.18, 0.2, 0.2, 0.2, -0.09, -0.1, -0.1, -0.1, 0.09, 0.1, 0.1, 0.1]
    return np.column_stack([sides, np.array(heights) - 0.9, np.full(20, 2.5)])


def moving_clip(frames: int = 40, floor: Floor | None = None) -> Clip:
    """A person who sways and lifts the left foot for a while, at 30 frames a second."""
    t = np.arange(frames) / 30.0
    positions = np.repeat(standing_joints()[None], frames, axis=0)
    positions[:, :, 0] += 0.02 * np.sin(3.0 * t)[:, None] * (standing_joints()[:, 1] + 0.82)
    positions[frames // 2 : frames // 2 + 6, 13:16, 1] += 0.15
    confidence = np.ones((frames, 20))
    confidence[3:6, 11] = 0.5
    return checked_clip("made up", positions, confidence, t, floor, None, {"motion": "sway", "license": "CC0"})


def raw_fields(clip: Clip) -> dict[str, np.ndarray]:
    """The arrays of a .npz recording, for tests that spoil one of them."""
    return {"positions": clip.positions, "confidence": clip.confidence, "t": clip.t}
