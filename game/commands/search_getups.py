"""Search key poses with which bodies get up from the floor, over many ways to lie there; see docs/method.md."""

import argparse
import time
import warnings
from collections.abc import Sequence
from functools import cache, partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w
from numpy.typing import NDArray

from game.characters.body_plan import BUILT_IN
from game.characters.skeleton import JOINTS
from game.commands import DONE, BadInput
from game.commands.getup_trial import AXES, READY, Trial, numbers_of, poses_of
from game.commands.output_file import check_output_file
from game.commands.parallel import one_blas_thread, usable_cores
from game.commands.set_option import add_settings_options, measured_settings
from game.commands.whole_number import JOBS, check_whole_numbers
from game.control.whole_body.getting_up import ON_SIDE
from game.control.whole_body.key_poses import ROUTES, KeyPose, key_poses
from game.progress import Progress
from game.rotation import matrix
from game.tunables import Settings, Value
from game.warm_up import tell_of_compiling

Floats = NDArray[np.float64]
Start = tuple[str, Floats]

HEADER = """# Key poses on the way up from the floor, as `run_game.py search-getups` finds them: seconds on the way there, then
# degrees about x, y, z of each joint that is not straight. A joint without a side is the left one, and the right one its mirror
# image. `side` begins on the right side, and is mirrored on the left one; `supine` rolls over to the front; `prone` comes up.
"""

GETS_UP: dict[str, Value] = {"physics.self_collision": True, "balance.strategy": "whole-body", "whole_body.get_up": True}
"""Whatever the preset, the starts are those of bodies that are about to get up."""

TRIED_FROM = 10
"""Every proposal of a round is tried from so many starts, which are drawn anew for each round."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--route", choices=ROUTES, required=True, help="from which side; the key poses of the other routes stay as they are")
    add("--minutes", type=float, default=10.0, help="how long to search (default 10)")
    add("--characters", nargs="+", default=list(BUILT_IN), metavar="NAME", help="who has to get up (default: all five)")
    add("--starts", type=int, default=40, metavar="N", help="ways to lie there, for each character (default 40)")
    add("--spread", type=float, default=0.15, help="how far the first proposals scatter; 1 is half a radian (default 0.15)")
    add("--seed", type=int, default=0, help="of the starts and the proposals (default 0)")
    add_settings_options(parser)
    add("--jobs", type=int, default=usable_cores(), metavar="N", help="proposals tried at a time (default: one a core)")
    add("--out", type=Path, required=True, metavar="FILE.toml", help="write the key poses of all routes")


def run(arguments: argparse.Namespace) -> int:
    check_whole_numbers(arguments, starts=(1, 10000), jobs=JOBS, seed=(0, 2**31))
    check_output_file("--out", arguments.out, (".toml",))
    strategy = evolution_strategy()
    settings = measured_settings(arguments, GETS_UP)
    tell_of_compiling()
    values, route, rng = settings.as_dict(), arguments.route, np.random.default_rng(arguments.seed)
    with one_blas_thread(), get_context("spawn").Pool(arguments.jobs) as pool:
        lying = pool.map(partial(ways_to_lie, values, arguments.starts, arguments.seed), arguments.characters, chunksize=1)
        starts = [start for of_one in lying for start in of_one if lies_on(start[1]) == route]
        if route == "prone":
            on_the_back = [start for of_one in lying for start in of_one if lies_on(start[1]) == "supine"]
            starts += [start for start in pool.map(partial(rolled, values), on_the_back, chunksize=4) if lies_on(start[1]) == route]
        if len(starts) < TRIED_FROM:
            raise BadInput(f"--starts: only {len(starts)} of the bodies came to lie for the route {route}; ask for more.")
        first, options = numbers_of(route, key_poses()[route]), {"seed": arguments.seed + 1, "popsize": 18, "verbose": -9}
        search = strategy(first, arguments.spread, options)
        bar, began = Progress(f"search-getups {route}", 60.0 * arguments.minutes), time.monotonic()
        while time.monotonic() - began < 60.0 * arguments.minutes:
            drawn = [starts[k] for k in rng.choice(len(starts), TRIED_FROM, replace=False)]
            proposals = search.ask()
            search.tell(proposals, pool.map(partial(mean_loss, values, route, drawn), proposals, chunksize=3))
            bar.show(time.monotonic() - began)
        bar.close()
        before, found = key_poses()[route], poses_of(route, np.array(search.result.xfavorite))
        share_before, share = (
            float(np.mean(pool.map(partial(is_good, values, route, poses), starts, chunksize=4))) for poses in (before, found)
        )
    print(
        f"{route}: of {len(starts)} ways to lie there {100 * share_before:.0f} % succeeded before, {100 * share:.0f} % with what was found."
    )
    if share <= share_before:
        print("That is no better, so the key poses stay as they are.")
        found = before
    write_key_poses(arguments.out, {**key_poses(), route: found})
    return DONE


def evolution_strategy() -> Any:
    """Hansen's CMA-ES; only the search needs its package."""
    try:
        with warnings.catch_warnings(action="ignore"):  # it misses matplotlib, which we do not plot with
            from cma import CMAEvolutionStrategy
    except ImportError as fault:
        raise BadInput("the search needs the package cma; install it with: pip install cma, or topple[search]") from fault
    return CMAEvolutionStrategy


@cache
def _trial(character: str, values: frozenset[tuple[str, Value]]) -> Trial:
    return Trial(character, Settings(dict(values)))


def trial_of(character: str, values: dict[str, Value]) -> Trial:
    """One a process and character."""
    return _trial(character, frozenset(values.items()))


def ways_to_lie(values: dict[str, Value], count: int, seed: int, character: str) -> list[Start]:
    """The character's name and (63,) how it lies, after falls drawn from the seed."""
    rng = np.random.default_rng((seed, *character.encode()))
    return [(character, trial_of(character, values).lie(rng)) for _ in range(count)]


def rolled(values: dict[str, Value], start: Start) -> Start:
    """Who lay on the back, after rolling over."""
    character, lying = start
    return character, trial_of(character, values).roll(lying)


def lies_on(configuration: Floats) -> str:
    """The route from a configuration (63,), by how the pelvis lies."""
    ahead, left, _ = matrix(configuration[3:7])[2]
    return "side" if abs(left) > ON_SIDE else "supine" if ahead >= 0.0 else "prone"


def mean_loss(values: dict[str, Value], route: str, starts: Sequence[Start], numbers: Floats) -> float:
    """Of a proposal: how far its tries end from standing ready, how many do not, and how long and how far out its poses are."""
    poses = poses_of(route, numbers)
    losses = np.array([trial_of(character, values).loss(lying, route, poses) for character, lying in starts])
    effort = 0.03 * sum(pose.seconds for pose in poses) + 2e-4 * float(np.sum(np.square(numbers)))
    return float(np.mean(np.minimum(losses, 2.0)) + 0.5 * np.mean(losses > READY)) + effort


def is_good(values: dict[str, Value], route: str, poses: Sequence[KeyPose], start: Start) -> bool:
    character, lying = start
    return trial_of(character, values).loss(lying, route, poses) <= READY


def write_key_poses(path: Path, found: dict[str, Sequence[KeyPose]]) -> None:
    """As `key_poses` reads them."""
    rows = {route: [_row(route, pose) for pose in found[route]] for route in ROUTES}
    path.write_text(HEADER + "\n" + tomli_w.dumps(rows), encoding="utf-8")


def _row(route: str, pose: KeyPose) -> dict[str, object]:
    of_both = AXES[route] is AXES["side"]
    row: dict[str, object] = {"seconds": round(pose.seconds, 3)}
    for joint, turned in zip(JOINTS, np.degrees(pose.joints), strict=True):
        if np.abs(turned).max() > 0.05 and (of_both or not joint.endswith("right")):
            row[joint if of_both else joint.removesuffix("_left")] = [round(float(angle), 1) + 0.0 for angle in turned]
    return row
