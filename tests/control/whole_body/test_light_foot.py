"""A foot that stood but carried nothing takes up its load with an ankle that eases into its work."""

import numpy as np
import pytest

from game.characters.skeleton import JOINTS
from game.commands.getup_case import GetupCase, shove_once
from game.control.whole_body import light_foot
from game.control.whole_body.light_foot import EASED, LIGHT_N, eased
from game.tunables import Settings

LEFT, RIGHT = 0, 1
STRENGTH = np.arange(84.0).reshape(2, 42) + 1.0
ANKLE = {
    side: slice(3 * JOINTS.index(f"ankle_{name}"), 3 * JOINTS.index(f"ankle_{name}") + 3) for side, name in enumerate(("left", "right"))
}


@pytest.mark.parametrize("side", [LEFT, RIGHT])
def test_only_the_ankle_of_the_foot_that_carried_nothing_is_eased(side):
    out = eased(STRENGTH, (LEFT, RIGHT), {side: 0.5 * LIGHT_N, 1 - side: 400.0})
    np.testing.assert_allclose(out[:, ANKLE[side]], EASED * STRENGTH[:, ANKLE[side]])
    others = np.ones(42, dtype=bool)
    others[ANKLE[side]] = False
    np.testing.assert_array_equal(out[:, others], STRENGTH[:, others])


def test_feet_that_carry_and_feet_that_land_have_their_whole_strength():
    assert eased(STRENGTH, (LEFT, RIGHT), {LEFT: 400.0, RIGHT: 2.0 * LIGHT_N}) is STRENGTH
    assert eased(STRENGTH, (LEFT, RIGHT), {LEFT: 400.0}) is STRENGTH
    assert eased(STRENGTH, (LEFT,), {LEFT: 400.0, RIGHT: 0.0}) is STRENGTH


def test_a_shove_that_unloads_a_foot_does_not_drive_it_into_the_floor(monkeypatch):
    """The left foot carries nothing for two ticks and is then planned to carry all: with its whole ankle it goes 3 cm into the floor."""
    case, settings = GetupCase("human", 7, 8500), Settings({"physics.self_collision": True})
    assert shove_once(case, settings)["deep_m"] < 0.018
    monkeypatch.setattr(light_foot, "EASED", 1.0)
    assert shove_once(case, settings)["deep_m"] > 0.025
