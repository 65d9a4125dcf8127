"""What the upright table makes of single runs: means over seeds, sums over inputs, the thesis beside them."""

from typing import Any

import pytest

from game.report.thesis_tables import CLIP_S, TABLE_3, TABLE_4, beside_the_thesis
from game.report.upright_table import SPREAD, over_seeds, totals
from game.report.upright_text import as_text


def row(spec: str, upright_s: float, clip_s: float = 10.0, seed: int | None = 0, **other: Any) -> dict[str, Any]:
    who = {"input": spec, "character": "original", "strategy": "ankle", "ik": "dls", "seed": seed}
    measures = dict.fromkeys(SPREAD, 0.02) | {"upright_s": upright_s, "clip_s": clip_s, "share": upright_s / clip_s}
    fell = {"fell_at_s": None if upright_s == clip_s else upright_s, "unexplained_force_max_n": 1e-9}
    return {**who, **measures, **fell, **other}


def test_seeds_are_averaged_and_their_spread_told() -> None:
    (entry,) = over_seeds([row("performer:jump", 4.0, seed=0), row("performer:jump", 10.0, seed=1, unexplained_force_max_n=1e-3)])
    assert entry["upright_s"] == {"mean": 7.0, "spread": 3.0, "worst": 4.0}
    assert entry["share"]["mean"] == pytest.approx(0.7)
    assert (entry["runs"], entry["to_the_end"]) == (2, 1)
    assert entry["unexplained_force_max_n"] == 1e-3


def test_sums_go_over_inputs_and_spread_over_seeds() -> None:
    runs = [
        row(f"performer:{name}", upright, seed=seed) for name, seed, upright in (("jump", 0, 4.0), ("jump", 1, 6.0), ("bowing", 0, 10.0))
    ]
    runs += [row("performer:bowing", 10.0, seed=1), row("clip:a.npz", 3.0, 5.0, None)]
    performers, recordings = totals(runs)
    assert (performers["of"], performers["upright_s"], performers["clip_s"], performers["spread_s"]) == ("performers", 15.0, 20.0, 1.0)
    assert performers["share"] == pytest.approx(0.75) and performers["worst_share"] == pytest.approx(0.4)
    assert (recordings["of"], recordings["upright_s"], recordings["share"]) == ("recordings", 3.0, pytest.approx(0.6))


def test_a_failed_run_is_counted_and_adds_no_seconds() -> None:
    broken = {"input": "clip:b.npz", "character": "original", "strategy": "ankle", "ik": "dls", "seed": None, "failed": "b.npz: torn."}
    (sums,) = totals([row("clip:a.npz", 3.0, 5.0, None), broken])
    assert (sums["runs"], sums["failed"], sums["clip_s"]) == (1, 1, 5.0)
    text = as_text(over_seeds([broken]), totals([broken]), {})
    assert "failed: b.npz: torn." in text and "every run failed" in text


def test_our_seconds_stand_under_the_thesis_column_that_they_belong_to() -> None:
    runs = [
        row(f"performer:{name}", length, length, strategy=s, ik=ik)
        for name, length in CLIP_S.items()
        for s in ("none", "ankle")
        for ik in ("none", "dls")
    ]
    runs.append(row("clip:a.npz", 1.0))
    runs += [row("performer:jump", 5.3, 21.2, seed=s, character="low-com") for s in (0, 1)]
    table_3 = {entry["column"]: entry for entry in beside_the_thesis(TABLE_3, runs)}
    assert {name: entry["thesis_s"] for name, entry in table_3.items()} == {
        "no IK, no BC": 112.2,
        "IK, no BC": 112.9,
        "no IK, BC": 128.4,
        "IK, BC": 128.1,
    }
    assert all(len(entry["ours"]) == 1 for entry in table_3.values())
    assert table_3["no IK, BC"]["ours"]["ankle"] == {
        "upright_s": pytest.approx(137.7),
        "of_s": pytest.approx(137.7),
        "share": 1.0,
        "clips": 8,
    }
    table_4 = {entry["column"]: entry for entry in beside_the_thesis(TABLE_4, runs)}
    assert table_4["lower COM"]["ours"] == {"ankle": {"upright_s": 5.3, "of_s": 21.2, "share": pytest.approx(0.25), "clips": 1}}
    assert table_4["asymmetric"]["ours"] == {} and table_4["weight distribution"]["thesis_s"] == 42.4
    text = as_text(over_seeds(runs), totals(runs), {"Table 4": list(table_4.values())})
    assert "128.1 (92.2 %)" in text and "137.7 (100.0 %)" in text and "5.3 (25.0 %) 1 clips" in text
