"""The scenes by name: adding one is one module and one line."""

from collections.abc import Callable, Mapping
from typing import Protocol

from game.characters.body_plan import BodyPlan
from game.scenes.duel import Duel
from game.scenes.mirror import Mirror
from game.scenes.scene import Scene
from game.scenes.simulation import Opener
from game.tunables import Settings


class PlayableScene(Scene, Protocol):
    """A scene that also reports on itself."""

    @property
    def endless(self) -> bool:
        """True where nothing but the player ends it."""
        ...

    def report(self) -> dict[str, object]:
        """Everything that was measured, ready for JSON."""
        ...


SceneMaker = Callable[[BodyPlan, Opener, Settings, int, str], PlayableScene]
"""(character of the player, input, settings, seed, the input's name) -> scene."""

SCENES: Mapping[str, SceneMaker] = {
    "mirror": Mirror,
    "duel": Duel,
}
