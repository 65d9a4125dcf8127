"""Who may import whom, and how big and how named a module may be: the house rules of CONTRIBUTING.md, read from the code itself."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MODULES = sorted(path.relative_to(ROOT) for room in ("game", "kinect") for path in (ROOT / room).rglob("*.py"))
EVERY_FILE = [*MODULES, *sorted(path.relative_to(ROOT) for room in ("tests", "scripts") for path in (ROOT / room).rglob("*.py"))]

PICTURE = ("moderngl", "glfw", "imgui_bundle", "game.render", "game.overlay")
# room: what nothing in it may import
FORBIDDEN = {
    "kinect": ("game",),
    "game/inputs": ("mujoco", "moderngl", "imgui_bundle", "game.render", "game.overlay"),  # glfw knows keys and gamepads
    "game/intake": ("mujoco", *PICTURE),
    "game/target": ("mujoco", "game.physics", "game.scenes", "game.inputs", *PICTURE),
    "game/control": ("mujoco", "game.scenes", "game.inputs", *PICTURE),
    "game/physics": ("game.scenes", "game.inputs", *PICTURE),
    "game/scenes": PICTURE,
    "game/render": ("mujoco", "imgui_bundle", "game.physics", "game.control", "game.target", "game.inputs", "game.overlay"),
    "game/overlay": ("mujoco", "game.physics", "game.control", "game.target"),
}
LONGEST_MODULE = 300
LONGEST_FUNCTION = 80
NAMES_THAT_SAY_NOTHING = {"util", "utils", "manager", "managers", "helper", "helpers", "common", "misc"}


def parse(path: Path) -> ast.Module:
    return ast.parse((ROOT / path).read_text(encoding="utf-8"), filename=str(path))


def imported_names(tree: ast.Module, path: Path) -> set[str]:
    """Every dotted name that a module imports, also inside functions; relative imports made absolute.

    Imports that only the type checker sees (`if TYPE_CHECKING:`) are left out: they bind nothing at run time.
    """
    for node in ast.walk(tree):
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            node.body = []
    names: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            package = path.parent.parts[: len(path.parent.parts) - node.level + 1] if node.level else ()
            base = ".".join((*package, *((node.module,) if node.module else ())))
            names |= {base} | {f"{base}.{alias.name}" for alias in node.names}
    return names


def forbidden_imports(names: set[str], forbidden: tuple[str, ...]) -> list[str]:
    return sorted(name for name in names if any(name == f or name.startswith(f + ".") for f in forbidden))


@pytest.mark.parametrize("room", FORBIDDEN)
def test_a_room_imports_nothing_that_is_not_its_business(room: str) -> None:
    inside = [path for path in MODULES if path.is_relative_to(room)]
    assert inside, f"there is no module in {room}/"
    wrong = {str(path): found for path in inside if (found := forbidden_imports(imported_names(parse(path), path), FORBIDDEN[room]))}
    assert not wrong


def test_every_module_is_short_enough_to_read_in_one_go() -> None:
    lengths = {str(path): len((ROOT / path).read_text(encoding="utf-8").splitlines()) for path in EVERY_FILE}
    assert {path: lines for path, lines in lengths.items() if lines > LONGEST_MODULE} == {}


def test_every_function_fits_on_a_screen() -> None:
    lengths: dict[str, int] = {}
    for path in EVERY_FILE:
        for node in ast.walk(parse(path)):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                lengths[f"{path}:{node.name}"] = (node.end_lineno or node.lineno) - node.lineno + 1
    assert {function: lines for function, lines in lengths.items() if lines > LONGEST_FUNCTION} == {}


def test_every_module_is_named_for_what_it_does() -> None:
    words = {str(path): {word for part in path.with_suffix("").parts for word in part.lower().split("_")} for path in EVERY_FILE}
    assert {path: found for path, named in words.items() if (found := named & NAMES_THAT_SAY_NOTHING)} == {}


def test_a_forbidden_import_is_found_wherever_it_hides() -> None:
    code = "def f():\n    from ..render import boxes\nimport moderngl.context\nif TYPE_CHECKING:\n    import glfw\n"
    names = imported_names(ast.parse(code), Path("game/target/mapping.py"))
    assert forbidden_imports(names, PICTURE) == ["game.render", "game.render.boxes", "moderngl.context"]
