"""What a scene asks the picture to show: plain arrays, no physics and no GL.

World frame (x forward, y left, z up), metres, quaternions (w, x, y, z), colours linear RGBA in 0..1.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

MATERIALS = ("plain", "planks", "wood", "plaster", "fabric", "rug", "painting", "outdoors", "screen")
"""planks to fabric repeat over the surface; rug to screen are pictures, one to each face."""


@dataclass(frozen=True)
class Boxes:
    """N bevelled boxes.

    position (N, 3) m; orientation (N, 4) unit quaternions; half_size (N, 3) m; colour (N, 4);
    bevel_m: radius of the rounded edges; roughness 0 (mirror) .. 1 (chalk); emission: light given off (0 none).
    material: what the surface is made of, one of MATERIALS; inside_out: a room, seen only from within.
    """

    position: Floats
    orientation: Floats
    half_size: Floats
    colour: Floats
    bevel_m: float = 0.012
    roughness: float = 0.6
    emission: float = 0.0
    casts_shadow: bool = True
    material: str = "plain"
    inside_out: bool = False


@dataclass(frozen=True)
class Capsules:
    """N capsules from start (N, 3) to end (N, 3) of radius (N,) m; a sphere has start equal to end. colour (N, 4)."""

    start: Floats
    end: Floats
    radius: Floats
    colour: Floats
    roughness: float = 0.5
    emission: float = 0.0
    casts_shadow: bool = True


@dataclass(frozen=True)
class Lines:
    """N straight segments, points (N, 2, 3) m, colour (N, 4), width in pixels at 720 lines of picture height."""

    points: Floats
    colour: Floats
    width_px: float = 2.0
    on_top: bool = False


@dataclass(frozen=True)
class Points:
    """N round points, position (N, 3) m, colour (N, 4), diameter in pixels at 720 lines of picture height."""

    position: Floats
    colour: Floats
    diameter_px: float = 4.0


@dataclass(frozen=True)
class DepthPoints:
    """A depth picture as points in the room, unpacked where they are drawn.

    codes (H, W) uint16: one a pixel; metres (C,) float32: distance along the camera's axis of each code below C, 0 where nothing was seen.
    focal_px, centre_px (u, v): of the picture. A pixel at distance z lies at camera ((cu - u) z / f, (cv - v) z / f, z), and in the
    world at turn (3, 3) @ camera + shift (3,). colour: linear RGB of what is near the camera. diameter_m of a point; farther than
    reach_m nothing is drawn. A drawable with the same codes array as the last is not sent to the graphics card again.
    """

    codes: NDArray[np.uint16]
    metres: NDArray[np.float32]
    focal_px: float
    centre_px: tuple[float, float]
    turn: Floats
    shift: Floats
    colour: tuple[float, float, float] = (1.0, 0.5, 0.15)
    diameter_m: float = 0.008
    reach_m: float = 10.0


@dataclass(frozen=True)
class Label:
    """A word at a place in the world (3,) m; the overlay writes it."""

    position: Floats
    text: str
    colour: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)


Drawable = Boxes | Capsules | Lines | Points | DepthPoints | Label


@dataclass(frozen=True)
class Layer:
    """A named group of drawables that a player can switch on and off (`layer.NAME` tunables).

    opacity < 1 draws the whole layer translucent, blended over the opaque picture and casting no shadow.
    """

    name: str
    drawables: tuple[Drawable, ...] = field(default_factory=tuple)
    opacity: float = 1.0
