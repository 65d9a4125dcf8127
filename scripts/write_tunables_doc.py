"""Writes docs/tunables.md from the declarations in game/tunables.py: python scripts/write_tunables_doc.py"""

import sys
from itertools import groupby
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from game.presets import PRESETS  # noqa: E402
from game.tunables import TUNABLES, Tunable, Value  # noqa: E402

PAGE = ROOT / "docs" / "tunables.md"
OPENING = """# Every number you may turn

This page is written by `scripts/write_tunables_doc.py` from `game/tunables.py`; edit that file, not this one.

Each number has one slider in the overlay (Tab), one line in the settings file and one name for the command line:
`--set ik.damping=0.2`. `--list-tunables` prints the same list. A dagger (†) marks what takes effect when the scene restarts.
Equation numbers are those of Zwennes 2014; [method.md](method.md) explains them.
"""


def shown(value: Value) -> str:
    """A value as a reader writes it: on and off for switches, no needless digits."""
    if isinstance(value, bool):
        return "on" if value else "off"
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def span(tunable: Tunable) -> str:
    """What a tunable may be: its words, on or off, or its range with the unit."""
    if isinstance(tunable.default, bool):
        return "on, off"
    if tunable.choices:
        return ", ".join(tunable.choices)
    return f"{shown(tunable.low)} to {shown(tunable.high)} {tunable.unit}".rstrip()


def row(tunable: Tunable) -> str:
    mark = " †" if tunable.restart else ""
    thesis = PRESETS["thesis"].get(tunable.name, tunable.default)
    differs = shown(thesis) if thesis != tunable.default else ""
    return f"| `{tunable.name}`{mark} | {shown(tunable.default)} | {differs} | {span(tunable)} | {tunable.meaning} |"


def page() -> str:
    """The whole page as Markdown."""
    parts = [OPENING]
    for group, tunables in groupby(TUNABLES.values(), key=lambda tunable: tunable.group):
        rows = "\n".join(map(row, tunables))
        parts.append(f"## {group}\n\n| name | default | in `thesis` | may be | meaning |\n| --- | --- | --- | --- | --- |\n{rows}\n")
    return "\n".join(parts)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
