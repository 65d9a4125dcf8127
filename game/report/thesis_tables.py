"""Tables 3 and 4 of Zwennes 2014: seconds upright of the eight clips together, to stand beside ours.

The thesis gives sums over its clips only, each the mean of three runs, and no figure for a single clip but its length (Table 1).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

TOTAL_S: Final = 139.0
"""What Table 3 calls the total; the lengths of Table 1 add up to 137.7 s, so compare shares rather than seconds."""

CLIP_S: Final[Mapping[str, float]] = {
    "waving": 12.1,
    "leaning": 32.0,
    "bowing": 9.2,
    "reaching": 8.6,
    "boxing": 15.6,
    "stepping": 10.7,
    "balancing": 28.3,
    "jump": 21.2,
}
"""Table 1: length of each clip, seconds."""

Row = Mapping[str, Any]


@dataclass(frozen=True)
class Column:
    """One column of a table: its heading, the seconds the thesis measured (None: not measured), and which of our rows belong to it."""

    heading: str
    thesis_s: float | None
    ours: Callable[[Row], bool]


def _table_3(heading: str, thesis_s: float, *, ik: bool, balance: bool) -> Column:
    def ours(row: Row) -> bool:
        return row["character"] == "original" and (row["ik"] != "none") == ik and (row["strategy"] != "none") == balance

    return Column(heading, thesis_s, ours)


TABLE_3: Final = (
    _table_3("no IK, no BC", 112.2, ik=False, balance=False),
    _table_3("IK, no BC", 112.9, ik=True, balance=False),
    _table_3("no IK, BC", 128.4, ik=False, balance=True),
    _table_3("IK, BC", 128.1, ik=True, balance=True),
)
"""Table 3: with and without IK-based processing (IK) and balance control (BC), the original character."""


def _table_4(heading: str, thesis_s: float | None, character: str) -> Column:
    return Column(heading, thesis_s, lambda row: row["character"] == character and row["ik"] != "none" and row["strategy"] != "none")


TABLE_4: Final = (
    _table_4("original", 128.1, "original"),
    _table_4("weight distribution", 42.4, "human"),
    _table_4("the same as boxes", None, "human-boxes"),
    _table_4("lower COM", 128.0, "low-com"),
    _table_4("asymmetric", 92.7, "asymmetric"),
)
"""Table 4: morphologies, with IK and balance control. `human-boxes` is a second reading of the thesis's weight distribution."""


def beside_the_thesis(columns: Sequence[Column], rows: Sequence[Row]) -> list[dict[str, Any]]:
    """The columns with our seconds: for each strategy the sum over performer clips of the mean over seeds, and their length.

    Only rows of the eight performer clips count; a strategy that did not play all eight in a column is marked by `clips`.
    """
    entries = []
    for column in columns:
        of_column = [row for row in rows if _clip(row) in CLIP_S and "failed" not in row and column.ours(row)]
        ours = {
            strategy: _sums([row for row in of_column if row["strategy"] == strategy])
            for strategy in dict.fromkeys(row["strategy"] for row in of_column)
        }
        entries.append({"column": column.heading, "thesis_s": column.thesis_s, "thesis_of_s": TOTAL_S, "ours": ours})
    return entries


def _clip(row: Row) -> str:
    return str(row["input"]).removeprefix("performer:")


def _sums(rows: Sequence[Row]) -> dict[str, float]:
    clips: dict[str, list[Row]] = {}
    for row in rows:
        clips.setdefault(_clip(row), []).append(row)
    upright = sum(sum(row["upright_s"] for row in runs) / len(runs) for runs in clips.values())
    length = sum(sum(row["clip_s"] for row in runs) / len(runs) for runs in clips.values())
    return {"upright_s": upright, "of_s": length, "share": upright / length, "clips": len(clips)}
