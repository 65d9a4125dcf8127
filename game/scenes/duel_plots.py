"""The live plots of a duel: how you keep your balance, where the opponent stands, and what the two do to each other."""

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import PART_COUNT
from game.compiled import compiled
from game.scenes.balance_history import BalanceHistory
from game.scenes.balance_plots import BalancePlots, from_above, sole_outline
from game.scenes.history import FRAMES_PER_SAMPLE, History
from game.scenes.scene import Plot
from game.scenes.simulation import Simulation
from game.tunables import Settings

Floats = NDArray[np.float64]


class DuelPlots:
    """Remembers the last ten seconds; of the force between the two its peaks."""

    def __init__(self, settings: Settings) -> None:
        self._you = BalancePlots(BalanceHistory(settings, 0))
        self._between = History(("opponent_height_m", "force_n"))
        self._frame, self._force = 0, 0.0

    def observe(self, simulation: Simulation) -> None:
        world = simulation.world
        found = world.meter.contacts
        if found is not None:
            self._force = max(self._force, force_between(found.force, found.body))
        self._you.seen.observe(simulation)
        self._frame += 1
        if self._frame % FRAMES_PER_SAMPLE == 0:
            self._between.add(simulation.clock_s, np.array([world.characters[1].com_height(), self._force]))
            self._force = 0.0

    def plots(self, simulation: Simulation) -> tuple[Plot, ...]:
        plots = self._you.plots(simulation)
        if not plots:
            return ()
        plan, *rest = plots
        time_s, height, force = self._between.latest()
        rest = [_with_opponents_height(plot, (time_s, height)) if plot.title == "COM height" else plot for plot in rest]
        return (_with_opponent(plan, simulation), *rest, Plot("force between the two", "N", {"force": (time_s, force)}))


def _with_opponent(plan: Plot, simulation: Simulation) -> Plot:
    rival = simulation.world.characters[1]
    series = {f"opponent's {side} foot": from_above(sole_outline(rival, k)) for k, side in enumerate(("left", "right"))}
    series["opponent's COM"] = from_above(rival.com[:2])
    looks = dict.fromkeys(series, "other")
    return replace(plan, title="your balance from above", series={**series, **plan.series}, looks={**plan.looks, **looks})


def _with_opponents_height(plot: Plot, height: tuple[Floats, Floats]) -> Plot:
    return replace(plot, series={"you": plot.series["character"], "opponent": height})


@compiled
def force_between(force: Floats, body: NDArray[np.int64]) -> float:
    """N, the size of the sum of the forces (n, 3) between the two characters; body (n, 2): MuJoCo ids of the partners, 0 the floor."""
    x = y = z = 0.0
    for i in range(len(force)):
        a, b = body[i, 0], body[i, 1]
        if a == 0 or b == 0 or (a - 1) // PART_COUNT == (b - 1) // PART_COUNT:
            continue
        # always on the second character
        sign = 1.0 if a < b else -1.0
        x += sign * force[i, 0]
        y += sign * force[i, 1]
        z += sign * force[i, 2]
    return math.sqrt(x * x + y * y + z * z)
