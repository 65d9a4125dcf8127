"""Measure how fast Topple is on this machine, in one run: the chain without a picture, the picture, the start, the Kinect."""

import argparse
import json
import os
import platform
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from game.commands import DONE, BadInput
from game.commands.output_file import check_output_file, write_report

ROOT = Path(__file__).resolve().parents[2]
ONE_THREAD = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
STARTS = 3
KINECT = ("sensor.noise=1", "sensor.outliers=1")
"""A performer as a real sensor would see it: the sensor model is part of the chain then."""

CHAIN_NOTE = (
    "Chain: no drawing, process CPU time on one core, median of five runs. Steady begins one second after the release; "
    "with the start included, entering the scene, the hang and that second count too."
)


@dataclass(frozen=True)
class Row:
    """One line of the table. value: None where it could not be measured; goal: what it should reach, None without one."""

    what: str
    value: float | None
    unit: str
    goal: float | None = None
    more_is_better: bool = True

    @property
    def met(self) -> bool | None:
        """Whether the goal is reached; None where there is none or nothing was measured."""
        if self.goal is None or self.value is None:
            return None
        return self.value >= self.goal if self.more_is_better else self.value <= self.goal


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--seconds",
        type=float,
        default=5.0,
        metavar="S",
        help="simulated time measured in each run of the chain, after its first second (default 5)",
    )
    parser.add_argument("--report", type=Path, metavar="FILE.json", help="write the figures")


def run(arguments: argparse.Namespace) -> int:
    if not 0.0 < arguments.seconds <= 600.0:
        raise BadInput(f"--seconds must lie between 0 and 600, not {arguments.seconds:g}.")
    if arguments.report is not None:
        check_output_file("--report", arguments.report)
    figures = measure(arguments.seconds)
    rows = table(figures)
    print(as_text(rows))
    print(CHAIN_NOTE)
    if arguments.report is not None:
        goals = [{"what": r.what, "value": r.value, "unit": r.unit, "goal": r.goal, "met": r.met} for r in rows]
        write_report(arguments.report, {"machine": machine(), "seconds": arguments.seconds, "table": goals, **figures})
    return DONE


def measure(seconds: float) -> dict[str, Any]:
    """The figures of every part; each runs in a process of its own."""
    figures: dict[str, Any] = {}
    for scene in ("mirror", "duel"):
        figures[f"chain_{scene}"] = part("chain", scene, str(seconds), environment=ONE_THREAD)
    figures["chain_noisy"] = part("chain", "mirror", str(seconds), *KINECT, environment=ONE_THREAD)
    figures["drawing"] = part("drawing", environment={**ONE_THREAD, "GALLIUM_NOOP": "1"})
    for scene in ("mirror", "duel"):
        figures[f"headless_{scene}"] = part("headless", scene)
    figures["kinect_reader"] = part("kinect_reader", "4", environment=ONE_THREAD)
    starts: list[dict[str, Any]] = []
    for _ in range(STARTS):
        began = time.time()
        start = part("first_frame", "mirror")
        starts.append({"start_s": start["finished_s"] - began} if "finished_s" in start else start)
    figures["start"] = {"start_s": median(s["start_s"] for s in starts), "runs": starts} if "start_s" in starts[0] else starts[0]
    return figures


def part(*words: str, environment: Mapping[str, str] | None = None) -> dict[str, Any]:
    """The figures of one part of the benchmark. Raises RuntimeError with its last words where it broke."""
    print(f"topple: measuring {' '.join(words)}", file=sys.stderr, flush=True)
    path = os.pathsep.join(filter(None, (str(ROOT), os.environ.get("PYTHONPATH", ""))))
    command = [sys.executable, "-m", "game.commands.benchmark_parts", *words]
    ended = subprocess.run(
        command, env={**os.environ, **(environment or {}), "PYTHONPATH": path}, capture_output=True, text=True, check=False
    )
    if ended.returncode != 0:
        raise RuntimeError(f"the part {' '.join(words)} of the benchmark broke: {ended.stderr.strip()[-2000:]}")
    return json.loads(ended.stdout)


def table(figures: Mapping[str, Any]) -> list[Row]:
    """What matters of the figures, with the goals of the project."""
    mirror, noisy, duel, drawn = figures["chain_mirror"], figures["chain_noisy"], figures["chain_duel"], figures["drawing"]
    rows = [
        Row("chain, one character, steady", mirror["real_time_factor"], "x real time", 10.0),
        Row("chain, the same, sensor model at scale 1", noisy["real_time_factor"], "x real time", 10.0),
        Row("chain, one character, start included", mirror["from_start_real_time_factor"], "x real time"),
        Row("entering the scene, one character", 1e3 * mirror["entering_s"], "ms"),
        Row("chain, duel, steady", duel["real_time_factor"], "x real time"),
        Row("chain, duel, start included", duel["from_start_real_time_factor"], "x real time"),
        Row("entering the scene, duel", 1e3 * duel["entering_s"], "ms"),
        Row("target, one character", mirror["ms_per_frame"]["target"], "ms per frame", 1.0, more_is_better=False),
    ]
    rows += [Row(f"{stage}, one character", mirror["ms_per_frame"][stage], "ms per frame") for stage in ("control", "physics")]
    rows += [Row(f"{stage}, duel", duel["ms_per_frame"][stage], "ms per frame") for stage in ("target", "control", "physics")]
    rows += [
        Row("Python side of drawing, two fighters", drawn.get("render_ms"), "ms per frame", 1.0, more_is_better=False),
        Row("posing two fighters", drawn.get("posing_ms"), "ms per frame"),
        Row("headless 640x360 low, one character", figures["headless_mirror"].get("frames_per_s"), "frames/s", 15.0),
        Row("headless 640x360 low, duel", figures["headless_duel"].get("frames_per_s"), "frames/s", 15.0),
        Row("start to first frame, warm", figures["start"].get("start_s"), "s", 3.0, more_is_better=False),
        Row("reading a simulated Kinect", 100.0 * figures["kinect_reader"]["core_share"], "% of a core", 15.0, more_is_better=False),
    ]
    return rows


def as_text(rows: list[Row]) -> str:
    """The table for a person."""
    lines = []
    for row in rows:
        value = "no picture here" if row.value is None else f"{row.value:8.2f} {row.unit}"
        goal = "" if row.goal is None else f"{'at least' if row.more_is_better else 'at most'} {row.goal:g}"
        verdict = {True: "met", False: "missed", None: ""}[row.met]
        lines.append(f"{row.what:40s} {value:22s} {goal:12s} {verdict}".rstrip())
    return "\n".join(lines)


def machine() -> dict[str, object]:
    """On what the figures were measured."""
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else None
    return {"system": platform.platform(), "cores": os.cpu_count(), "python": platform.python_version(), "load_1_min": load}
