"""Pushes from one direction: how hard the chest may be pushed for 0.2 s before the character does not recover."""

import math
import traceback
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from game import rotation
from game.commands.casting import Casting
from game.commands.shove import PUSH_S, shove_chest
from game.report.recovery import Recovery
from game.scenes.mirror import Mirror
from game.tunables import Settings, Value

Row = dict[str, Any]

GRID_NS, FINE_NS, MOST_NS = 10.0, 2.0, 400.0
"""Every step of the grid is tried from below up to the first that is not recovered from, then the finer ones before it."""

AGAIN_S = 0.37
"""Each impulse is tried again so much later, and must be recovered from every time."""

WHILE: Mapping[str, tuple[str, float]] = {
    "standing": ("performer:standing", 1.0),
    "waving": ("performer:waving", 4.0),
    "stepping": ("performer:stepping", 9.0),
    "one-leg": ("performer:balancing", 8.0),
}
"""What the player does meanwhile, and when the push comes, seconds after the release."""


@dataclass(frozen=True)
class PushCase:
    """direction_deg: where the force points, counterclockwise from the character's front; tries: at so many moments."""

    doing: str
    character: str
    direction_deg: float
    tries: int
    seed: int = 0


def run_push_case(case: PushCase, values: Mapping[str, Value]) -> Row:
    """The row of a direction: impulse_ns, the largest that was recovered from with all smaller ones; failure: what happened beyond it."""
    row: Row = dict(asdict(case))
    try:
        return row | _scan(case, Settings(values))
    except Exception as fault:  # whatever breaks in one direction must not take the others along
        what = f"{case.direction_deg:g} degrees broke off: {type(fault).__name__}: {fault}"
        return row | {"failed": what, "traceback": traceback.format_exc()}


def _scan(case: PushCase, settings: Settings) -> Row:
    best, failure, runs = 0.0, "", []
    impulses = [GRID_NS * k for k in range(1, int(MOST_NS / GRID_NS) + 1)]
    while impulses:
        impulse = impulses.pop(0)
        tried = [push_once(case, settings, impulse, attempt) for attempt in range(case.tries)]
        runs += tried
        lost = [run for run in tried if run["outcome"] != "recovered"]
        if not lost:
            best = impulse
            continue
        failure = lost[0]["outcome"]
        # below a step of the grid a harder push may be recovered from and a lighter one not, so each is tried
        fine = impulse - best > FINE_NS + 1e-9
        impulses = [best + FINE_NS * k for k in range(1, round((impulse - best) / FINE_NS))] if fine else []
    force = max(run["unexplained_force_n"] for run in runs)
    return {"impulse_ns": best, "failure": failure, "runs": runs, "unexplained_force_max_n": force}


def push_once(case: PushCase, settings: Settings, impulse_ns: float, attempt: int) -> Row:
    """One push and what came of it: outcome, steps, back_s, tilt_deg, guard_actions, unexplained_force_n."""
    spec, at_s = WHILE[case.doing]
    scene = Casting(spec, case.character, settings, case.seed).scene("mirror")
    assert isinstance(scene, Mirror)
    try:
        scene.enter()
        simulation = scene.simulation
        world, fighter = simulation.world, simulation.fighters[0]
        while simulation.time_s < at_s + AGAIN_S * attempt:
            simulation.advance()
        body = world.characters[0]
        towards = rotation.yaw(body.orientation[0]) + math.radians(case.direction_deg)
        shove_chest(world, towards, impulse_ns)
        rule, began_s = Recovery(body, fighter.target, PUSH_S), simulation.time_s
        while not rule.outcome:
            simulation.advance()
            found = world.meter.contacts
            rule.see(simulation.time_s - began_s, body, fighter.target, found.parts_on_floor(0) if found is not None else ())
        return {
            "impulse_ns": impulse_ns, "at_s": began_s, "outcome": rule.outcome, "steps": rule.steps, "back_s": rule.back_s,
            "away_m": rule.away_m, "away_deg": math.degrees(rule.away_rad),
            "tilt_deg": math.degrees(rule.tilt_rad), "guard_actions": world.guard_actions,
            "unexplained_force_n": float(world.meter.unexplained_force_n[0]), "state_sha256": world.state_sha256,
        }  # fmt: skip
    finally:
        scene.leave()
