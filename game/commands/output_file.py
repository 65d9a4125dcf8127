"""Files a run shall write: checked before it begins, so that nobody waits for what cannot be kept."""

import json
import math
from pathlib import Path

from game.commands import BadInput


def check_output_file(option: str, path: Path, suffixes: tuple[str, ...] = ()) -> None:
    """Raises BadInput where `path`, given as `option`, has none of the suffixes or cannot be written; makes its folder."""
    if path.is_dir():
        raise BadInput(f"{option}: {path} is a folder; give a file name.")
    if suffixes and path.suffix.lower() not in suffixes:
        raise BadInput(f"{option}: {path} must end in {' or '.join(suffixes)}.")
    existed = path.exists()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("ab"):
            pass
        if not existed:
            path.unlink()
    except OSError as fault:
        raise BadInput(f"{option}: {path} cannot be written ({fault.strerror or fault}); give a file in a writable folder.") from fault


def write_report(path: Path, report: dict[str, object]) -> None:
    """The report as JSON; a number that is none (NaN, infinite) becomes null. Raises BadInput where the file cannot be written."""
    try:
        path.write_text(json.dumps(finite(report), indent=1, allow_nan=False) + "\n", encoding="utf-8")
    except OSError as fault:
        raise BadInput(f"--report: {path} cannot be written ({fault.strerror or fault}); give a file in a writable folder.") from fault


def finite(value: object) -> object:
    """The same with None for every number that JSON has no word for."""
    if isinstance(value, dict):
        return {key: finite(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
