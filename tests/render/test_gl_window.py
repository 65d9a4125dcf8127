"""Something to draw into can be had without a display; where it cannot, one sentence says why and what to do."""

import ctypes.util

import pytest

from game.render.gl_window import GLWindow, NoPicture, open_gl
from tests.render.test_import_order import python


def test_window_without_a_display_has_the_size_asked_for(window: GLWindow) -> None:
    assert window.framebuffer_size == (320, 180)
    assert window.screen.viewport == (0, 0, 320, 180)
    assert window.ctx.version_code >= 330
    assert not window.should_close


def test_what_is_cleared_is_read_back(window: GLWindow) -> None:
    from game.render.capture import read_pixels

    window.screen.clear(1.0, 0.5, 0.0)
    assert read_pixels(window.ctx.screen, (320, 180))[0, 0].tolist() == pytest.approx([255, 128, 0], abs=1)


def test_a_second_window_is_of_the_first_ones_kind_beside_it_and_after_it(window: GLWindow) -> None:
    opened = "print(open_gl(64, 36, 't', headless=True).kind)\n"
    code = "import game\nfrom game.render.gl_window import open_gl\nfirst = open_gl(64, 36, 't', headless=True)\n" + opened
    code += "first.close()\n" + opened
    assert python(code).stdout.split() == [window.kind, window.kind]


def test_an_unknown_way_to_draw_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TOPPLE_GL", "vulkan")
    with pytest.raises(NoPicture, match="valid: egl, osmesa"):
        open_gl(64, 36, "t", headless=True)


def test_no_display_names_the_way_out() -> None:
    code = (
        "import game\nfrom game.render.gl_window import open_gl, NoPicture\n"
        "try: open_gl(64, 36, 't', headless=False)\nexcept NoPicture as e: print(e)"
    )
    done = python(code, DISPLAY="", WAYLAND_DISPLAY="")
    assert "--headless" in done.stdout


def test_without_opengl_the_remedy_is_named() -> None:
    code = (
        "import game\nfrom game.render import gl_window, osmesa\nfrom game.render.gl_window import open_gl, NoPicture\n"
        "def gone(): raise osmesa.OSMesaMissing('libOSMesa is not installed.')\nosmesa._load_library = gone\n"
        "import glfw\nglfw.create_window = lambda *a: None\n"
        "try: open_gl(64, 36, 't', headless=True)\nexcept NoPicture as e: print(e)"
    )
    assert "apt install libegl1 libgl1" in python(code).stdout


_PICTURE = """
import sys, game, hashlib
from game.render.gl_window import open_gl
from game.render.renderer import Renderer
from game.render.camera import Camera
from game.render.capture import read_pixels
from game.scenes.living_room import living_room, room_cameras
from game.tunables import Settings
from tests.render.biped import dressed_biped
w = open_gl(160, 90, "t", headless=True)
r = Renderer(w.ctx, "low", Settings())
r.render((*living_room(), dressed_biped()), Camera(room_cameras()["mirror"]), w.screen, (160, 90))
print(w.kind, hashlib.sha256(read_pixels(w.screen, (160, 90)).tobytes()).hexdigest())
w.close()
"""


@pytest.mark.skipif(ctypes.util.find_library("OSMesa") is None, reason="libosmesa6 is not installed")
def test_egl_and_osmesa_draw_the_same_picture(window: GLWindow) -> None:
    if window.kind != "egl" or "llvmpipe" not in window.ctx.info["GL_RENDERER"]:
        pytest.skip("EGL does not draw in software here")
    pictures = [python(_PICTURE, TOPPLE_GL=kind) for kind in ("egl", "osmesa")]
    (egl, egl_hash), (memory, memory_hash) = (picture.stdout.split() for picture in pictures)
    assert (egl, memory) == ("egl", "osmesa")
    assert egl_hash == memory_hash
