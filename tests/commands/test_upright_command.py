"""The upright table as it is asked for on the command line: what is played, in parallel, and what happens to what cannot be played."""

import json
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from game.commands import BAD_INPUT, DONE, BadInput, main
from game.commands.parallel import run_all
from game.commands.upright import inputs_from, seeds_from
from game.commands.upright_case import Case, run_case
from game.tunables import Settings
from kinect.clip import write_clip
from tests.kinect.recordings import moving_clip


@pytest.fixture(scope="module")
def clips(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a good recording and a broken one."""
    folder = tmp_path_factory.mktemp("clips")
    write_clip(folder / "good.npz", moving_clip())
    (folder / "torn.npz").write_bytes(b"PK no recording")
    return folder


def measured(folder: Path, *words: str) -> tuple[int, dict[str, Any]]:
    status = main(["upright", *words, "--report", str(folder / "r.json")])
    return status, json.loads((folder / "r.json").read_text())


def untimed(row: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in row.items() if key != "timing"}


def test_a_broken_recording_is_a_failed_row_and_the_others_are_measured(
    clips: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, report = measured(tmp_path, "--inputs", str(clips / "*.npz"), "--strategies", "none", "ankle", "--jobs", "1")
    shown = capsys.readouterr().out
    assert status == BAD_INPUT
    assert [("failed" in row, row["strategy"]) for row in report["runs"]] == [
        (False, "none"),
        (False, "ankle"),
        (True, "none"),
        (True, "ankle"),
    ]
    assert "torn.npz" in report["runs"][2]["failed"] and report["runs"][2]["failed"].count(". ") == 0
    assert "failed: torn.npz" in shown and "good.npz" in shown
    good = report["runs"][0]
    assert 0.0 < good["upright_s"] <= good["clip_s"] and good["unexplained_force_max_n"] < 1e-6
    assert [entry["failed"] for entry in report["totals"]] == [1, 1]


def test_the_table_is_the_same_however_many_processes_play_it(clips: Path) -> None:
    cases = [Case(f"clip:{clips / 'good.npz'}", character, "none", "dls") for character in ("original", "human")]
    work = partial(run_case, values=Settings().as_dict(), whole=False)
    one, two = (run_all(work, cases, jobs, lambda case: {}) for jobs in (1, 2))
    assert list(map(untimed, one)) == list(map(untimed, two))
    assert one[0]["state_sha256"] != one[1]["state_sha256"]


def test_a_run_ends_with_its_fall_unless_the_whole_is_asked_for() -> None:
    values = {**Settings().as_dict(), "sensor.noise": 1.0}
    case = Case("performer:jump", "original", "none", "dls", 0)
    cut, whole = (run_case(case, values, whole) for whole in (False, True))
    assert cut["fell_at_s"] is not None and cut["fell_at_s"] == whole["fell_at_s"] and cut["upright_s"] == whole["upright_s"]
    assert cut["state_sha256"] != whole["state_sha256"]
    assert cut["clip_s"] == 21.2
    assert cut["share"] == pytest.approx(cut["upright_s"] / 21.2)


def test_what_breaks_in_a_run_is_told_in_its_row(monkeypatch: pytest.MonkeyPatch) -> None:
    def burst(self: object) -> None:
        raise ZeroDivisionError("by a tired solver")

    monkeypatch.setattr("game.scenes.simulation.Simulation.advance", burst)
    row = run_case(Case("performer:standing", "original", "none", "dls", 0), Settings().as_dict(), False)
    assert row["failed"] == "performer:standing broke off: ZeroDivisionError: by a tired solver"
    assert "burst" in str(row["traceback"])


def test_an_input_without_end_has_no_share_upright() -> None:
    row = run_case(Case("puppet", "original", "none", "dls", 0), Settings().as_dict(), False)
    assert "never ends" in str(row["failed"])


def test_a_recording_is_played_once_and_a_performer_with_every_seed(clips: Path, tmp_path: Path) -> None:
    words = ("--inputs", str(clips / "good.npz"), "performer:standing", "--seeds", "3-4", "--strategies", "none", "--noise", "1")
    status, report = measured(tmp_path, *words, "--ik", "none")
    assert status == DONE
    assert [(Path(row["input"]).name, row["seed"]) for row in report["runs"]] == [
        ("good.npz", None),
        *(("performer:standing", s) for s in (3, 4)),
    ]
    assert report["settings"]["sensor.noise"] == 1.0 and report["settings"]["intake.mirror"] is False
    assert report["runs"][1]["state_sha256"] != report["runs"][2]["state_sha256"]


def dies(case: str) -> str:
    if case == "dies":
        import os

        os._exit(1)
    return case.upper()


def test_a_process_that_dies_loses_its_case_and_not_the_table() -> None:
    assert run_all(dies, ["a", "dies"], 1, lambda case: f"lost {case}") == ["A", "lost dies"]


def test_seeds_are_a_number_or_a_range() -> None:
    assert seeds_from("3") == [0, 1, 2]
    assert seeds_from("10-12") == [10, 11, 12]
    assert seeds_from("7-7") == [7]
    for nonsense in ("0", "-3", "5-4", "x", "1.5", "1-99999999", ""):
        with pytest.raises(BadInput, match="such as 10-19"):
            seeds_from(nonsense)


def test_inputs_are_found_by_pattern_and_each_is_played_once(clips: Path) -> None:
    found = inputs_from([str(clips / "*.npz"), str(clips / "good.npz"), "performer:boxing"], performers=False)
    assert found == [f"clip:{clips / 'good.npz'}", f"clip:{clips / 'torn.npz'}", "performer:boxing"]
    assert len(inputs_from(["performer:boxing"], performers=True)) == 8


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("--inputs", "nowhere/*.npz"), "nowhere/*.npz"),
        (("--characters", "giraffe"), "giraffe"),
        (("--strategies", "prayer"), "prayer"),
        (("--ik", "luck"), "luck"),
        (("--noise", "loud"), "loud"),
        (("--set", "ik.damping"), "NAME=VALUE"),
        (("--jobs", "0"), "--jobs"),
        (("--seeds", "none"), "--seeds"),
    ],
)
def test_what_cannot_be_asked_for_is_one_sentence(words: tuple[str, ...], named: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["upright", *words]) == BAD_INPUT
    said = capsys.readouterr().err
    assert said.startswith("topple: ") and said.count("\n") == 1 and named in said
