"""The live plots of a scene with one character: COM against the support from above, errors, torque, upright time."""

from collections import deque

import numpy as np

from game import rotation
from game.report.observer import Observer
from game.scenes.body_layers import support_polygon
from game.scenes.scene import Plot
from game.scenes.simulation import Simulation

WINDOW_FRAMES = 600


class BalancePlots:
    """Remembers the last ten seconds."""

    def __init__(self) -> None:
        self._rows: deque[tuple[float, ...]] = deque(maxlen=WINDOW_FRAMES)

    def observe(self, simulation: Simulation, observer: Observer) -> None:
        world = simulation.world
        body, fighter = world.characters[0], simulation.fighters[0]
        torque = np.abs(world.actuation.torque[body.joint_dofs])
        error = np.abs(rotation.log(rotation.multiply(rotation.conjugate(body.joint_rotation), fighter.target.joint_rotation)))
        heights = (body.com_height(), fighter.target.com[2])
        measured = (error.mean(), error.max(), torque.max(), observer.upright.upright_s)
        self._rows.append((simulation.time_s, *measured, *heights, *body.com[:2]))

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
