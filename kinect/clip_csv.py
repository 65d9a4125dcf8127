"""Recordings as text: one row a frame, 20 x (x, y, z, state), with or without a leading time in seconds.

State is a confidence (0 lost, 0.5 inferred, 1 tracked), or, where a file holds any 2, the SDK's own code (0, 1, 2).
Lines that start with # are remarks; `# floor: A B C D`, `# floor_est: ...` and `# motion: words` are understood.
One heading line without a single number in it is passed over.
"""

import math
from pathlib import Path
from typing import Final

import numpy as np

from kinect.body import JOINT_COUNT, Floats, Floor
from kinect.clip_format import Clip, ClipError, checked_clip
from kinect.clip_npz import JOINT_NAMES, WORDS

DEFAULT_FPS: Final = 30.0
COLUMNS: Final = 4 * JOINT_COUNT


def read_csv(path: Path) -> Clip:
    """The clip in a text file of 80 or 81 columns; raises ClipError with the line at fault."""
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except UnicodeDecodeError as fault:
        raise ClipError(f"{path.name}: byte {fault.start} is not text; valid: rows of {COLUMNS} or {COLUMNS + 1} numbers.") from fault
    remarks: dict[str, str] = {}
    rows: list[list[float]] = []
    heading_seen = False
    for number, line in enumerate(lines, start=1):
        if line.lstrip().startswith("#"):
            name, _, value = line.lstrip(" \t#").partition(":")
            remarks[name.strip()] = value.strip()
        elif line.strip():
            cells = _cells(line)
            if not rows and not heading_seen and not any(_is_number(cell) for cell in cells):
                heading_seen = True
                continue
            rows.append(_row(path.name, number, cells, len(rows[0]) if rows else None))
    if not rows:
        raise ClipError(f"{path.name}: the file holds no rows; valid: rows of {COLUMNS} or {COLUMNS + 1} numbers.")
    table = np.array(rows)
    times = table[:, 0] if table.shape[1] == COLUMNS + 1 else np.arange(len(table)) / DEFAULT_FPS
    joints = table[:, -COLUMNS:].reshape(-1, JOINT_COUNT, 4)
    meta: dict[str, str | float] = {word: remarks[word] for word in WORDS if word in remarks}
    floor, floor_est = (_plane(path.name, name, remarks.get(name)) for name in ("floor", "floor_est"))
    return checked_clip(path.name, joints[:, :, :3], _states(path.name, joints[:, :, 3]), times, floor, floor_est, meta)


def write_csv(path: Path, clip: Clip) -> None:
    """Write the clip with its time column, a remark a fact and a heading; positions to a hundredth of a millimetre."""
    heading = ["time_s", *(f"{name}_{axis}" for name in JOINT_NAMES for axis in ("x", "y", "z", "state"))]
    lines = [f"# {name}: {' '.join(str(clip.meta[name]).split())}" for name in WORDS if name in clip.meta]
    for name, plane in (("floor", clip.floor), ("floor_est", clip.floor_est)):
        if plane is not None:
            lines.append(f"# {name}: {' '.join(repr(float(v)) for v in plane)}")
    lines.append(",".join(heading))
    table = np.concatenate([clip.positions, clip.confidence[:, :, None]], axis=2).reshape(len(clip.t), COLUMNS)
    for time, row in zip(clip.t, table, strict=True):
        lines.append(",".join([f"{time:.6f}", *(f"{value:.5f}" for value in row)]))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _cells(line: str) -> list[str]:
    for separator in (",", ";"):
        if separator in line:
            cells = [cell.strip() for cell in line.split(separator)]
            return cells[:-1] if not cells[-1] else cells
    return line.split()


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def _row(where: str, number: int, cells: list[str], columns: int | None) -> list[float]:
    """One row of numbers; an empty cell is NaN."""
    if len(cells) not in (COLUMNS, COLUMNS + 1):
        raise ClipError(f"{where}: line {number} has {len(cells)} columns; valid: {COLUMNS}, or {COLUMNS + 1} with time in front.")
    if columns is not None and len(cells) != columns:
        raise ClipError(f"{where}: line {number} has {len(cells)} columns where the first has {columns}; valid: the same in every row.")
    for column, cell in enumerate(cells, start=1):
        if cell and not _is_number(cell):
            raise ClipError(f"{where}: line {number} column {column} is {cell[:30]!r}; valid: a number.")
    return [float(cell) if cell else math.nan for cell in cells]


def _states(where: str, states: Floats) -> Floats:
    known = states[~np.isnan(states)]
    if known.size and known.max() > 1.0:
        if not np.all(np.isin(known, (0.0, 1.0, 2.0))):
            odd = float(known[~np.isin(known, (0.0, 1.0, 2.0))][0])
            raise ClipError(f"{where}: state holds {odd:g} beside values above 1; valid: 0, 0.5, 1, or the SDK's 0, 1, 2.")
        return states / 2.0
    return states


def _plane(where: str, name: str, text: str | None) -> list[float] | None:
    if text is None:
        return None
    cells = text.replace(",", " ").split()
    if not all(_is_number(cell) for cell in cells):
        raise ClipError(f"{where}: {name} is {text[:40]!r}; valid: four numbers A B C D.")
    plane: list[float] | Floor = [float(cell) for cell in cells]
    return plane
