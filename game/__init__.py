"""Topple: a game played with the whole body.

Importing this package settles, before anything else is imported, which GLFW the process will use: the one inside imgui-bundle
(it alone can open a window on no display at all, and two GLFWs in one process do not know each other's windows), and that mujoco
loads none. Neither glfw, imgui_bundle nor mujoco is imported here, so what never draws needs none of their system libraries.
"""

import os
import sys
from importlib.util import find_spec
from pathlib import Path

_GLFW_FILES = {"darwin": ("libglfw.3.dylib",), "win32": ("glfw3.dll",)}


def _bundled_glfw() -> str | None:
    """Path of the GLFW library inside imgui-bundle, or None where that is not installed."""
    spec = find_spec("imgui_bundle")
    for folder in (spec.submodule_search_locations or ()) if spec else ():
        for name in _GLFW_FILES.get(sys.platform, ("libglfw.so.3", "libglfw.so")):
            if (Path(folder) / name).is_file():
                return str(Path(folder) / name)
    return None


def _settle_libraries() -> None:
    os.environ.setdefault("MUJOCO_GL", "disable")
    if not os.environ.get("PYGLFW_LIBRARY"):
        path = _bundled_glfw()
        if path is not None:
            os.environ["PYGLFW_LIBRARY"] = path


_settle_libraries()
