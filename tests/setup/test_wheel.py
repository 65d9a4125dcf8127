"""The wheel holds everything the game needs: installed, it runs from a foreign folder, without the checkout."""

import json
import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

pytestmark = pytest.mark.slow


def run(*command: str | Path, folder: Path) -> str:
    """What a command prints, run in `folder` with an environment that knows nothing of the checkout."""
    environment = {name: value for name, value in os.environ.items() if name not in {"PYTHONPATH", "VIRTUAL_ENV"}}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the commands of an environment that holds the built wheel.

    The packages it depends on are lent from the environment of the tests; scripts/try_wheel.sh installs them anew.
    """
    folder = tmp_path_factory.mktemp("wheel")
    run(sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", folder, folder=ROOT)
    run(sys.executable, "-m", "venv", folder / "empty", folder=folder)
    commands = folder / "empty" / ("Scripts" if sys.platform == "win32" else "bin")
    (wheel,) = folder.glob("topple-*.whl")
    run(commands / "python", "-m", "pip", "install", "--no-deps", "--no-index", wheel, folder=folder)
    packages = run(commands / "python", "-c", "import sysconfig; print(sysconfig.get_path('purelib'))", folder=folder).strip()
    (Path(packages) / "lent.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    return commands


def test_the_game_comes_from_the_wheel(installed: Path, tmp_path: Path) -> None:
    where = run(
        installed / "python", "-c", "import game, kinect, game.assets as a; print(game.__file__, a.assets_folder())", folder=tmp_path
    )
    assert all(Path(path).is_relative_to(installed.parent) for path in where.split())


def test_the_installed_game_runs_without_graphics(installed: Path, tmp_path: Path) -> None:
    run(installed / "topple", "--no-draw", "--input", "performer:waving", "--seconds", "0.5", "--report", "run.json", folder=tmp_path)
    assert json.loads((tmp_path / "run.json").read_text(encoding="utf-8"))["contact_partners"]


def test_the_installed_game_draws_with_its_own_shaders_and_fonts(installed: Path, tmp_path: Path) -> None:
    size, picture = ("--size", "160x90"), ("--picture", "frame.png")
    options = ("--headless", "--input", "performer:waving", "--seconds", "0.2", "--quality", "low", *size, *picture)
    run(installed / "topple", *options, folder=tmp_path)
    assert (tmp_path / "frame.png").stat().st_size > 1000
