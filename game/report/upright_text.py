"""The upright table as a person reads it on a terminal."""

from collections.abc import Mapping, Sequence
from pathlib import PurePath
from typing import Any

from game.report.thesis_tables import TOTAL_S
from game.report.upright_table import gathered

Entry = Mapping[str, Any]

HEADING = (
    f"{'':35s}{'upright s':>15s}{'of s':>7s}{'%':>7s}{'ends':>7s}"
    f"{'joint error rad':>17s}{'hands, feet m':>16s}{'wrist lag':>11s}{'path':>7s}{'true hand':>19s}{'slide':>10s}{'force N':>9s}"
)
MEANING = (
    "Mean and spread over seeds. ends: runs upright to the end. Errors from the processed target / from the mapped input, while upright.\n"
    "hands, feet: mean distance of the five end-effectors. lag and path: of the wrists against the input.\n"
    "true hand: wrists from the clean performer's at most 0.15 s before, and when they are closest. slide: of bearing feet.\n"
    "force: largest unexplained."
)


def as_text(entries: Sequence[Entry], totals: Sequence[Entry], tables: Mapping[str, Sequence[Entry]]) -> str:
    """The whole table: a block an input, the sums, the thesis's tables with our seconds under theirs."""
    lines = [HEADING]
    for (spec,), of_input in gathered(entries, lambda e: (e["input"],)).items():
        lines.append(short(spec))
        lines += [_line(entry) for entry in of_input]
    lines += ["", "together"]
    lines += [_total(entry) for entry in totals]
    for name, columns in tables.items():
        lines += ["", *_table(name, columns)]
    return "\n".join([*lines, "", MEANING])


def short(spec: str) -> str:
    """A recording by its file's name, anything else as it is."""
    kind, _, argument = spec.partition(":")
    return PurePath(argument).name if kind == "clip" else spec


def _who(entry: Entry) -> str:
    return f"{entry['character']}, {entry['strategy']}" + ("" if entry["ik"] == "dls" else f", IK {entry['ik']}")


def _line(entry: Entry) -> str:
    if not entry["runs"]:
        return f"  {_who(entry):33s} failed: {entry['failed'][0]}"
    upright, share = entry["upright_s"], entry["share"]
    text = f"  {_who(entry):33s}{_spread(upright, '6.2f', '5.2f'):>15s}{entry['clip_s']:7.1f}{100.0 * share['mean']:7.1f}"
    text += f"{entry['to_the_end']}/{entry['runs']}".rjust(7)
    text += _pair(entry, "joint_error_parent_rad", ".3f").rjust(17) + _pair(entry, "end_effector_error_m", ".3f").rjust(16)
    lag, path = entry["wrist_lag_s"], entry["wrist_path_ratio"]
    text += f"{'-' if lag is None else format(1000.0 * lag['mean'], '.0f') + ' ms':>11s}"
    text += f"{'-' if path is None else format(100.0 * path['mean'], '.0f') + ' %':>7s}"
    hand, delay, slide = entry["hand_error_true_m"], entry["hand_delay_s"], entry["foot_slide_m_s"]
    text += f"{'-' if hand is None else format(hand['mean'], '.3f') + ' m, ' + format(1000.0 * delay['mean'], '.0f') + ' ms':>19s}"
    text += f"{'-' if slide is None else format(100.0 * slide['mean'], '.1f') + ' cm/s':>10s}{entry['unexplained_force_max_n']:9.0e}"
    return text + (f"  {len(entry['failed'])} failed: {entry['failed'][0]}" if entry["failed"] else "")


def _spread(value: Mapping[str, float], mean: str, spread: str) -> str:
    return format(value["mean"], mean) + (" +-" + format(value["spread"], spread) if value["spread"] > 0.0 else " " * 8)


def _pair(entry: Entry, name: str, form: str) -> str:
    values = (entry[name], entry[f"{name}_vs_mapped"])
    return " / ".join("-" if value is None else format(value["mean"], form) for value in values)


def _total(entry: Entry) -> str:
    who = f"  {entry['of']}: {_who(entry)}"
    if not entry["runs"]:
        return f"{who:46s} every run failed"
    text = f"{who:46s}{entry['upright_s']:8.1f} of {entry['clip_s']:.1f} s, {100.0 * entry['share']:.2f} %"
    text += f", {entry['to_the_end']} of {entry['runs']} runs to the end, worst run {100.0 * entry['worst_share']:.0f} %"
    text += f", seeds spread {entry['spread_s']:.1f} s" if entry["spread_s"] else ""
    return text + (f", {entry['failed']} failed" if entry["failed"] else "")


def _table(name: str, columns: Sequence[Entry]) -> list[str]:
    """Headings, the thesis's seconds, then a line for each strategy that played: seconds and share of the clips it played."""
    width = 25
    strategies = list(dict.fromkeys(strategy for column in columns for strategy in column["ours"]))
    lines = [f"{name:24s}" + "".join(f"{column['column']:>{width}s}" for column in columns)]
    lines.append(
        f"{f'  thesis, of {TOTAL_S:.1f} s':24s}" + "".join(_cell(column["thesis_s"], TOTAL_S, 8).rjust(width) for column in columns)
    )
    for strategy in strategies:
        cells = [column["ours"].get(strategy) for column in columns]
        text = "".join((_cell(c["upright_s"], c["of_s"], c["clips"]) if c else "-").rjust(width) for c in cells)
        lines.append(f"{f'  {strategy}':24s}" + text)
    if not strategies:
        lines.append("  (none of these runs was a performer clip of the thesis)")
    return lines


def _cell(seconds: float | None, of_s: float, clips: int) -> str:
    if seconds is None:
        return "-"
    return f"{seconds:.1f} ({100.0 * seconds / of_s:.1f} %)" + ("" if clips == 8 else f" {clips} clips")
