"""The live plots of a scene with one character: COM against the support from above, errors, torque, upright time."""

from collections import deque

import numpy as np
from numpy.typing import NDArray

from game import rotation_compiled as one
from game.compiled import compiled
from game.report.observer import Observer
from game.scenes.body_layers import support_polygon
from game.scenes.scene import Plot
from game.scenes.simulation import Simulation

Floats = NDArray[np.float64]

WINDOW_FRAMES = 600


class BalancePlots:
    """Remembers the last ten seconds."""

    def __init__(self) -> None:
        self._rows: deque[tuple[float, ...]] = deque(maxlen=WINDOW_FRAMES)

    def observe(self, simulation: Simulation, observer: Observer) -> None:
        world = simulation.world
        body, fighter = world.characters[0], simulation.fighters[0]
        mean, worst = _joint_errors(body.joint_rotation, fighter.target.joint_rotation)
        torque = _largest(world.actuation.torque[body.joint_dofs])
        x, y, height = body.com.tolist()
        row = (simulation.time_s, mean, worst, torque, observer.upright.upright_s, height, float(fighter.target.com[2]), x, y)
        self._rows.append(row)

    def plots(self, simulation: Simulation) -> tuple[Plot, ...]:
        if not self._rows:
            return ()
        t, mean, worst, torque, upright, height, wanted, com_x, com_y = np.array(self._rows).T
        body, fighter = simulation.world.characters[0], simulation.fighters[0]
        hull = support_polygon(body)
        plan = {"COM": (-com_y, com_x)}
        if len(hull) > 2:
            closed = np.vstack((hull, hull[:1]))
            plan["support"] = (-closed[:, 1], closed[:, 0])
        for name, key in (("COS", "cos"), ("COM target", "com_target")):
            place = getattr(fighter.strategy, key, None)
            if place is not None:
                plan[name] = (np.array([-place[1]]), np.array([place[0]]))
        return (
            Plot("COM over the support, from above", "m", plan, kind="plan"),
            Plot("joint error, parent frame", "rad", {"mean": (t, mean), "worst": (t, worst)}),
            Plot("largest joint torque", "N m", {"torque": (t, torque)}),
            Plot("COM height", "m", {"character": (t, height), "target": (t, wanted)}),
            Plot("upright time", "s", {"upright": (t, upright)}),
        )


@compiled
def _joint_errors(own: Floats, wanted: Floats) -> tuple[float, float]:
    """Mean and largest angle (rad) about any single axis between rotations (n, 4)."""
    total = worst = 0.0
    for j in range(len(own)):
        for angle in one.turn_to(own[j], wanted[j]):
            total += abs(angle)
            worst = max(worst, abs(angle))
    return total / (3 * len(own)), worst


@compiled
def _largest(torque: Floats) -> float:
    """The largest size in `torque` (n,)."""
    worst = 0.0
    for t in torque:
        worst = max(worst, abs(t))
    return worst
