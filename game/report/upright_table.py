"""The upright table: rows of single runs gathered over seeds, summed over inputs, and set as text."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from statistics import fmean, pstdev
from typing import Any

Row = Mapping[str, Any]

SPREAD = (
    "upright_s",
    "share",
    "joint_error_parent_rad",
    "joint_error_parent_rad_vs_mapped",
    "end_effector_error_m",
    "end_effector_error_m_vs_mapped",
    "wrist_lag_s",
    "wrist_path_ratio",
    "hand_error_true_m",
    "hand_delay_s",
    "foot_slide_m_s",
)
"""What is given as mean and spread over the seeds."""


def gathered(rows: Iterable[Row], key: Callable[[Row], tuple]) -> dict[tuple, list[Row]]:
    """The rows by their key, in the order in which the keys first appear."""
    groups: dict[tuple, list[Row]] = {}
    for row in rows:
        groups.setdefault(key(row), []).append(row)
    return groups


def over_seeds(rows: Sequence[Row]) -> list[dict[str, Any]]:
    """One entry for each input, character, strategy and IK method: mean and spread (standard deviation) over its seeds, the worst run."""
    entries = []
    for (spec, character, strategy, ik), runs in gathered(rows, lambda r: (r["input"], r["character"], r["strategy"], r["ik"])).items():
        entry: dict[str, Any] = {"input": spec, "character": character, "strategy": strategy, "ik": ik}
        good = [run for run in runs if "failed" not in run]
        entries.append(entry | {"runs": len(good), "failed": [run["failed"] for run in runs if "failed" in run], **_measured(good)})
    return entries


def _measured(runs: Sequence[Row]) -> dict[str, Any]:
    if not runs:
        return {}
    out: dict[str, Any] = {"clip_s": fmean(run["clip_s"] for run in runs), "to_the_end": sum(run["fell_at_s"] is None for run in runs)}
    for name in SPREAD:
        values = [run[name] for run in runs if run[name] is not None]
        out[name] = {"mean": fmean(values), "spread": pstdev(values)} if values else None
    out["upright_s"]["worst"] = min(run["upright_s"] for run in runs)
    out["unexplained_force_max_n"] = max(run["unexplained_force_max_n"] for run in runs)
    return out


def totals(rows: Sequence[Row]) -> list[dict[str, Any]]:
    """For each character, strategy and IK method: performers and recordings apart; upright seconds of clip seconds over all runs.

    spread_s: standard deviation over the seeds of the sum over inputs, where every input has each seed. A failed run counts in `failed`
    only, since nobody knows how long it would have been.
    """
    kinds = gathered(rows, lambda r: ("performers" if r["input"].startswith("performer:") else "recordings",))
    entries = []
    for (kind,), of_kind in kinds.items():
        for (character, strategy, ik), runs in gathered(of_kind, lambda r: (r["character"], r["strategy"], r["ik"])).items():
            entries.append({"of": kind, "character": character, "strategy": strategy, "ik": ik, **_summed(runs)})
    return entries


def _summed(runs: Sequence[Row]) -> dict[str, Any]:
    good = [run for run in runs if "failed" not in run]
    by_seed = gathered(good, lambda r: (r["seed"],))
    sums = [sum(run["upright_s"] for run in seed_runs) for seed_runs in by_seed.values()]
    clip_s, upright_s = sum(run["clip_s"] for run in good), sum(run["upright_s"] for run in good)
    seeds = max(1, len(by_seed))
    return {
        "runs": len(good),
        "failed": len(runs) - len(good),
        "to_the_end": sum(run["fell_at_s"] is None for run in good),
        "upright_s": upright_s / seeds,
        "clip_s": clip_s / seeds,
        "share": upright_s / clip_s if clip_s > 0.0 else None,
        "spread_s": pstdev(sums) if sums else None,
        "worst_share": min((run["share"] for run in good), default=None),
        "unexplained_force_max_n": max((run["unexplained_force_max_n"] for run in good), default=None),
    }
