"""Falls and getting up as they are asked for on the command line, and single shoves of a whole simulation."""

import json
from pathlib import Path

import pytest

from game.commands import BAD_INPUT, DONE, main
from game.commands.getup_case import GetupCase, run_getup_case, shove_once
from game.commands.getups import SOON_S, summary
from game.tunables import Settings

COLLIDING = Settings({"physics.self_collision": True, "intake.mirror": False})


@pytest.mark.slow
def test_a_body_that_was_shoved_over_stands_again_by_its_own_torques_and_repeats_bit_by_bit():
    first, second = (shove_once(GetupCase("original", 0, 5), COLLIDING) for _ in range(2))
    assert first["fell"] and first["up_s"] is not None and first["up_s"] < 10.0 and first["tries"] >= 1
    assert first["unexplained_force_n"] < 1e-6 and first["guard_actions"] == 0
    assert first["state_sha256"] == second["state_sha256"]


def test_a_body_that_may_not_get_up_stays_where_it_lies(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("game.commands.getup_case.WATCHED_S", 5.0)
    row = shove_once(GetupCase("original", 0, 5), Settings(COLLIDING.as_dict() | {"whole_body.get_up": False}))
    assert row["fell"] and row["up_s"] is None and row["tries"] == 0


def fallen(up_s, tries=1, fast=(3.0, 5.0), past=4.0):
    return {
        "fell": True, "up_s": up_s, "tries": tries, "fast_rad_s": list(fast), "past_deg": past, "deep_m": 0.004,
        "unexplained_force_n": 1e-10, "guard_actions": 0,
    }  # fmt: skip


def test_the_summary_counts_shoves_and_takes_the_worst_of_all_falls():
    stood = fallen(0.1, tries=0) | {"fell": False}
    sums = summary([fallen(3.0), fallen(SOON_S + 2.0, tries=2, fast=(1.0, 9.0), past=8.0), fallen(None, tries=4), stood])
    assert (sums["shoves"], sums["fell"]) == (4, 3)
    assert (sums["up_share"], sums["up_soon_share"], sums["one_try_share"]) == (0.75, 0.5, 0.5)
    assert sums["up_median_s"] == 3.0 and sums["past_max_deg"] == 8.0
    assert 5.0 < sums["fast_p99_rad_s"] <= 9.0


def test_a_shove_that_breaks_off_says_which():
    row = run_getup_case(GetupCase("nobody", 7, 0), COLLIDING.as_dict())
    assert "shove 7 broke off" in row["failed"] and "nobody" in row["failed"]


@pytest.mark.slow
def test_the_command_writes_what_it_measured(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    report = tmp_path / "falls.json"
    assert main(["getups", "--falls", "1", "--seed", "5", "--jobs", "1", "--report", str(report)]) == DONE
    written = json.loads(report.read_text())
    assert written["shoves"][0]["number"] == 0 and written["asked"] == {"character": "original", "falls": 1, "seed": 5}
    assert "back on both feet" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "names"),
    [
        (["--falls", "0"], "--falls"),
        (["--character", "nobody"], "nobody"),
        (["--report", "falls.txt"], ".json"),
        (["--seed", "-1"], "--seed"),
    ],
)
def test_bad_input_gets_one_sentence(words, names, capsys: pytest.CaptureFixture[str]):
    assert main(["getups", *words]) == BAD_INPUT
    said = capsys.readouterr().err.strip()
    assert names in said and "\n" not in said
