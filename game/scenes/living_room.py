"""The living room every scene plays in: static furniture as drawables, and where to look at it from.

The character stands at the origin and faces +x, towards the television with the Kinect. Three metres by three in the middle are free.
"""

from collections.abc import Mapping
from functools import cache

from game.drawables import Layer
from game.scenes.room import daylight, greenery, seating, shelves, television, walls
from game.scenes.room.carpentry import Carpentry, Finish, yaw
from game.scenes.scene import CameraHint


@cache
def living_room() -> tuple[Layer, ...]:
    """The same layers at every call, so that the picture can keep them."""
    room = Carpentry()
    seating.sofa(room)
    seating.coffee_table(room)
    daylight.floor_lamp(room)
    greenery.big_plant(room, -2.72, -2.05)
    greenery.grass_plant(room, 2.75, 2.35)
    shelves.bookcase(room)
    television.television(room)
    _left_about(room)
    shelves.wall_pictures(room)
    shelves.side_wall(room)
    daylight.window(room)
    daylight.string_lights(room)
    television.front_wall(room)
    walls.furnish(room)
    return (Layer("room", room.drawables()),)


def _left_about(room: Carpentry) -> None:
    """What nobody tidied away."""
    room.rod((-2.0, 2.2, 0.12), (-2.0, 2.2, 0.12), 0.12, "#c8653a", 0.8)
    for i, colour in enumerate(("#3c6f7d", "#e4d3b4")):
        room.box((-1.75 + 0.03 * i, 1.55 + 0.16 * i, 0.035), (0.26, 0.10, 0.07), colour, Finish(0.03, 0.95), yaw(20.0 - 14.0 * i))
    for i, colour in enumerate(("#8c3b2c", "#d9a23a", "#24424a")):
        room.box((2.45, -1.35 + 0.02 * i, 0.012 + 0.02 * i), (0.19, 0.13, 0.018), colour, Finish(0.003, 0.4), yaw(15.0 * i))
    room.box((-2.95, 2.9 - 5.85, 0.26), (0.42, 0.36, 0.5), "#c9a877", Finish(0.06, 1.0, material="fabric"))


def room_cameras() -> Mapping[str, CameraHint]:
    """Places to look from. The first is beside the television: you see your character's face, as in a mirror."""
    return {
        "mirror": CameraHint((3.15, 0.55, 1.62), (-0.25, -0.06, 0.93), 40.0),
        "behind": CameraHint((-2.75, 0.95, 1.75), (0.9, 0.0, 0.92), 40.0),
        "ringside": CameraHint((1.55, 2.75, 1.45), (0.25, 0.0, 0.92), 40.0),
        "above": CameraHint((2.2, 1.3, 3.3), (0.2, 0.0, 0.65), 40.0),
    }
