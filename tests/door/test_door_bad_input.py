"""Whatever a user gives that cannot be used ends with status 2 and one sentence that names it, before anything is simulated."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from game.commands import BAD_INPUT, main
from tests.door.the_door import knock, without_compiling
from tests.kinect.recordings import moving_clip, raw_fields

Outcome = tuple[int, str]


@pytest.fixture
def refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., Outcome]:
    """Runs a command line in a folder with broken things in it; gives its status and what it said on stderr."""
    monkeypatch.chdir(tmp_path)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    Path("folder").mkdir()
    Path("plain.txt").write_text("a file, no folder")
    Path("junk.npz").write_text("junk")
    Path("junk.csv").write_text("1,2,3\nx\n")
    Path("junk.toml").write_text("{}")
    Path("hollow.toml").write_text("based_on = 'nobody'\n")
    fields = raw_fields(moving_clip())
    np.savez("nobody.npz", positions=np.full_like(fields["positions"], np.nan), confidence=fields["confidence"], t=fields["t"])
    np.savez("short.npz", positions=fields["positions"])

    def run(*words: str) -> Outcome:
        try:
            status = main(words)
        except SystemExit as left:
            status = int(str(left.code))
        said = capsys.readouterr()
        assert said.out == "", "nothing may have begun"
        return status, without_compiling(said.err)

    return run


NO_DRAW = ("--no-draw", "--seconds", "0.1")
HEADLESS = ("--headless", "--seconds", "0.1", "--input", "performer:standing")

SENTENCES = {
    "no such recording": ((*NO_DRAW, "--input", "clip:nowhere.npz"), "nowhere.npz"),
    "a recording that is no archive": ((*NO_DRAW, "--input", "clip:junk.npz"), "junk.npz"),
    "a table with three columns": ((*NO_DRAW, "--input", "clip:junk.csv"), "junk.csv"),
    "a recording without its times": ((*NO_DRAW, "--input", "clip:short.npz"), "short.npz"),
    "a recording in which nobody is": ((*NO_DRAW, "--input", "clip:nobody.npz"), "nobody.npz"),
    "a folder as recording": ((*NO_DRAW, "--input", "clip:folder"), "folder"),
    "no path of the recording": ((*NO_DRAW, "--input", "clip:"), "clip:PATH"),
    "an unknown kind of input": ((*NO_DRAW, "--input", "ghost"), "ghost"),
    "an unknown performer": ((*NO_DRAW, "--input", "performer:nobody"), "waving"),
    "an unknown character": ((*NO_DRAW, "--character", "nobody"), "low-com"),
    "a character that is no TOML": ((*NO_DRAW, "--character", "junk.toml"), "junk.toml"),
    "a character based on nobody": ((*NO_DRAW, "--character", "hollow.toml"), "'nobody'"),
    "an unknown tunable": ((*NO_DRAW, "--set", "ik.nothing=1"), "ik.damping"),
    "a number out of range": ((*NO_DRAW, "--set", "ik.damping=7"), "1.2"),
    "a word for a number": ((*NO_DRAW, "--set", "ik.damping=much"), "'much'"),
    "NaN for a number": ((*NO_DRAW, "--set", "ik.damping=nan"), "'nan'"),
    "a number for a choice": ((*NO_DRAW, "--set", "ik.method=3"), "sdls"),
    "a setting without a value": ((*NO_DRAW, "--set", "ik.damping"), "NAME=VALUE"),
    "an unknown balance": ((*NO_DRAW, "--balance", "wings"), "ankle"),
    "an unknown inverse": ((*NO_DRAW, "--ik", "magic"), "pseudoinverse"),
    "a size in one number": ((*NO_DRAW, "--size", "640"), "'640'"),
    "a size of nothing": ((*NO_DRAW, "--size", "0x0"), "'0x0'"),
    "a size beyond any screen": ((*NO_DRAW, "--size", "99999x99999"), "7680x4320"),
    "no seconds": (("--no-draw", "--seconds", "0"), "86400"),
    "seconds that are no number": (("--no-draw", "--seconds", "nan"), "86400"),
    "a seed below zero": ((*NO_DRAW, "--seed", "-1"), "-1"),
    "a picture of a run without pictures": ((*NO_DRAW, "--picture", "a.png"), "--no-draw"),
    "a folder as report": ((*NO_DRAW, "--report", "folder"), "folder"),
    "a report below a file": ((*NO_DRAW, "--report", "plain.txt/report.json"), "report.json"),
    "a picture of an unknown kind": ((*HEADLESS, "--picture", "a.xyz"), ".png"),
    "a video of an unknown kind": ((*HEADLESS, "--video", "a.avi"), ".mp4"),
    "a video below a file": ((*HEADLESS, "--video", "plain.txt/a.mp4"), "a.mp4"),
}


@pytest.mark.parametrize("case", SENTENCES)
def test_bad_input_is_one_sentence_that_names_it(refused: Callable[..., Outcome], case: str) -> None:
    words, named = SENTENCES[case]
    status, said = refused(*words)
    assert status == BAD_INPUT
    assert said.startswith("topple: ")
    assert said.count("\n") == 1 and said.endswith(".\n")
    assert named in said


@pytest.mark.parametrize(
    "words", [("--scene", "circus"), ("--preset", "magic"), ("--quality", "best"), ("--seconds", "long"), ("--seed", "x"), ("juggle",)]
)
def test_a_word_the_command_line_does_not_know_is_refused_with_its_usage(refused: Callable[..., Outcome], words: tuple[str, ...]) -> None:
    status, said = refused(*words)
    assert status == BAD_INPUT
    assert words[-1] in said.splitlines()[-1]


def test_what_is_refused_leaves_no_file_behind(refused: Callable[..., Outcome]) -> None:
    before = sorted(Path().rglob("*"))
    assert refused(*NO_DRAW, "--report", "report.json", "--input", "clip:nobody.npz")[0] == BAD_INPUT
    assert refused(*HEADLESS, "--picture", "a.png", "--video", "a.avi")[0] == BAD_INPUT
    assert sorted(Path().rglob("*")) == before


def test_the_door_itself_says_one_sentence_and_shows_no_traceback(tmp_path: Path) -> None:
    (tmp_path / "junk.npz").write_text("junk")
    for words in (("--no-draw", "--input", "clip:junk.npz"), ("--headless", "--video", "plain/a.avi")):
        visit = knock(tmp_path, *words)
        assert visit.status == BAD_INPUT
        assert visit.out == "" and visit.err.startswith("topple: ") and visit.err.count("\n") == 1


def test_a_display_that_does_not_answer_is_bad_input_too(tmp_path: Path) -> None:
    visit = knock(tmp_path, "--seconds", "0.1", "--size", "64x64", "--input", "performer:standing", DISPLAY=":77")
    assert visit.status == BAD_INPUT
    assert visit.err.startswith("topple: No window can be opened") and visit.err.count("\n") == 1
    assert "--headless" in visit.err
