"""Assets are found in the checkout and in an installed wheel, and a wrong name says what lies there."""

import pytest

from game.assets import asset, assets_folder


def test_the_original_character_is_an_asset() -> None:
    assert asset("characters/original.toml").is_file()


def test_a_missing_asset_names_itself_and_its_neighbours() -> None:
    with pytest.raises(FileNotFoundError, match=r"no asset 'characters/giant\.toml'.*original\.toml"):
        asset("characters/giant.toml")


def test_every_font_and_sound_says_where_it_comes_from() -> None:
    folders = [folder for folder in assets_folder().iterdir() if folder.is_dir() and folder.name != "characters"]
    assert [folder.name for folder in folders if not (folder / "README.md").is_file()] == []
