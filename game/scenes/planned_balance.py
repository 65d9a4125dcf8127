"""What a balance strategy plans, as far as it can be read: places on the floor, loads, what each foot does, torque limits."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from game.control.ankle_strategy import AnkleStrategy
from game.control.whole_body.contact_states import Phase
from game.control.whole_body.sole import soles_of
from game.control.whole_body.support_polygon import sole_corners
from game.control.whole_body.whole_body import WholeBody
from game.physics.dynamics import BodyDynamics
from game.scenes.fighter import Fighter

Floats = NDArray[np.float64]

_LOOK_OF_PHASE = {Phase.STANCE: "stands", Phase.SWING: "follows", Phase.STEP: "steps"}


@dataclass(frozen=True)
class PlannedBalance:
    """Places (2,) on the floor, world m; None for what the strategy does not plan.

    capture, com: where the capture point, or the COM, is wanted; pressure: where the pressure under the feet is; loads_n: planned
    vertical force on the left and right foot; feet: what each does, as a look of `Plot`; landing: outline (4, 2) of where a step of
    its own comes down; limited: torques are kept within limits; missing: what is not planned, in words, empty where nothing is.
    """

    capture: Floats | None = None
    com: Floats | None = None
    pressure: Floats | None = None
    loads_n: tuple[float, float] | None = None
    feet: tuple[str, str] = ("touches", "touches")
    landing: tuple[Floats | None, Floats | None] = (None, None)
    limited: bool = False
    missing: str = ""


def planned_balance(fighter: Fighter, body: BodyDynamics) -> PlannedBalance:
    """What the fighter's strategy planned at its last control tick."""
    strategy, name = fighter.strategy, fighter.strategy_name
    if isinstance(strategy, WholeBody):
        return _of_whole_body(strategy, body)
    touching = _touching(body)
    if isinstance(strategy, AnkleStrategy) and not body.held:
        missing = f"Strategy {name} plans no capture point, pressure, foot loads or steps."
        return PlannedBalance(com=strategy.com_target[:2].copy(), feet=touching, missing=missing)
    missing = "The plan begins at the release." if body.held else f"Strategy {name} plans no balance: no wanted points, loads or steps."
    return PlannedBalance(feet=touching, missing=missing)


def _of_whole_body(strategy: WholeBody, body: BodyDynamics) -> PlannedBalance:
    if body.held or strategy.limits is None:
        return PlannedBalance(feet=_touching(body), missing="The plan begins at the release.")
    if strategy.fallen:
        return PlannedBalance(feet=_touching(body), missing="It has fallen: nothing is planned.")
    lift = strategy.wrench[2::6].tolist()
    loads = [0.0, 0.0]
    for side, force in zip(strategy.standing, lift, strict=False):
        loads[side] = force
    feet = strategy.footing.feet
    looks = tuple("flies" if strategy.footing.flying else _LOOK_OF_PHASE[foot.phase] for foot in feet)
    landing = tuple(_landing(strategy, body, side) if foot.phase is Phase.STEP else None for side, foot in enumerate(feet))
    return PlannedBalance(
        capture=strategy.com_target[:2].copy(),
        # in the air there is none to be had
        pressure=None if strategy.footing.flying else strategy.pressure.copy(),
        loads_n=(loads[0], loads[1]),
        feet=(looks[0], looks[1]),
        landing=(landing[0], landing[1]),
        limited=True,
    )


def _touching(body: BodyDynamics) -> tuple[str, str]:
    left, right = body.foot_contact
    return "touches" if left else "lifted", "touches" if right else "lifted"


def _landing(strategy: WholeBody, body: BodyDynamics, side: int) -> Floats:
    foot, sole = strategy.footing.feet[side], soles_of(body)[side]
    return sole_corners(foot.goal, foot.goal_yaw, sole.half_length, sole.half_width)


def kept_limits(fighter: Fighter) -> tuple[Floats, Floats] | None:
    """Least and largest torque (42,) N m that the strategy kept to at its last control tick, None where it keeps to none."""
    strategy = fighter.strategy
    return strategy.limits if isinstance(strategy, WholeBody) and not strategy.fallen else None
