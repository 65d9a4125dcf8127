"""The door as a player finds it: `run_game.py` in a process of its own, from a folder that is not the project's."""

import json
import math
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
RUN_GAME = ROOT / "run_game.py"


@dataclass(frozen=True)
class Visit:
    """What a run of the door left: its exit status and its words."""

    status: int
    out: str
    err: str


def knock(folder: Path, *words: str, python: tuple[str, ...] = (), **environment: str) -> Visit:
    """Run the door in `folder` with these words; no display unless the environment given names one; one BLAS thread."""
    inherited = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "TOPPLE_GL", "PYTHONPATH")}
    env = {**inherited, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "XDG_CONFIG_HOME": str(folder / "config"), **environment}
    command = [sys.executable, *python, str(RUN_GAME), *words]
    ended = subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True, timeout=120, check=False)
    return Visit(ended.returncode, ended.stdout, without_compiling(ended.stderr))


def without_compiling(said: str) -> str:
    """What was said on stderr without the announcement of a first start, which may come or not."""
    return "".join(line for line in said.splitlines(keepends=True) if not line.startswith("topple: compiling "))


def read_report(path: Path) -> dict[str, Any]:
    """The report, read by a JSON reader that accepts neither NaN nor Infinity."""

    def refuse(word: str) -> float:
        raise ValueError(f"{word} is no JSON")

    report = json.loads(path.read_text(encoding="utf-8"), parse_constant=refuse)
    assert all(math.isfinite(n) for n in numbers_in(report))
    return report


def numbers_in(value: object) -> list[float]:
    """Every number anywhere in a JSON value."""
    if isinstance(value, dict):
        return [n for entry in value.values() for n in numbers_in(entry)]
    if isinstance(value, list):
        return [n for entry in value for n in numbers_in(entry)]
    return [float(value)] if isinstance(value, (int, float)) else []
