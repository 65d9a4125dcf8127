"""A box biped in its idle pose: the sizes and places of the fifteen boxes of the original character."""

import numpy as np

from game import rotation
from game.characters.body_plan import load_body_plan
from game.characters.skeleton import PARTS
from game.drawables import Boxes, Layer
from game.scenes.costume import dressed

# half sizes follow from (x, y, z) edge lengths in metres; centres stand in the idle pose, left side
_CENTRAL = {
    "pelvis": ((0.200, 0.320, 0.160), (0.0, 0.0, 1.005)),
    "trunk": ((0.173, 0.320, 0.430), (0.0, 0.0, 1.310)),
    "head": ((0.164, 0.150, 0.240), (0.01, 0.0, 1.680)),
}
_PAIRED = {
    "upper_arm": ((0.120, 0.120, 0.2915), (0.0, 0.222, 1.350)),
    "lower_arm": ((0.105, 0.105, 0.2537), (0.0, 0.222, 1.050)),
    "hand": ((0.100, 0.063, 0.1905), (0.0, 0.222, 0.825)),
    "upper_leg": ((0.155, 0.145, 0.436), (0.0, 0.095, 0.715)),
    "lower_leg": ((0.114, 0.105, 0.401), (0.0, 0.095, 0.296)),
    "foot": ((0.300, 0.150, 0.100), (0.055, 0.095, 0.050)),
}


def parts() -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Name of each part -> (half size (3,), centre (3,)) in metres."""
    table = {name: (np.array(size) / 2.0, np.array(centre)) for name, (size, centre) in _CENTRAL.items()}
    for name, (size, centre) in _PAIRED.items():
        for side, sign in (("left", 1.0), ("right", -1.0)):
            table[f"{name}_{side}"] = (np.array(size) / 2.0, np.array(centre) * (1.0, sign, 1.0))
    return table


def plain_biped(colour: tuple[float, float, float, float] = (0.8, 0.3, 0.1, 1.0), at: tuple[float, float] = (0.0, 0.0)) -> Layer:
    """The undressed biped standing at (x, y)."""
    table = list(parts().values())
    count = len(table)
    position = np.array([centre for _, centre in table]) + (*at, 0.0)
    half_size = np.array([half for half, _ in table])
    return Layer("biped", (Boxes(position, np.tile((1.0, 0, 0, 0), (count, 1)), half_size, np.tile(colour, (count, 1)), bevel_m=0.02),))


def dressed_biped(who: str = "player", at: tuple[float, float] = (0.0, 0.0), facing_deg: float = 0.0) -> Layer:
    """The original character in a costume, standing at (x, y) and facing a compass direction (0 is +x)."""
    plan = load_body_plan("original")
    orientation = np.tile(rotation.about_z(np.radians(facing_deg)), (len(PARTS), 1))
    position = rotation.rotate(orientation, plan.centre) + (*at, 0.0)
    return Layer(who, dressed(plan, position, orientation, ("player", "opponent").index(who)))
