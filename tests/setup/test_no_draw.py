"""`--no-draw` runs where neither OpenGL nor X11 is installed: nothing of the picture is loaded."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def test_a_run_without_a_picture_never_loads_the_libraries_of_the_picture(tmp_path: Path) -> None:
    options = ["--no-draw", "--input", "performer:waving", "--seconds", "0.1", "--report", str(tmp_path / "run.json")]
    libraries = {"moderngl", "imgui_bundle", "glfw"}
    code = f"import sys; from game.commands import main; main({options}); print(sorted({libraries} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == "[]"
    assert (tmp_path / "run.json").is_file()
