"""Who imports what first does not matter once `game` is imported; before it, the player gets one clear sentence."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
_OPEN = "from game.render.gl_window import open_gl; w = open_gl(64, 36, 't', headless=True); w.close(); print('opened')"


def python(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    import os

    kept = {name: value for name, value in os.environ.items() if name not in ("PYGLFW_LIBRARY", "MUJOCO_GL", "TOPPLE_GL")}
    return subprocess.run([sys.executable, "-c", code], cwd=ROOT, env=kept | environment, capture_output=True, text=True, timeout=120)


@pytest.mark.parametrize(
    "order",
    ["import glfw, mujoco; from imgui_bundle import imgui", "from imgui_bundle import imgui; import mujoco, glfw", "import mujoco, glfw"],
)
def test_after_game_any_order_opens_a_picture(window, order: str) -> None:
    done = python(f"import game; {order}; {_OPEN}", TOPPLE_GL="egl" if window.kind == "egl" else "")
    assert done.stdout.strip() == "opened", done.stderr


def test_glfw_and_imgui_share_one_library() -> None:
    done = python("import game; import glfw; from imgui_bundle import imgui; import os; print(os.path.realpath(glfw._glfw._name))")
    assert "imgui_bundle" in done.stdout


def test_glfw_before_game_is_told_in_one_sentence() -> None:
    done = python(
        "import glfw, game\nfrom game.render.gl_window import open_gl, NoPicture\n"
        "try: open_gl(64, 36, 't', headless=True)\nexcept NoPicture as e: print(e)",
        TOPPLE_GL="egl",
    )
    assert done.stdout.count("\n") == 1
    assert "import game first" in done.stdout


def test_importing_game_loads_no_graphics() -> None:
    done = python("import sys, game; print([n for n in ('glfw', 'imgui_bundle', 'moderngl', 'mujoco') if n in sys.modules])")
    assert done.stdout.strip() == "[]"


def test_the_room_loads_no_graphics() -> None:
    code = "import sys, game.scenes.living_room, game.render.camera; print([n for n in ('glfw', 'moderngl', 'mujoco') if n in sys.modules])"
    done = python(code)
    assert done.stdout.strip() == "[]"
