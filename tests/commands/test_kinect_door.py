"""The command `kinect` and the input `kinect` at the door."""

from pathlib import Path

import pytest

from game.commands import BAD_INPUT, main
from game.commands.kinect import PARTS
from tests.door.the_door import knock, read_report


def test_without_a_part_it_names_those_there_are(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["kinect"])
    assert left.value.code == BAD_INPUT
    assert "doctor|install-rules|record" in capsys.readouterr().err


@pytest.mark.parametrize("part", PARTS)
def test_each_part_explains_itself(part: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["kinect", part, "--help"])
    assert left.value.code == 0
    assert f"topple kinect {part}" in capsys.readouterr().out


def test_the_game_plays_and_ends_with_the_input_kinect_whatever_is_attached(tmp_path: Path) -> None:
    visit = knock(tmp_path, "--no-draw", "--input", "kinect", "--seconds", "0.5", "--report", "report.json")
    assert visit.status == 0 and visit.err == ""
    assert read_report(tmp_path / "report.json")["input"] == "kinect"


def test_a_recorded_room_plays_as_an_input(tmp_path: Path) -> None:
    assert knock(tmp_path, "kinect", "record", "room", "--simulate", "room", "--seconds", "1").status == 0
    visit = knock(tmp_path, "--no-draw", "--input", "kinect-replay:room", "--report", "report.json")
    assert visit.status == 0 and visit.err == ""
    assert 0.3 < read_report(tmp_path / "report.json")["clip_s"] < 1.2
