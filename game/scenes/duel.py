"""Scene `duel`: two bodies within arm's reach, one yours; who falls loses the round."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from game.characters.skeleton import PARTS
from game.drawables import Layer
from game.inputs.sparring import SparringPartner
from game.physics.contacts import FLOOR
from game.report.session_report import Stopwatch, peak_torques, simulation_report
from game.scenes.body_layers import fighter_layers
from game.scenes.duel_plots import DuelPlots
from game.scenes.fighter import Fighter
from game.scenes.key_help import keys_for
from game.scenes.played_scene import PlayedScene
from game.scenes.scene import CameraHint, Plot
from game.scenes.simulation import Simulation
from game.scenes.staging import CAMERAS

LOW_COM_SHARE = 0.55
"""A COM below this share of its standing height is a fall even before the trunk lies on the floor."""

AFTERMATH_FRAMES = 100
"""How long a fall is watched before the next round begins."""

BOLD_AFTER_S = 30.0

BREAK_FRAMES = 480
"""Frames without a touch after which the two, who cannot walk yet, are brought together again."""

_LYING = frozenset(PARTS.index(name) for name in ("pelvis", "trunk", "head"))
NAMES = ("You", "Opponent")


@dataclass(frozen=True)
class Round:
    """One finished round. winner: 0 you, 1 the opponent, None a draw; length_s from the release; why in words."""

    winner: int | None
    length_s: float
    why: str


class Duel(PlayedScene):
    """Your input against a sparring partner, round after round."""

    name = "duel"

    def enter(self) -> None:
        self.leave()
        self._watch = Stopwatch()
        partner = SparringPartner(self._seed + 1)
        self._partner = partner
        half = 0.5 * self._settings.number("duel.distance_m")
        player = Fighter(0, self._plan, self._opens, self._settings, mirrored=False, place=(-half, 0.0), strategy="duel.strategy")
        rival = Fighter(
            1, self._plan, lambda: partner, self._settings, mirrored=False, place=(half, 0.0), facing_rad=np.pi, strategy="duel.strategy"
        )
        self.simulation = Simulation([player, rival], self._settings)
        self.rounds: list[Round] = []
        self._aftermath = 0
        self._touched_frame = 0
        self._fought_s = 0.0
        self.breaks = 0
        self._plots = DuelPlots(self._settings)
        self._entered = True

    @property
    def time_s(self) -> float:
        return self.simulation.clock_s

    def fixed_update(self) -> None:
        simulation = self.simulation
        a, b = (body.com for body in simulation.world.characters)
        self._partner.see(float(np.hypot(*(a - b)[:2])), self._vigour())
        simulation.advance()
        self._plots.observe(simulation)
        if self._aftermath > 0:
            self._aftermath -= 1
            if self._aftermath == 0:
                self._fought_s = 0.0
                self._begin()
        elif simulation.frame > 0:
            self._judge()
            self._break_if_idle()

    @property
    def round_s(self) -> float:
        """Fighting time of the round, breaks left out, seconds."""
        return self._fought_s + max(0.0, self.simulation.time_s)

    def _break_if_idle(self) -> None:
        """Where nobody has touched the other for a while, both are taken back to their places and the round goes on."""
        simulation = self.simulation
        found = simulation.world.meter.contacts
        if found is not None and (found.character != FLOOR).all(axis=1).any():
            self._touched_frame = simulation.frame
        if self._aftermath == 0 and simulation.frame - self._touched_frame > BREAK_FRAMES:
            self._fought_s = self.round_s
            self.breaks += 1
            self._begin()

    def _begin(self) -> None:
        """Both at their places, hanging, then released."""
        self._touched_frame = 0
        self._partner.new_round()
        self.simulation.hang_again()

    def _vigour(self) -> float:
        """The opponent grows bolder as a round drags on, up to full vigour after half a minute."""
        vigour = self._settings.number("duel.opponent_vigour")
        return vigour + (1.0 - vigour) * min(1.0, self.round_s / BOLD_AFTER_S)

    def _judge(self) -> None:
        """End the round where somebody is down or the time is up."""
        down = [self._is_down(index) for index in range(2)]
        length = self.round_s
        if any(down):
            winner = None if all(down) else down.index(False)
            why = "both went down" if winner is None else f"{NAMES[1 - winner].lower()} went down"
        elif length >= self._settings.number("duel.round_limit_s"):
            winner, why = None, "time is up"
        else:
            return
        self.rounds.append(Round(winner, length, why))
        self._aftermath = AFTERMATH_FRAMES

    def _is_down(self, index: int) -> bool:
        """Pelvis, trunk or head touch the floor, or the COM has sunk too low."""
        world = self.simulation.world
        if world.characters[index].com_height() < LOW_COM_SHARE * self._plan.idle_com_height:
            return True
        found = world.meter.contacts
        return found is not None and not _LYING.isdisjoint(found.parts_on_floor(index))

    def drawables(self, blend: float) -> tuple[Layer, ...]:
        layers = [layer for index in range(2) for layer in fighter_layers(self.simulation, index, blend, self._settings)]
        return (*self._room, *layers)

    def wins(self, index: int) -> int:
        return sum(r.winner == index for r in self.rounds)

    def readouts(self) -> Mapping[str, float | str]:
        simulation = self.simulation
        frames = max(1, simulation.frames_run)
        return {
            "input": simulation.fighters[0].source.status,
            "round": float(len(self.rounds) + (self._aftermath == 0)),
            "round_s": self.round_s,
            "unexplained_force_n": float(simulation.world.meter.unexplained_force_n.max()),
            "guard_actions": float(simulation.world.guard_actions),
            **{f"{stage}_ms": 1e3 * spent / frames for stage, spent in simulation.stage_s.items()},
        }

    def plots(self) -> tuple[Plot, ...]:
        return self._plots.plots(self.simulation)

    def messages(self) -> tuple[str, ...]:
        fighter = self.simulation.fighters[0]
        said = [fighter.source.status]
        if fighter.fault:
            said.append(fighter.fault[0].upper() + fighter.fault[1:] + ".")
        if self._aftermath > 0:
            last = self.rounds[-1]
            who = "Nobody wins" if last.winner is None else "You win" if last.winner == 0 else "The opponent wins"
            said.append(f"{who} round {len(self.rounds)}: {last.why}.")
        return tuple(said + self.simulation.world.faults[-1:])

    def score(self) -> str | None:
        return f"{NAMES[0]} {self.wins(0)} : {self.wins(1)} {NAMES[1]}"

    def help_keys(self) -> tuple[tuple[str, str], ...]:
        return keys_for(self._input_name)

    def cameras(self) -> Mapping[str, CameraHint]:
        return CAMERAS["duel"]

    def report(self) -> dict[str, object]:
        simulation = self.simulation
        length = simulation.fighters[0].source.length_s
        return {
            "scene": self.name,
            "input": self._input_name,
            "character": self._plan.name,
            "clip_s": self.time_s if length is None else length,
            "score": self.score(),
            "rounds": [round_row(r) for r in self.rounds],
            **simulation_report(simulation, self._settings, self._watch, self._seed),
            "peak_torque_nm": peak_torques(simulation, 0),
        }


def round_row(done: Round) -> dict[str, object]:
    """A finished round for the report: the winner's name, or None for a draw."""
    return {"winner": None if done.winner is None else NAMES[done.winner], "length_s": done.length_s, "why": done.why}
