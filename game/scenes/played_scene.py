"""What scenes with characters share: who plays in which room, and when it is over."""

import numpy as np
from numpy.typing import NDArray

from game.characters.body_plan import BodyPlan
from game.scenes.depth_layer import depth_picture
from game.scenes.living_room import living_room
from game.scenes.simulation import Opener, Simulation
from game.tunables import Settings


class PlayedScene:
    """A scene in the living room whose first fighter follows the player's input. Entering makes `simulation`."""

    simulation: Simulation

    def __init__(self, plan: BodyPlan, opens: Opener, settings: Settings, seed: int = 0, input_name: str = "") -> None:
        self._plan, self._opens, self._settings = plan, opens, settings
        self._seed, self._input_name = seed, input_name
        self._room = living_room()
        self._entered = False

    @property
    def time_s(self) -> float:
        """Seconds since the release, negative in the hang."""
        return self.simulation.time_s

    @property
    def endless(self) -> bool:
        """True for a live input."""
        return self.simulation.fighters[0].source.length_s is None

    @property
    def finished(self) -> bool:
        """Whether the player's recording is at its end."""
        length = self.simulation.fighters[0].source.length_s
        return length is not None and self.time_s >= length

    @property
    def interrupted(self) -> str:
        """Why the game had better wait for the player's sensor, in words; empty while it need not."""
        return getattr(self.simulation.fighters[0].source, "interrupted", "")

    @property
    def depth_picture(self) -> NDArray[np.uint8] | None:
        """(h, w, 4) RGBA of what the player's depth camera sees; None where the input has none, or nobody wants to see it."""
        return depth_picture(self.simulation.fighters[0].source, self._settings)

    def leave(self) -> None:
        """Release the inputs. Calling it twice is harmless."""
        if self._entered:
            self.simulation.close()
            self._entered = False
