"""Settings survive the disk, and a broken file costs one sentence and no data."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game import settings_file
from game.tunables import TUNABLES, Settings


def values_of(name: str) -> st.SearchStrategy[object]:
    tunable = TUNABLES[name]
    if isinstance(tunable.default, bool):
        return st.booleans()
    if tunable.choices:
        return st.sampled_from(tunable.choices)
    return st.floats(tunable.low, tunable.high)


@given(st.fixed_dictionaries({}, optional={name: values_of(name) for name in TUNABLES}))
def test_what_is_saved_comes_back_exactly(tmp_path_factory: pytest.TempPathFactory, values: dict[str, object]) -> None:
    path = tmp_path_factory.mktemp("settings") / "folder" / "settings.toml"
    written, read = Settings(values), Settings()
    settings_file.save(written, path)
    assert settings_file.load(read, path) == ()
    assert read.as_dict() == written.as_dict()


def test_no_file_is_no_complaint(tmp_path: Path) -> None:
    assert settings_file.load(Settings(), tmp_path / "none.toml") == ()


def test_an_entry_that_cannot_be_used_costs_one_sentence_and_the_rest_is_loaded(tmp_path: Path) -> None:
    path = tmp_path / "settings.toml"
    path.write_text('[balance]\nw_vel = 0.7\nw_magic = 1\nankle_clamp_rad = 99\n[ik]\nmethod = "guess"\ndamping = 0.2\n', encoding="utf-8")
    settings = Settings()
    complaints = settings_file.load(settings, path)
    assert (settings.number("balance.w_vel"), settings.number("ik.damping")) == (0.7, 0.2)
    assert settings.choice("ik.method") == TUNABLES["ik.method"].default
    assert len(complaints) == 3
    for name, sentence in zip(("balance.w_magic", "balance.ankle_clamp_rad", "ik.method"), complaints):
        assert name in sentence
        assert str(path) in sentence
        assert "\n" not in sentence


@pytest.mark.parametrize("content", [b"[balance\nw_vel", b"\xff\xfe\x00", b"balance = 3\n", b"[[balance]]\nw_vel = 1\n"])
def test_a_broken_file_is_one_sentence_and_saving_keeps_it_beside_the_new_one(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "settings.toml"
    path.write_bytes(content)
    settings = Settings({"ik.damping": 0.9})
    assert len(settings_file.load(settings, path)) == 1
    assert settings.number("ik.damping") == 0.9
    said = settings_file.save(settings, path)
    assert (tmp_path / "settings.toml.bak").read_bytes() == content
    assert "settings.toml.bak" in said
    path.write_bytes(b"broken again [")
    settings_file.save(settings, path)
    assert (tmp_path / "settings.toml.bak").read_bytes() == content
    assert (tmp_path / "settings.toml.bak2").read_bytes() == b"broken again ["
    assert settings_file.load(Settings(), path) == ()


def test_a_folder_in_the_place_of_the_file_is_a_sentence(tmp_path: Path) -> None:
    assert "cannot be read" in settings_file.load(Settings(), tmp_path)[0]


def test_the_file_lies_in_the_platforms_own_folder_for_the_game() -> None:
    assert settings_file.default_path().name == "settings.toml"
    assert settings_file.default_path().parent.name == "topple"
