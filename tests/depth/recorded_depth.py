"""Where the real depth recordings lie, beside the project."""

from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parents[2] / ".." / "shared" / "data" / "depth"
PERSON_RAW = FOLDER / "openiss_person_raw11.npz"
PERSON_MM = FOLDER / "squat.npz"


def recorded(path: Path) -> Path:
    """The path, or a skipped test where there is no such recording."""
    if not path.is_file():
        pytest.skip(f"the recording {path.name} is not beside the project, in ../shared/data/depth")
    return path
