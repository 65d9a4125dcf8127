"""The pages speak of what is there: links, commands and names of tunables."""

import re
from pathlib import Path

import pytest

from game.commands import main
from game.tunables import TUNABLES

ROOT = Path(__file__).resolve().parents[2]
PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), *(ROOT / "assets").rglob("*.md")]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_into_the_project_leads_somewhere(page: Path) -> None:
    links = re.findall(r"\]\(([^)#]+)", page.read_text(encoding="utf-8"))
    assert [link for link in links if "://" not in link and not (page.parent / link).exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_tunable_that_a_page_names_exists(page: Path) -> None:
    groups = "|".join({tunable.group for tunable in TUNABLES.values()})
    named = re.findall(rf"(?:`|--set )((?:{groups})\.[a-z_]+)", page.read_text(encoding="utf-8"))
    assert [name for name in named if name not in TUNABLES] == []


def test_the_build_machine_runs_the_test_command_of_the_readme() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    command = re.search(r"\| Linux \| `[^`]+` \| `([^`]+)` \|", readme)
    assert command
    assert command.group(1) in (ROOT / ".ci" / "run").read_text(encoding="utf-8").splitlines()[-1]


def test_every_script_that_a_page_names_exists() -> None:
    named = {name for page in PAGES for name in re.findall(r"scripts/\w+\.\w+", page.read_text(encoding="utf-8"))}
    assert named
    assert [name for name in named if not (ROOT / name).is_file()] == []


def test_the_readme_names_only_options_that_the_command_line_knows(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--help"])
    known = set(re.findall(r"--[a-z-]+", capsys.readouterr().out))
    starts = re.findall(r"scripts/play\.sh (.*)", (ROOT / "README.md").read_text(encoding="utf-8"))
    named = set(re.findall(r"--[a-z][a-z-]+", " ".join(starts)))
    assert len(named) > 5
    assert named <= known
