"""Draws the README's film strip: a shove that is recovered from, one that is not, and the way up again.

python scripts/draw_film_strip.py docs/shove.png
"""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from game.commands.casting import Casting
from game.commands.shove import shove_chest
from game.render.camera import Camera
from game.render.capture import read_pixels, save_png
from game.render.gl_window import open_gl
from game.render.renderer import Renderer
from game.scenes.mirror import Mirror
from game.scenes.scene import CameraHint
from game.tunables import Settings

CELL, DRAWN = (210, 230), 2
GAP = 4
ROWS = (
    (80.0, 90.0, (0.0, 0.2, 0.35, 0.55, 0.7, 1.0, 2.6)),
    (180.0, -45.0, (0.1, 0.3, 0.5, 0.65, 0.8, 1.0, 1.4)),
    (180.0, -45.0, (1.9, 2.2, 2.4, 2.6, 2.9, 3.2, 4.2)),
)
"""Impulse (N s), direction (degrees, counterclockwise from ahead) and the moments drawn, seconds after the shove began."""


def row_of(impulse_ns: float, direction_deg: float, moments_s: tuple[float, ...], character: str = "original") -> np.ndarray:
    """(height, width, 3) of one shove, picture beside picture."""
    settings = Settings({"physics.self_collision": True, "intake.mirror": False})
    scene = Casting("performer:standing", character, settings, 0).scene("mirror")
    assert isinstance(scene, Mirror)
    scene.enter()
    size = (CELL[0] * DRAWN, CELL[1] * DRAWN)
    window = open_gl(*size, "film strip", headless=True)
    renderer = Renderer(window.ctx, "medium", settings)
    try:
        simulation = scene.simulation
        world = simulation.world
        while simulation.time_s < 0.5:
            simulation.advance()
        shove_chest(world, math.radians(direction_deg), impulse_ns)
        began_s, cells = simulation.time_s, []
        for moment in moments_s:
            while simulation.time_s - began_s < moment - 1e-9:
                simulation.advance()
            com = world.characters[0].com
            camera = Camera(CameraHint((float(com[0]) + 1.6, float(com[1]) + 2.7, 1.3), (float(com[0]), float(com[1]), 0.82), 47.0))
            renderer.render(scene.drawables(1.0), camera, window.screen, window.framebuffer_size)
            window.screen.use()
            pixels = read_pixels(window.screen, size)
            cells.append(pixels.reshape(CELL[1], DRAWN, CELL[0], DRAWN, 3).mean(axis=(1, 3)))
        return beside(cells)
    finally:
        window.close()
        scene.leave()


def beside(cells: list[np.ndarray]) -> np.ndarray:
    """The pictures with white gaps between them."""
    gap = np.full((cells[0].shape[0], GAP, 3), 255.0)
    out = [cells[0]]
    for cell in cells[1:]:
        out += [gap, cell]
    return np.concatenate(out, axis=1)


if __name__ == "__main__":
    rows = [row_of(*row) for row in ROWS]
    save_png(Path(sys.argv[1]), beside([row.transpose(1, 0, 2) for row in rows]).transpose(1, 0, 2).round().astype(np.uint8))
