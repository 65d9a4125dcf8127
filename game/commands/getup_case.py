"""One shove at the chest, what the fall was like, and when the character stood again."""

import math
import traceback
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game import rotation
from game.characters.joint_limits import HIGH, LOW, joint_angles
from game.characters.skeleton import PART_COUNT
from game.commands.casting import Casting
from game.commands.shove import PUSH_S, shove_chest
from game.control.whole_body.on_the_floor import Stage
from game.control.whole_body.whole_body import WholeBody
from game.physics.dynamics import BodyDynamics, lowest_corner
from game.report.up_again import UpAgain
from game.scenes.mirror import Mirror
from game.scenes.simulation import Simulation
from game.tunables import Settings, Value

Row = dict[str, Any]
Floats = NDArray[np.float64]

LEAST_NS, MOST_NS = 140.0, 250.0
FIRST_S, LAST_S = 0.5, 1.5
"""When the shove comes, seconds after the release."""

WATCHED_S = 20.0
"""So long it may take to get up, tries that failed included."""

MOST_LIE_S = 5.0
"""Who has not begun to get up so long after the shove has kept its feet."""

STOOD_S = 1.0
"""A body that has stood for so long after the shove is not watched any longer."""


@dataclass(frozen=True)
class GetupCase:
    """character: its name; number, seed: of the shove, whose direction, impulse and moment are drawn from them."""

    character: str
    number: int
    seed: int


def run_getup_case(case: GetupCase, values: Mapping[str, Value]) -> Row:
    """The row of a shove; "failed" in it where it broke off."""
    row: Row = dict(asdict(case))
    try:
        return row | shove_once(case, Settings(values))
    except Exception as fault:  # whatever breaks in one fall must not take the others along
        what = f"shove {case.number} broke off: {type(fault).__name__}: {fault}"
        return row | {"failed": what, "traceback": traceback.format_exc()}


def shove_once(case: GetupCase, settings: Settings) -> Row:
    """direction_deg, impulse_ns; fell, up_s since the shove began (None: never), tries.

    Of the fall until it gets up: fast_rad_s (n,) of the fastest joint in each frame, and at most past_deg beyond a joint's range and
    deep_m of a part in the floor.
    """
    with _shoved(case, settings) as (simulation, direction, impulse):
        world, fighter, body = simulation.world, simulation.fighters[0], simulation.world.characters[0]
        rule, fall, began_s = UpAgain(), FallMeter(body), simulation.time_s
        since_s = 0.0
        while since_s < WATCHED_S and (since_s < PUSH_S or rule.up_s is None or since_s < rule.up_s + STOOD_S):
            simulation.advance()
            since_s = simulation.time_s - began_s
            found = world.meter.contacts
            rule.see(since_s, body, fighter.target, found.parts_on_floor(0) if found is not None else ())
            strategy = fighter.strategy
            floor = strategy.floor if isinstance(strategy, WholeBody) else None
            if floor is not None and floor.stays_down:
                break
            if fall.tries == 0 and rule.up_s is None:
                fall.see()
            if floor is not None and floor.stage is Stage.GETTING_UP:
                fall.tries = max(fall.tries, floor.tries)
        return {
            "direction_deg": math.degrees(direction), "impulse_ns": impulse, "at_s": began_s, "fell": rule.fell, "up_s": rule.up_s,
            "tries": fall.tries, "fast_rad_s": fall.fast_rad_s, "past_deg": math.degrees(fall.past_rad), "deep_m": fall.deep_m,
            "guard_actions": world.guard_actions, "unexplained_force_n": float(world.meter.unexplained_force_n[0]),
            "state_sha256": world.state_sha256,
        }  # fmt: skip


def lie_after_shove(case: GetupCase, settings: Settings) -> Floats | None:
    """(63,) how the character lies when it begins to get up; None where it has kept its feet."""
    with _shoved(case, settings) as (simulation, _, _):
        strategy = simulation.fighters[0].strategy
        assert isinstance(strategy, WholeBody)
        until_s = simulation.time_s + MOST_LIE_S
        while simulation.time_s < until_s:
            simulation.advance()
            if strategy.floor.stage is Stage.GETTING_UP:
                return simulation.world.characters[0].configuration.copy()
    return None


@contextmanager
def _shoved(case: GetupCase, settings: Settings) -> Iterator[tuple[Simulation, float, float]]:
    """A standing character just as the shove begins; its direction, rad from where the character faces, and impulse, N s."""
    rng = np.random.default_rng((case.seed, case.number))
    direction, impulse, at_s = rng.uniform(-math.pi, math.pi), rng.uniform(LEAST_NS, MOST_NS), rng.uniform(FIRST_S, LAST_S)
    scene = Casting("performer:standing", case.character, settings, case.seed).scene("mirror")
    assert isinstance(scene, Mirror)
    try:
        scene.enter()
        simulation = scene.simulation
        while simulation.time_s < at_s:
            simulation.advance()
        world = simulation.world
        shove_chest(world, rotation.yaw(world.characters[0].orientation[0]) + direction, impulse)
        yield simulation, direction, impulse
    finally:
        scene.leave()


class FallMeter:
    """What a fall is like, frame by frame: see `shove_once`."""

    def __init__(self, body: BodyDynamics) -> None:
        self._body, self._half = body, body.plan.size / 2.0
        self.tries = 0
        self.fast_rad_s: list[float] = []
        self.past_rad = self.deep_m = 0.0

    def see(self) -> None:
        body = self._body
        self.fast_rad_s.append(float(np.linalg.norm(body.velocity[6:].reshape(-1, 3), axis=1).max()))
        angles = joint_angles(body.joint_rotation)
        self.past_rad = max(self.past_rad, float(np.maximum(LOW - angles, angles - HIGH).max()))
        lowest = min(lowest_corner(body.turn[part], body.box_centre[part], self._half[part]) for part in range(PART_COUNT))
        self.deep_m = max(self.deep_m, -lowest)
