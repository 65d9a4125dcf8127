"""What pyproject.toml and the locks promise: every import is declared, every lock is of the public index, both locks agree."""

import ast
import re
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
DISTRIBUTION = {
    "imgui_bundle": "imgui-bundle",
    "libusb_package": "libusb-package",
    "mujoco": "mujoco-core",
    "PIL": "pillow",
    "tomli_w": "tomli-w",
    "usb": "pyusb",
}


def requirement_name(requirement: str) -> str:
    found = re.match(r"[A-Za-z0-9._-]+", requirement)
    assert found, requirement
    return found.group().lower().replace("_", "-")


def declared() -> set[str]:
    return {requirement_name(line) for line in PROJECT["project"]["dependencies"]}


def needed_by_one_command() -> set[str]:
    return {requirement_name(line) for lines in PROJECT["project"]["optional-dependencies"].values() for line in lines}


def third_party_imports() -> set[str]:
    names: set[str] = set()
    for room in ("game", "kinect"):
        for path in (ROOT / room).rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Import):
                    names |= {alias.name.split(".")[0] for alias in node.names}
                elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                    names.add(node.module.split(".")[0])
    return {name for name in names if name not in sys.stdlib_module_names | {"game", "kinect"}}


def test_everything_that_the_game_imports_is_declared() -> None:
    assert {DISTRIBUTION.get(name, name) for name in third_party_imports()} <= declared() | needed_by_one_command()


def test_whatever_can_change_a_torque_or_a_picture_is_pinned_exactly() -> None:
    exact = {requirement_name(line) for line in PROJECT["project"]["dependencies"] if "==" in line}
    assert exact >= {"glfw", "imgui-bundle", "libusb-package", "moderngl", "mujoco-core", "pyusb"}


def test_nothing_has_neither_a_pin_nor_an_upper_bound() -> None:
    assert [line for line in PROJECT["project"]["dependencies"] if "==" not in line and "<" not in line] == []


def test_the_lock_names_the_public_index_and_nothing_else() -> None:
    lock = tomllib.loads((ROOT / "uv.lock").read_text(encoding="utf-8"))
    sources = {str(source) for package in lock["package"] for source in package["source"].items()}
    assert sources == {"('registry', 'https://pypi.org/simple')", "('editable', '.')"}
    files = [file["url"] for package in lock["package"] for file in (*package.get("wheels", ()), package.get("sdist", {})) if file]
    assert len(files) > 100
    assert {url.split("/packages/")[0] for url in files} == {"https://files.pythonhosted.org"}


@pytest.mark.parametrize("name", ["play", "test"])
def test_the_lock_of_pip_holds_the_versions_of_the_lock_of_uv(name: str) -> None:
    lock = tomllib.loads((ROOT / "uv.lock").read_text(encoding="utf-8"))
    versions = {(package["name"], package.get("version")) for package in lock["package"]}
    lines = (ROOT / "requirements" / f"{name}.txt").read_text(encoding="utf-8").splitlines()
    pinned = {tuple(line.split()[0].split("==")) for line in lines if line[:1].isalnum()}
    assert pinned <= versions
    assert all(line[:1].isalnum() or re.match(r"    --hash=sha256:[0-9a-f]{64}( \\)?$", line) for line in lines)
    assert declared() <= {package for package, _ in pinned}


def test_the_lock_is_for_the_pythons_that_the_project_runs_on() -> None:
    lock = tomllib.loads((ROOT / "uv.lock").read_text(encoding="utf-8"))
    assert PROJECT["project"]["requires-python"] == ">=3.11,<3.14"
    assert set(lock["requires-python"].replace(" ", "").split(",")) == {">=3.11", "<3.14"}
