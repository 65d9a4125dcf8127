"""Which of glfw, imgui_bundle and mujoco comes first does not matter: one GLFW, and a picture without a display."""

import os
import subprocess
import sys
from itertools import permutations
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LIBRARIES = ("glfw", "imgui_bundle", "mujoco")

DRAW = """
from game.render.gl_window import open_gl
window = open_gl(64, 48, "test", headless=True)
window.screen.clear(1.0, 0.5, 0.0)
print(window.kind, list(window.screen.read(components=3)[:3]))
"""
# Every shared library of the process, from the dynamic linker: two GLFWs would be two names.
GLFWS = """
import ctypes
class Entry(ctypes.Structure):
    _fields_ = [("address", ctypes.c_void_p), ("name", ctypes.c_char_p)]
names = set()
visit = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(Entry), ctypes.c_size_t, ctypes.c_void_p)(
    lambda entry, size, data: names.add(entry.contents.name) or 0
)
ctypes.CDLL(None).dl_iterate_phdr(visit, None)
print(len({name for name in names if name and b"libglfw" in name}))
"""


def python(code: str) -> list[str]:
    """The lines that Python code prints in a process of its own, started in the checkout."""
    environment = {name: value for name, value in os.environ.items() if name not in {"PYGLFW_LIBRARY", "MUJOCO_GL", "TOPPLE_GL"}}
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


@pytest.mark.skipif(sys.platform != "linux", reason="the picture without a display is Linux's")
@pytest.mark.parametrize("order", list(permutations(LIBRARIES)), ids=" ".join)
def test_any_order_of_imports_gives_one_glfw_and_a_picture(order: tuple[str, ...]) -> None:
    imports = "\n".join(f"import {library}" for library in ("game", *order))
    assert python(imports + DRAW + GLFWS) == ["egl [255, 128, 0]", "1"]


def test_the_package_alone_imports_none_of_them() -> None:
    assert python(f"import sys, game, kinect; print([name for name in {LIBRARIES} if name in sys.modules])") == ["[]"]


def test_a_run_without_a_picture_never_loads_the_libraries_of_the_picture(tmp_path: Path) -> None:
    options = ["--no-draw", "--input", "performer:waving", "--seconds", "0.1", "--report", str(tmp_path / "run.json")]
    libraries = {"moderngl", "imgui_bundle", "glfw"}
    code = f"import sys; from game.commands import main; main({options}); print(sorted({libraries} & set(sys.modules)))"
    assert python(code)[-1] == "[]"
    assert (tmp_path / "run.json").is_file()
