"""Where the camera may stand, scene by scene; the first of each is where a newcomer starts."""

from collections.abc import Mapping

from game.scenes.living_room import room_cameras
from game.scenes.scene import CameraHint

_ROOM = room_cameras()

CAMERAS: Mapping[str, Mapping[str, CameraHint]] = {
    "mirror": {
        "front": _ROOM["mirror"],
        "side": _ROOM["ringside"],
        "behind": _ROOM["behind"],
        "above": _ROOM["above"],
        "feet": CameraHint((1.7, 0.8, 0.5), (0.0, 0.0, 0.35), 40.0),
    },
    "duel": {
        "ringside": CameraHint((0.75, 2.95, 1.42), (0.0, 0.0, 0.92), 40.0),
        "behind": CameraHint((-2.75, 0.95, 1.75), (0.5, 0.0, 0.92), 40.0),
        "opponent": CameraHint((2.75, -0.95, 1.75), (-0.5, 0.0, 0.92), 40.0),
        "above": CameraHint((1.6, 1.6, 3.2), (0.0, 0.0, 0.65), 40.0),
    },
}
