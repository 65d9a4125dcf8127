"""Shove a character over again and again and measure its falls, and how often and how soon it is back on both feet."""

import argparse
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from game.commands import DONE, BadInput
from game.commands.casting import body_plan
from game.commands.getup_case import LEAST_NS, MOST_NS, GetupCase, Row, run_getup_case
from game.commands.output_file import check_output_file, write_report
from game.commands.parallel import run_all, usable_cores
from game.commands.set_option import add_settings_options, measured_settings
from game.commands.whole_number import JOBS, check_whole_numbers
from game.progress import Progress
from game.report.session_report import versions
from game.warm_up import tell_of_compiling

SOON_S = 6.0
"""Who stands again so long after the shove began was quick."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--character", default="original", metavar="NAME", help="name or .toml file (default original)")
    add("--falls", type=int, default=20, metavar="N", help=f"shoves of {LEAST_NS:g} to {MOST_NS:g} N s from any side (default 20)")
    add("--seed", type=int, default=0, help="of the shoves, and of the sensor model where sensor.noise is set (default 0)")
    add_settings_options(parser)
    add("--jobs", type=int, default=usable_cores(), metavar="N", help="falls at a time (default: one a core)")
    add("--report", type=Path, metavar="FILE.json", help="write every fall")


def run(arguments: argparse.Namespace) -> int:
    check_whole_numbers(arguments, falls=(1, 10000), jobs=JOBS, seed=(0, 2**31))
    if arguments.report is not None:
        check_output_file("--report", arguments.report, (".json",))
    settings = measured_settings(arguments, {"physics.self_collision": True})
    body_plan(arguments.character)
    cases = [GetupCase(arguments.character, number, arguments.seed) for number in range(arguments.falls)]
    tell_of_compiling()
    bar = Progress("getups", len(cases), unit="falls")
    rows = run_all(partial(run_getup_case, values=settings.as_dict()), cases, arguments.jobs, _lost, bar.show)
    bar.close()
    failed = [row["failed"] for row in rows if "failed" in row]
    if failed:
        raise BadInput(failed[0])
    sums = summary(rows)
    print(as_text(arguments.character, sums))
    if arguments.report is not None:
        asked = {"character": arguments.character, "falls": arguments.falls, "seed": arguments.seed}
        write_report(arguments.report, {**sums, "asked": asked, "shoves": rows, "settings": settings.as_dict(), "versions": versions()})
    return DONE


def summary(rows: list[Row]) -> dict[str, Any]:
    """Shares of all shoves, and the worst of all falls; fast_p99_rad_s over the frames of all falls together."""
    up = [row["up_s"] for row in rows if row["up_s"] is not None]
    fell = [row for row in rows if row["fell"]]
    speeds = np.concatenate([row["fast_rad_s"] for row in fell]) if fell else np.zeros(1)
    return {
        "shoves": len(rows),
        "fell": len(fell),
        "up_share": len(up) / len(rows),
        "up_soon_share": sum(up_s <= SOON_S for up_s in up) / len(rows),
        "up_median_s": float(np.median(up)) if up else None,
        "one_try_share": sum(row["tries"] <= 1 and row["up_s"] is not None for row in rows) / len(rows),
        "fast_p99_rad_s": float(np.percentile(speeds, 99)),
        "past_max_deg": max((row["past_deg"] for row in fell), default=0.0),
        "past_median_deg": float(np.median([row["past_deg"] for row in fell])) if fell else 0.0,
        "deep_max_m": max((row["deep_m"] for row in fell), default=0.0),
        "unexplained_force_max_n": max(row["unexplained_force_n"] for row in rows),
        "guard_actions": sum(row["guard_actions"] for row in rows),
    }


def as_text(character: str, sums: dict[str, Any]) -> str:
    """The summary as a person reads it on a terminal."""
    soon = f"within {SOON_S:g} s of the shove {100 * sums['up_soon_share']:.0f} %"
    median = "" if sums["up_median_s"] is None else f", median {sums['up_median_s']:.1f} s"
    return "\n".join(
        [
            f"{character}: {sums['shoves']} shoves, {sums['fell']} falls",
            f"back on both feet: {100 * sums['up_share']:.0f} %, {soon}, at the first try {100 * sums['one_try_share']:.0f} %{median}",
            f"falls: fastest joint {sums['fast_p99_rad_s']:.1f} rad/s (99th percentile of the frames), past its range by at most "
            f"{sums['past_max_deg']:.0f} degrees ({sums['past_median_deg']:.0f} in the median), {100 * sums['deep_max_m']:.1f} cm deep",
            f"largest unexplained force {sums['unexplained_force_max_n']:.1e} N, guard actions {sums['guard_actions']}",
        ]
    )


def _lost(case: GetupCase) -> Row:
    return {"failed": f"shove {case.number}: its process ended without a word (too little memory, perhaps)."}
