"""Where the camera may stand, scene by scene; the first of each is where a newcomer starts."""

from collections.abc import Mapping

from game.scenes.scene import CameraHint

CAMERAS: Mapping[str, Mapping[str, CameraHint]] = {
    "mirror": {
        "front": CameraHint((3.4, 0.9, 1.45), (0.0, 0.0, 0.92), 40.0),
        "side": CameraHint((0.3, 3.4, 1.3), (0.0, 0.0, 0.9), 42.0),
        "behind": CameraHint((-3.0, -0.9, 1.7), (0.3, 0.0, 1.0), 45.0),
        "feet": CameraHint((1.6, 0.7, 0.5), (0.0, 0.0, 0.35), 40.0),
        "above": CameraHint((0.6, 0.0, 4.2), (0.1, 0.0, 0.5), 45.0),
    },
    "duel": {
        "ringside": CameraHint((0.9, 3.7, 1.5), (0.45, 0.0, 0.95), 42.0),
        "behind": CameraHint((-2.5, -0.9, 1.75), (0.6, 0.0, 1.0), 45.0),
        "opponent": CameraHint((3.3, 0.9, 1.6), (0.3, 0.0, 1.0), 45.0),
        "above": CameraHint((0.5, 0.1, 4.2), (0.45, 0.0, 0.5), 45.0),
    },
}
