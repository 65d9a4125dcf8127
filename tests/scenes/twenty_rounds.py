"""First rounds of seeded duels against a puppet that boxes by itself: `python -m tests.scenes.twenty_rounds [SEEDS]` prints the table."""

import multiprocessing
import os
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from statistics import median

SIDES = {0: "You", 1: "Opponent", None: "nobody"}


@dataclass(frozen=True)
class FirstRound:
    """How the first round of a seed ended. winner: 0 you, 1 the opponent, None a draw."""

    seed: int
    winner: int | None
    length_s: float
    why: str

    @property
    def timed_out(self) -> bool:
        return self.why == "time is up"


def first_round(seed: int) -> FirstRound:
    """Play the duel of `seed` with preset default until its first round is over."""
    from tests.scenes.staged import make_scene

    scene = make_scene("duel", "script", seed=seed)
    scene.enter()
    rounds: Sequence[object] = ()
    while not rounds:
        scene.fixed_update()
        found = scene.report()["rounds"] if scene.time_s * 60.0 % 6.0 < 0.5 else ()
        assert isinstance(found, (list, tuple))
        rounds = found
    scene.leave()
    ended = rounds[0]
    assert isinstance(ended, dict)
    winner = {"You": 0, "Opponent": 1, None: None}[ended["winner"]]
    return FirstRound(seed, winner, float(ended["length_s"]), str(ended["why"]))


def first_rounds(seeds: Sequence[int], processes: int = 2) -> list[FirstRound]:
    """The first round of each seed, played in so many processes with one BLAS thread each."""
    os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    with ProcessPoolExecutor(processes, mp_context=multiprocessing.get_context("spawn")) as pool:
        return list(pool.map(first_round, seeds))


def table(rounds: Sequence[FirstRound]) -> str:
    """A line per seed and a line of sums."""
    lines = [f"seed {r.seed:3d}  {SIDES[r.winner]:9s} {r.length_s:6.1f} s  {r.why}" for r in rounds]
    won = [sum(r.winner == side for r in rounds) for side in (0, 1)]
    late = sum(r.timed_out for r in rounds)
    lines.append(f"You {won[0]} : {won[1]} Opponent, median {median(r.length_s for r in rounds):.1f} s, {late} of {len(rounds)} timed out")
    return "\n".join(lines)


if __name__ == "__main__":
    print(table(first_rounds(range(int(sys.argv[1]) if len(sys.argv) > 1 else 20))))
