"""Measure how hard a character may be pushed at the chest, from eight directions, before it does not recover."""

import argparse
from functools import partial
from pathlib import Path
from typing import Any

from game.commands import DONE, BadInput
from game.commands.casting import body_plan
from game.commands.output_file import check_output_file, write_report
from game.commands.parallel import run_all, usable_cores
from game.commands.push_case import WHILE, PushCase, Row, run_push_case
from game.commands.set_option import add_settings_options, measured_settings
from game.commands.whole_number import JOBS, check_whole_numbers
from game.progress import Progress
from game.report.polar_plot import polar_plot
from game.report.session_report import versions
from game.tunables import Settings
from game.warm_up import tell_of_compiling

DIRECTIONS_DEG = tuple(45.0 * k for k in range(8))

WORDS = ("forward", "forward left", "left", "back left", "back", "back right", "right", "forward right")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--character", default="original", metavar="NAME", help="name or .toml file (default original)")
    add("--while", choices=tuple(WHILE), default="standing", dest="doing", help="what the player does meanwhile (default standing)")
    add("--tries", type=int, default=2, metavar="N", help="moments at which each push must be recovered from (default 2)")
    add("--seed", type=int, default=0, help="of the sensor model, where sensor.noise is set (default 0)")
    add_settings_options(parser)
    add("--jobs", type=int, default=usable_cores(), metavar="N", help="directions at a time (default: one a core)")
    add("--report", type=Path, metavar="FILE.json", help="write every push, and beside it the polar plot as FILE.png")


def run(arguments: argparse.Namespace) -> int:
    check_whole_numbers(arguments, tries=(1, 20), jobs=JOBS)
    written: Path | None = arguments.report
    if written is not None:
        check_output_file("--report", written, (".json",))
        check_output_file("--report", written.with_suffix(".png"))
    settings = settings_from(arguments)
    body_plan(arguments.character)
    cases = [PushCase(arguments.doing, arguments.character, angle, arguments.tries, arguments.seed) for angle in DIRECTIONS_DEG]
    tell_of_compiling()
    bar = Progress("pushes", len(cases), unit="directions")
    rows = run_all(partial(run_push_case, values=settings.as_dict()), cases, arguments.jobs, _lost, bar.show)
    bar.close()
    failed = [row["failed"] for row in rows if "failed" in row]
    if failed:
        raise BadInput(failed[0])
    sums = summary(rows)
    print(as_text(rows, sums))
    if written is not None:
        asked = {"character": arguments.character, "while": arguments.doing, "tries": arguments.tries}
        write_report(written, {**sums, "asked": asked, "directions": rows, "settings": settings.as_dict(), "versions": versions()})
        title = f"{arguments.character}, {arguments.doing}: mean {sums['mean_impulse_ns']:.0f} N s, worst {sums['worst_impulse_ns']:.0f}"
        polar_plot(written.with_suffix(".png"), title, DIRECTIONS_DEG, sums["per_direction_ns"])
    return DONE


def settings_from(arguments: argparse.Namespace) -> Settings:
    """What is measured with: a body that collides with itself; raises BadInput."""
    return measured_settings(arguments, {"physics.self_collision": True})


def summary(rows: list[Row]) -> dict[str, Any]:
    """mean_impulse_ns, worst_impulse_ns, per_direction_ns, and the largest unexplained force and number of guard actions of all pushes."""
    impulses = [float(row["impulse_ns"]) for row in rows]
    return {
        "mean_impulse_ns": sum(impulses) / len(impulses),
        "worst_impulse_ns": min(impulses),
        "per_direction_ns": impulses,
        "unexplained_force_max_n": max(row["unexplained_force_max_n"] for row in rows),
        "guard_actions": sum(run["guard_actions"] for row in rows for run in row["runs"]),
    }


def as_text(rows: list[Row], sums: dict[str, Any]) -> str:
    """The table as a person reads it on a terminal."""
    lines = [f"{'pushed':16s}{'recovered, N s':>15s}   beyond it"]
    lines += [f"{word:16s}{row['impulse_ns']:15.0f}   {row['failure'] or '-'}" for word, row in zip(WORDS, rows, strict=True)]
    lines.append(f"mean {sums['mean_impulse_ns']:.1f} N s, worst {sums['worst_impulse_ns']:.0f} N s")
    lines.append(f"largest unexplained force {sums['unexplained_force_max_n']:.1e} N, guard actions {sums['guard_actions']}")
    return "\n".join(lines)


def _lost(case: PushCase) -> Row:
    return {"failed": f"{case.direction_deg:g} degrees: the process that pushed ended without a word (too little memory, perhaps)."}
