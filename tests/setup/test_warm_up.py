"""Compiling is announced once, happens once, and the warm-up leaves nothing to compile for the first play."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LINE = "topple: compiling the loops of control and physics (some seconds, once)\n"
PLAY = ("run_game.py", "--no-draw", "--seconds", "0.5")


def python(cache: Path, *arguments: str) -> str:
    """What a Python process says on stderr that keeps what it compiles in `cache`."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(cache)}
    done = subprocess.run([sys.executable, *arguments], cwd=ROOT, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return done.stderr


def test_compiling_is_announced_once_and_loading_is_not(tmp_path: Path) -> None:
    code = (
        "from game.warm_up import tell_of_compiling; tell_of_compiling(); tell_of_compiling()\n"
        "import numpy as np\nfrom game import rotation_compiled as r\n"
        "r.multiply(np.ones(4), np.ones(4)); r.cross(np.ones(3), np.ones(3))"
    )
    assert python(tmp_path, "-c", code) == LINE
    assert python(tmp_path, "-c", code) == ""


@pytest.mark.slow
def test_after_the_warm_up_no_play_has_anything_left_to_compile(tmp_path: Path) -> None:
    assert python(tmp_path, "-m", "game.warm_up") == LINE
    for options in (
        ["--scene", "duel", "--input", "script"],
        ["--preset", "thesis", "--input", "performer:boxing"],
        ["--ik", "none"],
        ["--input", "performer:stepping", "--seconds", "3"],
    ):
        assert python(tmp_path, *PLAY, *options) == ""
