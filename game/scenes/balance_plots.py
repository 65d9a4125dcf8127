"""The live plots of one character's balance: the view from above, the use of its joints, and what it does over time."""

import numpy as np
from numpy.typing import NDArray

from game.characters.skeleton import JOINTS
from game.physics.dynamics import BodyDynamics
from game.scenes.balance_history import BODY, ERRORS, LOADS, USE, BalanceHistory
from game.scenes.body_layers import support_polygon
from game.scenes.foot_loads import LEAST_LOAD_N
from game.scenes.scene import Plot
from game.scenes.simulation import Simulation

Floats = NDArray[np.float64]
Curve = tuple[Floats, Floats]

PATH_SAMPLES = 24
"""Of the COM's path: the last two seconds."""

JOINT_WORDS = tuple(joint.replace("_", " ") for joint in JOINTS)
_JOINT_PLACES = np.arange(float(len(JOINTS)))

_ROW = {name: row for row, name in enumerate((*LOADS, *ERRORS, *BODY, *USE), start=1)}
"""Of each measure in what a history of balance gives; row 0 is the time."""

_HARDEST = len(_ROW) + 1
"""Row after all of these: of the joint that uses most."""

_USE_ROWS = [_ROW[name] for name in USE]
_OVER_TIME: tuple[tuple[str, str, float, tuple[tuple[str, int], ...]], ...] = (
    ("foot loads", "% of weight", 100.0, (
        ("left", _ROW["load_left"]), ("right", _ROW["load_right"]),
        ("left planned", _ROW["load_left_planned"]), ("right planned", _ROW["load_right_planned"]),
    )),
    ("errors", "cm", 1.0, (
        ("capture point", _ROW["capture_cm"]), ("COM", _ROW["com_cm"]), ("hands", _ROW["hands_cm"]), ("feet", _ROW["feet_cm"]),
    )),
    ("pelvis error", "degrees", 1.0, (("pelvis", _ROW["pelvis_deg"]),)),
    ("joint errors", "rad", 1.0, (("worst", _ROW["joint_worst_rad"]), ("mean", _ROW["joint_mean_rad"]))),
    ("largest torque", "N m", 1.0, (("torque", _ROW["torque_nm"]),)),
    ("hardest joint", "% of limit", 100.0, (("use", _HARDEST),)),
    ("COM height", "m", 1.0, (("target", _ROW["target_height_m"]), ("character", _ROW["com_height_m"]))),
    ("upright time", "s", 1.0, (("upright", _ROW["upright_s"]),)),
)  # fmt: skip
"""Title, unit, factor and the curves of each plot over time, by the rows of what a history of balance gives."""


class BalancePlots:
    """Lays out what a history of balance holds; what only changes with a sample is laid out once for each."""

    def __init__(self, seen: BalanceHistory) -> None:
        self.seen = seen
        self._sampled = -1
        self._path: Curve = (np.zeros(0), np.zeros(0))
        self._most = np.zeros(len(JOINTS))
        self._over_time: tuple[Plot, ...] = ()

    def plots(self, simulation: Simulation) -> tuple[Plot, ...]:
        """The view from above first; none before the first sample."""
        seen = self.seen
        if seen.history.length == 0:
            return ()
        if self._sampled != seen.history.count:
            self._sampled = seen.history.count
            self._lay_out(seen.history.latest())
        seen.look(simulation)
        body = simulation.world.characters[seen.index]
        return (plan_plot(seen, body, self._path), use_plot(seen, self._most), *self._over_time)

    def _lay_out(self, rows: Floats) -> None:
        self._over_time = time_plots(np.vstack((rows, rows[_USE_ROWS].max(axis=0))))
        recent = rows[:, -PATH_SAMPLES:]
        self._path = -recent[_ROW["com_y"]], recent[_ROW["com_x"]]
        self._most = rows[_USE_ROWS].max(axis=1)


def from_above(places: Floats) -> Curve:
    """World places (n, 2) or (2,) as right and forward."""
    places = places.reshape(-1, 2)
    return -places[:, 1], places[:, 0].copy()


def plan_plot(seen: BalanceHistory, body: BodyDynamics, path: Curve) -> Plot:
    """The feet, the support and the points that the balance is about, seen from above."""
    plan = seen.plan
    series: dict[str, Curve] = {}
    looks: dict[str, str] = {}

    def show(name: str, look: str, places: Floats | None) -> None:
        if places is not None:
            series[name], looks[name] = from_above(places), look

    hull = support_polygon(body)
    show("support", "area", hull if len(hull) > 2 else None)
    for side, name in enumerate(("left foot", "right foot")):
        show(f"landing of {name}", "landing", plan.landing[side])
        show(name, plan.feet[side], sole_outline(body, side))
    series["COM path"], looks["COM path"] = path, "trail"
    show("pressure", "point", seen.loads[3:5] if seen.loads[2] >= LEAST_LOAD_N else None)
    show("pressure wanted", "goal", plan.pressure)
    show("capture point", "point", seen.capture)
    show("capture point wanted", "goal", plan.capture)
    show("COM", "point", body.com[:2])
    show("COM wanted", "goal", plan.com)
    return Plot("balance from above", "m", series, kind="plan", looks=looks, note=plan.missing or "Rings and thin curves: as planned.")


def sole_outline(body: BodyDynamics, side: int) -> Floats:
    """(4, 2) the lower corners of a foot, in order."""
    return body.foot_corners[side, (0, 1, 3, 2), :2]


def use_plot(seen: BalanceHistory, most: Floats) -> Plot:
    """Share of its limit that each joint uses, and the most (14,) it used in the time shown."""
    limited = seen.plan.limited
    note = "Torque: of each joint's limit at its speed." if limited else "Torque: of a human's strength, as no limit is kept."
    series = {"now": (_JOINT_PLACES, 100.0 * seen.use), "most": (_JOINT_PLACES, 100.0 * most)}
    return Plot("torque use", "%", series, kind="bars", names=JOINT_WORDS, note=note)


def time_plots(rows: Floats) -> tuple[Plot, ...]:
    """Every measure of which there is anything to show; rows as a history of balance gives them."""
    shown = np.isfinite(rows).sum(axis=1)
    plots = []
    for title, unit, factor, curves in _OVER_TIME:
        series = {name: (rows[0], factor * rows[row]) for name, row in curves if shown[row]}
        if series:
            plots.append(Plot(title, unit, series, looks={name: "planned" for name in series if name.endswith(" planned")}))
    return tuple(plots)
