"""The set-up scripts are plain sh, start fast a second time, and say in one sentence what they lack."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = sorted((ROOT / "scripts").glob("*.sh"))

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="sh scripts; Windows uses uv")


def sh(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run code after sourcing setup.sh, in an environment of PATH and the given variables."""
    return subprocess.run(
        ["sh", "-eu", "-c", f"root={ROOT}; . {ROOT}/scripts/setup.sh; {code}"],
        env={"PATH": os.environ["PATH"], **environment},
        capture_output=True,
        text=True,
        timeout=60,
        stdin=subprocess.DEVNULL,
        check=False,
    )


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.name)
def test_a_script_is_plain_sh(script: Path) -> None:
    assert subprocess.run([shutil.which("dash") or "sh", "-n", script], check=False).returncode == 0
    code = re.sub(r"#.*", "", script.read_text(encoding="utf-8"))
    bashisms = re.findall(r"\[\[|\bfunction \w|\blocal \b|\bsource \b|<<<|\bpipefail\b|\$\{\w+\^", code)
    assert bashisms == []


def test_a_python_of_the_wrong_version_is_one_sentence(tmp_path: Path) -> None:
    old = tmp_path / "python2"
    old.write_text("#!/bin/sh\nexit 1\n")
    old.chmod(0o755)
    done = sh("set_up play", TOPPLE_PYTHON=str(old), TOPPLE_VENV=str(tmp_path / "venv"))
    assert done.returncode == 1
    assert done.stderr == f"topple: TOPPLE_PYTHON={old} is no Python 3.11, 3.12 or 3.13 with the venv module; name one, or unset it.\n"


def test_no_python_at_all_is_one_sentence(tmp_path: Path) -> None:
    done = sh("PATH=/nowhere; set_up play", TOPPLE_VENV=str(tmp_path / "venv"))
    assert done.returncode == 1
    assert done.stderr.strip().splitlines()[-1].startswith("topple: no Python 3.11, 3.12 or 3.13 with the venv module found")


def test_without_rights_the_missing_libraries_are_named_and_the_set_up_goes_on() -> None:
    done = sh("has_gl() { false; }; can_be_root() { false; }; uname() { echo Linux; }; command() { true; }; set_up_gl; echo went on")
    assert (done.returncode, done.stdout) == (0, "went on\n")
    assert done.stderr.count("\n") == 1
    assert "apt-get install --no-install-recommends libegl1 libgl1" in done.stderr
    assert "--no-draw" in done.stderr


def test_a_run_without_a_picture_asks_for_no_libraries(tmp_path: Path) -> None:
    (tmp_path / "scripts").mkdir()
    shutil.copy(ROOT / "scripts" / "play.sh", tmp_path / "scripts")
    (tmp_path / "scripts" / "setup.sh").write_text('python=true; set_up_gl() { echo graphics; }; set_up() { echo "set up $1"; }\n')
    play = ["sh", str(tmp_path / "scripts" / "play.sh")]
    assert subprocess.run([*play, "--no-draw"], capture_output=True, text=True, check=True).stdout == "set up play\n"
    assert subprocess.run(play, capture_output=True, text=True, check=True).stdout == "graphics\nset up play\n"


def test_what_is_installed_is_not_installed_again(tmp_path: Path) -> None:
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python").symlink_to(sys.executable)
    (tmp_path / "made-with").write_text(f"python3\n{Path(sys.executable).resolve()}\n")
    shutil.copy(ROOT / "requirements" / "test.txt", tmp_path / "installed-test.txt")
    done = sh("set_up test; set_up play; echo ready", TOPPLE_VENV=str(tmp_path))
    assert (done.returncode, done.stdout, done.stderr) == (0, "ready\n", "")


def test_an_environment_of_a_python_that_is_no_more_is_made_anew(tmp_path: Path) -> None:
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python").symlink_to(sys.executable)
    (tmp_path / "made-with").write_text("python3\n/usr/bin/python3.10\n")
    assert sh("is_made", TOPPLE_VENV=str(tmp_path)).returncode != 0


def test_a_changed_lock_is_installed_anew(tmp_path: Path) -> None:
    (tmp_path / "installed-play.txt").write_text("an older lock\n")
    done = sh("is_installed play", TOPPLE_VENV=str(tmp_path))
    assert done.returncode != 0
