"""Measure how long characters stay upright: every input by every character with every strategy and seed, in parallel."""

import argparse
import glob
import re
from functools import partial
from pathlib import Path

from game.characters.body_plan import BUILT_IN
from game.commands import BAD_INPUT, DONE, BadInput
from game.commands.casting import body_plan
from game.commands.output_file import check_output_file, write_report
from game.commands.parallel import run_all, usable_cores
from game.commands.set_option import add_settings_options, measured_settings
from game.commands.upright_case import Case, Row, run_case
from game.commands.whole_number import JOBS, check_whole_numbers
from game.progress import Progress
from game.report.session_report import versions
from game.report.thesis_tables import CLIP_S, TABLE_3, TABLE_4, beside_the_thesis
from game.report.upright_table import over_seeds, totals
from game.report.upright_text import as_text
from game.tunables import TUNABLES, Settings, TunableError
from game.warm_up import tell_of_compiling

MOST_SEEDS = 1000


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--inputs", nargs="+", default=[], metavar="GLOB", help="recordings, such as 'clips/*.npz', or performer:NAME")
    add("--performers", action="store_true", help="the eight performer clips of the thesis (default where there are no --inputs)")
    add(
        "--characters",
        nargs="+",
        default=["original"],
        metavar="NAME",
        help="names or .toml files, or all: the thesis's five (default original)",
    )
    add("--strategies", nargs="+", metavar="NAME", help=f"of {', '.join(TUNABLES['balance.strategy'].choices)} (default: the preset's)")
    add("--ik", nargs="+", metavar="NAME", help=f"of {', '.join(TUNABLES['ik.method'].choices)} (default: the preset's)")
    add_settings_options(parser)
    add("--noise", metavar="X", help="short for --set sensor.noise=X; acts on performers only")
    add("--outliers", metavar="X", help="short for --set sensor.outliers=X; acts on performers only")
    add("--latency", metavar="S", help="short for --set sensor.latency_s=S; acts on performers only")
    add("--seeds", default="1", metavar="N|A-B", help="how many seeds from 0, or from A to B; a recording is played once (default 1)")
    add("--jobs", type=int, default=usable_cores(), metavar="N", help="runs at a time (default: one a core)")
    add("--whole", action="store_true", help="play on after a fall")
    add("--report", type=Path, metavar="FILE.json", help="write every run, the table and the thesis's tables")


def run(arguments: argparse.Namespace) -> int:
    check_whole_numbers(arguments, jobs=JOBS)
    if arguments.report is not None:
        check_output_file("--report", arguments.report)
    settings = settings_from(arguments)
    cases = cases_from(arguments, settings)
    tell_of_compiling()
    bar = Progress("upright", len(cases), unit="runs")
    work = partial(run_case, values=settings.as_dict(), whole=arguments.whole)
    rows = run_all(work, cases, arguments.jobs, _lost, bar.show)
    bar.close()
    entries, sums = over_seeds(rows), totals(rows)
    tables = {"Table 3": beside_the_thesis(TABLE_3, rows), "Table 4": beside_the_thesis(TABLE_4, rows)}
    print(as_text(entries, sums, tables))
    if arguments.report is not None:
        given = {"inputs": [case.input for case in cases], "seeds": seeds_from(arguments.seeds), "whole": arguments.whole}
        report = {"asked": given, "table": entries, "totals": sums, "thesis": tables, "runs": rows}
        write_report(arguments.report, {**report, "settings": settings.as_dict(), "versions": versions()})
    return BAD_INPUT if any("failed" in row for row in rows) else DONE


def settings_from(arguments: argparse.Namespace) -> Settings:
    """What is played with; raises BadInput."""
    options = {"sensor.noise": arguments.noise, "sensor.outliers": arguments.outliers, "sensor.latency_s": arguments.latency}
    return measured_settings(arguments, options)


def cases_from(arguments: argparse.Namespace, settings: Settings) -> list[Case]:
    """Every line of the table in its order: input, character, strategy, IK method, seed; raises BadInput."""
    inputs = inputs_from(arguments.inputs, performers=arguments.performers or not arguments.inputs)
    characters = list(dict.fromkeys(name for given in arguments.characters for name in (BUILT_IN if given == "all" else (given,))))
    strategies = _words("balance.strategy", arguments.strategies, settings)
    methods = _words("ik.method", arguments.ik, settings)
    seeds = seeds_from(arguments.seeds)
    for name in characters:
        body_plan(name)
    return [
        Case(spec, character, strategy, method, seed)
        for spec in inputs
        for character in characters
        for strategy in strategies
        for method in methods
        for seed in ([None] if spec.startswith("clip:") else seeds)
    ]


def inputs_from(patterns: list[str], *, performers: bool) -> list[str]:
    """Input specs of file patterns and specs, each once; raises BadInput where a pattern matches no file."""
    specs = [f"performer:{name}" for name in CLIP_S] if performers else []
    for pattern in patterns:
        if pattern.startswith(("performer:", "clip:")):
            specs.append(pattern)
            continue
        files = sorted(glob.glob(pattern, recursive=True))
        if not files:
            raise BadInput(f"--inputs {pattern!r} matches no file; give recordings (.npz, .csv), patterns of them, or performer:NAME.")
        specs += [f"clip:{file}" for file in files]
    return list(dict.fromkeys(specs))


def seeds_from(text: str) -> list[int]:
    """The seeds of "5" (0 to 4) or "10-19"; raises BadInput."""
    match = re.fullmatch(r"(\d{1,9})(?:-(\d{1,9}))?", text.strip())
    first, last = (0, -1) if match is None else (0, int(match[1]) - 1) if match[2] is None else (int(match[1]), int(match[2]))
    if not 0 <= last - first < MOST_SEEDS:
        raise BadInput(f"--seeds {text!r} must be how many (1 to {MOST_SEEDS}) or a range of at most as many, such as 10-19.")
    return list(range(first, last + 1))


def _words(tunable: str, given: list[str] | None, settings: Settings) -> list[str]:
    try:
        return list(dict.fromkeys(str(TUNABLES[tunable].parse(word)) for word in given or [settings.choice(tunable)]))
    except TunableError as fault:
        raise BadInput(str(fault)) from fault


def _lost(case: Case) -> Row:
    return {**vars(case), "failed": f"{case.input}: the process that played it ended without a word (too little memory, perhaps)."}
