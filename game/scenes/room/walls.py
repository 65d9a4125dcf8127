"""The shell of the room: floor, walls, skirting, the door, the rug. The character stands on z = 0 at the origin and faces +x."""

from game.scenes.room.carpentry import PAINTED, WOOD, Carpentry, Finish

BACK_X, FRONT_X, SIDE_Y, HEIGHT = -3.3, 3.7, 3.2, 2.7
_MIDDLE_X = (BACK_X + FRONT_X) / 2.0
_DEPTH = FRONT_X - BACK_X
_SHELL = Finish(0.0, 0.9, material="plaster", casts_shadow=False, inside_out=True)
_WALLPAPER = Finish(0.0, 0.9, material="plaster", casts_shadow=False)
_PLANKS = Finish(0.0, 0.42, material="planks", casts_shadow=False)
_RUG = Finish(0.0, 0.97, material="rug", casts_shadow=False)
_SKIRTING = Finish(0.006, 0.45, casts_shadow=False)


def furnish(room: Carpentry) -> None:
    """Shell last things first: what is hidden behind furniture is drawn after it."""
    _door(room)
    for x, side in ((BACK_X, 1.0), (FRONT_X, -1.0)):
        room.box((x + side * 0.016, 0.0, 0.055), (0.02, 2 * SIDE_Y, 0.11), "#efe6d6", _SKIRTING)
    for y, side in ((-SIDE_Y, 1.0), (SIDE_Y, -1.0)):
        room.box((_MIDDLE_X, y + side * 0.01, 0.055), (_DEPTH, 0.02, 0.11), "#efe6d6", _SKIRTING)
    room.box((BACK_X + 0.012, 0.0, 0.98), (0.022, 2 * SIDE_Y, 0.035), "#c9a877", _SKIRTING)
    room.box((0.0, 0.0, 0.0005), (3.1, 2.7, 0.003), "#dcd2c6", _RUG)
    room.box((BACK_X + 0.003, 0.0, HEIGHT / 2), (0.006, 2 * SIDE_Y, HEIGHT), "#4d7571", _WALLPAPER)
    room.box((_MIDDLE_X, 0.0, -0.05), (_DEPTH, 2 * SIDE_Y, 0.1), "#f2dcc4", _PLANKS)
    room.box((_MIDDLE_X, 0.0, HEIGHT / 2 - 0.06), (_DEPTH, 2 * SIDE_Y, HEIGHT + 0.12), "#ead9bd", _SHELL)


def _door(room: Carpentry) -> None:
    y = -SIDE_Y + 0.02
    room.box((1.0, y, 1.03), (0.86, 0.05, 2.06), "#b98a5a", WOOD)
    for x in (0.54, 1.46):
        room.box((x, y, 1.05), (0.08, 0.07, 2.12), "#efe6d6", PAINTED)
    room.box((1.0, y, 2.12), (1.0, 0.07, 0.08), "#efe6d6", PAINTED)
    for z in (0.6, 1.5):
        room.box((1.0, y + 0.028, z), (0.58, 0.012, 0.66), "#a87a4c", WOOD)
    room.rod((0.68, y + 0.07, 1.02), (0.78, y + 0.07, 1.02), 0.012, "#c9b37a", 0.25)
