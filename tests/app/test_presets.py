"""A preset decides the method and nothing else."""

import pytest

from game.presets import LOOK_GROUPS, PRESETS, apply_preset, matching_preset, method_names
from game.tunables import TUNABLES, Settings, TunableError


@pytest.mark.parametrize("name", PRESETS)
def test_every_value_of_a_preset_is_valid_and_belongs_to_the_method(name: str) -> None:
    for tunable, value in PRESETS[name].items():
        assert TUNABLES[tunable].parse(value) == value
        assert TUNABLES[tunable].group not in LOOK_GROUPS


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_undoes_what_a_player_turned_in_the_method_but_not_in_the_picture(name: str) -> None:
    settings = Settings({"ik.damping": 1.1, "physics.friction": 0.3, "picture.exposure": 3.0, "layer.balance": True})
    apply_preset(settings, name)
    fresh = Settings()
    apply_preset(fresh, name)
    assert [settings.get(n) for n in method_names()] == [fresh.get(n) for n in method_names()]
    assert settings.number("picture.exposure") == 3.0
    assert settings.switch("layer.balance")
    assert matching_preset(settings) == name


def test_a_turned_number_matches_no_preset() -> None:
    assert matching_preset(Settings({"ik.damping": 0.77})) is None


def test_the_presets_differ() -> None:
    assert PRESETS["thesis"] != PRESETS["default"]
    settings = Settings()
    apply_preset(settings, "thesis")
    assert settings.as_dict() != Settings().as_dict()


def test_an_unknown_preset_lists_the_valid_ones() -> None:
    with pytest.raises(TunableError, match="default, thesis"):
        apply_preset(Settings(), "best")
