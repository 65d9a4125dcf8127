"""The pictures as they were when somebody last looked at them.

Only on Mesa's software renderer: graphics cards round differently. Its own versions do too, by a step here and a pixel of an edge there;
so a picture may differ by 1.5 of 255 on average and by more than 24 in one pixel of a hundred. A wrong shadow, a lost lamp or a
missing cushion goes far beyond that. To accept new pictures after looking:
TOPPLE_ACCEPT_GOLDEN=1 pytest tests/render/test_golden.py
"""

import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from game.drawables import Layer
from game.render.camera import Camera
from game.render.capture import read_pixels, save_png
from game.scenes.living_room import living_room, room_cameras
from tests.render.biped import dressed_biped, plain_biped

GOLDEN = Path(__file__).resolve().parents[1] / "golden"
_GHOST = Layer("ghost", plain_biped((0.35, 0.75, 1.0, 1.0), at=(0.3, 0.5)).drawables, opacity=0.35)

CASES = {
    "mirror_low_640x360": ("low", (640, 360), "mirror", ("player",)),
    "mirror_high_320x180": ("high", (320, 180), "mirror", ("player",)),
    "duel_medium_320x180": ("medium", (320, 180), "ringside", ("player", "opponent")),
}


@pytest.mark.golden
@pytest.mark.parametrize("name", list(CASES))
def test_the_picture_is_the_one_that_was_approved(window, renderers, name: str) -> None:
    if "llvmpipe" not in window.ctx.info["GL_RENDERER"]:
        pytest.skip(f"golden pictures hold for llvmpipe, this is {window.ctx.info['GL_RENDERER']}")
    quality, size, view, people = CASES[name]
    fighters = [dressed_biped(who, at=(0.85 * i, 0.0), facing_deg=180.0 * i) for i, who in enumerate(people)]
    canvas = window.ctx.simple_framebuffer(size, components=4)
    renderers(quality).render((*living_room(), *fighters, _GHOST), Camera(room_cameras()[view]), canvas, size)
    assert window.ctx.error == "GL_NO_ERROR"
    picture = read_pixels(canvas, size)
    window.screen.use()  # moderngl must not be left with a released framebuffer
    canvas.release()
    path = GOLDEN / f"{name}.png"
    if os.environ.get("TOPPLE_ACCEPT_GOLDEN"):
        save_png(path, picture)
    approved = np.asarray(Image.open(path).convert("RGB"), dtype=float)
    difference = np.abs(approved - picture)
    assert difference.mean() < 1.5
    assert (difference.max(axis=2) > 24).mean() < 0.01
