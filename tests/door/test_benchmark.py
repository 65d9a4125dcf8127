"""The benchmark's table says what was measured and whether the goals are met. Nothing here is timed."""

from pathlib import Path
from typing import Any

import pytest

from game.commands import BAD_INPUT, main
from game.commands.benchmark import as_text, part, table


def figures(**other: Any) -> dict[str, Any]:
    stages = {"target": 0.9, "control": 0.5, "physics": 0.5}
    start_included = {"from_start_real_time_factor": 3.0, "entering_s": 0.08}
    start = {"start_s": 2.9}
    shown = {"frames_per_s": 15.5}
    return {
        "chain_mirror": {"real_time_factor": 10.5, "ms_per_frame": stages, **start_included},
        "chain_noisy": {"real_time_factor": 10.1, "ms_per_frame": stages, **start_included},
        "chain_duel": {"real_time_factor": 4.0, "ms_per_frame": stages, **start_included},
        "drawing": {"render_ms": 0.8, "posing_ms": 0.2},
        "headless_mirror": shown,
        "headless_duel": shown,
        "start": start,
        "kinect_reader": {"core_share": 0.12},
        **other,
    }


def test_goals_are_met_on_their_own_side() -> None:
    assert {row.what: row.met for row in table(figures()) if row.goal is not None} == {
        "chain, one character, steady": True,
        "chain, the same, sensor model at scale 1": True,
        "target, one character": True,
        "Python side of drawing, two fighters": True,
        "headless 640x360 low, one character": True,
        "headless 640x360 low, duel": True,
        "start to first frame, warm": True,
        "reading a simulated Kinect": True,
    }
    slow = figures(drawing={"render_ms": 1.2, "posing_ms": 0.2}, start={"start_s": 3.1}, headless_duel={"frames_per_s": 14.0})
    assert [row.what for row in table(slow) if row.met is False] == [
        "Python side of drawing, two fighters",
        "headless 640x360 low, duel",
        "start to first frame, warm",
    ]


def test_a_machine_that_cannot_draw_says_so_in_the_table() -> None:
    reason = {"no_picture": "There is no OpenGL 3.3 here."}
    rows = table(figures(drawing=reason, headless_mirror=reason, headless_duel=reason, start=reason))
    text = as_text(rows)
    assert text.count("no picture here") == 5
    assert "10.50 x real time" in text and "80.00 ms" in text and "met" in text and "missed" not in text


def test_the_chain_is_measured_in_a_process_of_its_own() -> None:
    measured = part("chain", "mirror", "0.1", "sensor.noise=1", environment={"OMP_NUM_THREADS": "1"})
    assert measured["real_time_factor"] > 0.0 and len(measured["runs"]) == 5
    assert measured["from_start_real_time_factor"] > 0.0 and measured["entering_s"] > 0.0
    assert measured["settings"] == {"sensor.noise": "1"}
    assert set(measured["ms_per_frame"]) == {"target", "control", "physics"}
    with pytest.raises(RuntimeError, match="part chain circus"):
        part("chain", "circus", "0.1")


def test_bad_arguments_are_one_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "plain.txt").write_text("")
    for words in (("--seconds", "0"), ("--seconds", "nan"), ("--report", str(tmp_path / "plain.txt" / "r.json"))):
        assert main(["benchmark", *words]) == BAD_INPUT
        said = capsys.readouterr().err
        assert said.startswith("topple: ") and said.count("\n") == 1
