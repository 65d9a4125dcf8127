"""docs/tunables.md is what game/tunables.py declares."""

import importlib.util
from pathlib import Path

from game.tunables import TUNABLES

ROOT = Path(__file__).resolve().parents[2]


def written_page() -> str:
    spec = importlib.util.spec_from_file_location("write_tunables_doc", ROOT / "scripts" / "write_tunables_doc.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.page()


def test_the_page_is_up_to_date() -> None:
    page = (ROOT / "docs" / "tunables.md").read_text(encoding="utf-8")
    assert page == written_page(), "docs/tunables.md is old: run python scripts/write_tunables_doc.py"


def test_every_tunable_stands_on_the_page_once() -> None:
    page = (ROOT / "docs" / "tunables.md").read_text(encoding="utf-8")
    assert [name for name in TUNABLES if page.count(f"| `{name}`") != 1] == []
