"""The live plots of a duel: how the two stand, and what they do to each other."""

from collections import deque

import numpy as np

from game.physics.contacts import FLOOR
from game.scenes.scene import Plot
from game.scenes.simulation import Simulation

WINDOW_FRAMES = 600


class DuelPlots:
    """Remembers the last ten seconds."""

    def __init__(self) -> None:
        self._rows: deque[tuple[float, ...]] = deque(maxlen=WINDOW_FRAMES)

    def observe(self, simulation: Simulation) -> None:
        world = simulation.world
        found = world.meter.contacts
        shove = 0.0
        if found is not None:
            between = (found.character != FLOOR).all(axis=1)
            shove = float(np.linalg.norm(found.force[between].sum(axis=0))) if between.any() else 0.0
        a, b = world.characters
        self._rows.append((simulation.clock_s, a.com_height(), b.com_height(), shove, *a.com[:2], *b.com[:2]))

    def plots(self) -> tuple[Plot, ...]:
        if not self._rows:
            return ()
        t, height_a, height_b, shove, ax, ay, bx, by = np.array(self._rows).T
        return (
            Plot("the two COMs, from above", "m", {"you": (-ay, ax), "opponent": (-by, bx)}, kind="plan"),
            Plot("COM height", "m", {"you": (t, height_a), "opponent": (t, height_b)}),
            Plot("force between the two", "N", {"force": (t, shove)}),
        )
