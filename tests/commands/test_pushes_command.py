"""Pushes as they are asked for on the command line, and single pushes of a whole simulation."""

import json
from pathlib import Path

import pytest
from PIL import Image

from game.commands import BAD_INPUT, DONE, main, pushes
from game.commands.push_case import FINE_NS, GRID_NS, PushCase, push_once, run_push_case
from game.commands.pushes import settings_from, summary
from game.report.polar_plot import EDGE, SIZE_PX, polar_plot
from game.tunables import Settings


def given(*words: str):
    import argparse

    parser = argparse.ArgumentParser()
    pushes.add_arguments(parser)
    return parser.parse_args(words)


SETTINGS = settings_from(given())


def test_it_is_measured_with_a_body_that_collides_with_itself():
    assert SETTINGS.switch("physics.self_collision") and not SETTINGS.switch("intake.mirror")


def test_a_light_push_is_recovered_from_and_one_of_a_car_is_not():
    light = push_once(PushCase("standing", "original", 90.0, 1), SETTINGS, 20.0, 0)
    assert light["outcome"] == "recovered" and light["steps"] == 0
    hard = push_once(PushCase("standing", "original", 90.0, 1), SETTINGS, 400.0, 0)
    assert hard["outcome"] not in ("", "recovered")
    for run in (light, hard):
        assert run["unexplained_force_n"] < 1e-6 and run["guard_actions"] == 0


def test_a_push_that_takes_steps_is_recovered_from_and_repeats_bit_by_bit():
    first, second = (push_once(PushCase("standing", "original", 180.0, 1), SETTINGS, 50.0, 0) for _ in range(2))
    assert first["outcome"] == "recovered" and 1 <= first["steps"] <= 3
    assert first["state_sha256"] == second["state_sha256"]


def test_every_smaller_push_must_be_recovered_from(monkeypatch: pytest.MonkeyPatch):
    """One gap in what is recovered from ends the count, however much more would be: 10 and 14 to 30, but not 12, is 10."""
    tried = []

    def pretend(case: PushCase, settings: Settings, impulse_ns: float, attempt: int):
        tried.append((impulse_ns, attempt))
        good = impulse_ns < 30.0 and not (attempt == 1 and impulse_ns in (20.0, 12.0))
        return {"impulse_ns": impulse_ns, "outcome": "recovered" if good else "trunk down", "unexplained_force_n": 0.0}

    monkeypatch.setattr("game.commands.push_case.push_once", pretend)
    row = run_push_case(PushCase("standing", "original", 0.0, 2), SETTINGS.as_dict())
    assert row["impulse_ns"] == GRID_NS and row["failure"] == "trunk down"
    assert tried == [(ns, attempt) for ns in (GRID_NS, 2 * GRID_NS, GRID_NS + FINE_NS) for attempt in range(2)]


def test_what_breaks_is_said_in_one_sentence_and_ends_with_bad_input(capsys: pytest.CaptureFixture[str]):
    assert main(["pushes", "--character", "nobody"]) == BAD_INPUT
    assert main(["pushes", "--tries", "0"]) == BAD_INPUT
    assert main(["pushes", "--report", "r.txt"]) == BAD_INPUT
    said = capsys.readouterr().err.strip().splitlines()
    assert len(said) == 3 and "nobody" in said[0] and "--tries" in said[1] and ".json" in said[2]
    assert "failed" in run_push_case(PushCase("standing", "nobody", 0.0, 1), SETTINGS.as_dict())


def test_report_and_plot_are_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    runs = [{"guard_actions": 0}]
    rows = [{"impulse_ns": 10.0 * k, "failure": "", "runs": runs, "unexplained_force_max_n": 0.0} for k in range(1, 9)]
    monkeypatch.setattr(pushes, "run_all", lambda *_: rows)
    assert main(["pushes", "--report", str(tmp_path / "p.json")]) == DONE
    report = json.loads((tmp_path / "p.json").read_text())
    assert report["mean_impulse_ns"] == 45.0 and report["worst_impulse_ns"] == 10.0
    assert report["per_direction_ns"] == [10.0 * k for k in range(1, 9)] == summary(rows)["per_direction_ns"]
    assert Image.open(tmp_path / "p.png").size == (SIZE_PX, SIZE_PX)


def test_the_plot_reaches_farthest_to_where_the_push_went(tmp_path: Path):
    """To the character's left is to the left of the picture, forward is up."""
    polar_plot(tmp_path / "p.png", "", [0.0, 90.0, 180.0, 270.0], [20.0, 100.0, 20.0, 20.0])
    picture = Image.open(tmp_path / "p.png").convert("RGB")
    edge = tuple(int(EDGE[k : k + 2], 16) for k in (1, 3, 5))
    found = [(x, y) for x in range(SIZE_PX) for y in range(SIZE_PX) if picture.getpixel((x, y)) == edge]
    left, right = SIZE_PX / 2 - min(x for x, _ in found), max(x for x, _ in found) - SIZE_PX / 2
    assert left > 3.0 * right > 0.0
