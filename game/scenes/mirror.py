"""Scene `mirror`: the character does what the input does."""

from collections.abc import Mapping

from game.control.whole_body.on_the_floor import Stage
from game.control.whole_body.whole_body import WholeBody
from game.drawables import Layer
from game.report.observer import Observer
from game.report.session_report import Stopwatch, peak_torques, simulation_report
from game.scenes.balance_history import BalanceHistory
from game.scenes.balance_plots import BalancePlots
from game.scenes.body_layers import fighter_layers
from game.scenes.fighter import Fighter
from game.scenes.key_help import keys_for
from game.scenes.played_scene import PlayedScene
from game.scenes.scene import CameraHint, Plot
from game.scenes.simulation import Simulation
from game.scenes.staging import CAMERAS


def what_follows(fighter: Fighter) -> str:
    """A fall, as far as the fighter's strategy makes something of it."""
    strategy = fighter.strategy
    if not isinstance(strategy, WholeBody) or not strategy.floor.falls:
        return ""
    return {Stage.UP: " and stands again", Stage.DOWN: " and cannot get up", Stage.FALLING: ""}.get(strategy.floor.stage, " and gets up")


class Mirror(PlayedScene):
    """One character and one input. `opens` gives a fresh source each time the scene is entered."""

    name = "mirror"

    def enter(self) -> None:
        self.leave()
        self._watch = Stopwatch()
        fighter = Fighter(0, self._plan, self._opens, self._settings, mirrored=True)
        self.simulation = Simulation([fighter], self._settings)
        self.observer = Observer(fighter, fighter.source.length_s)
        self._balance = BalancePlots(BalanceHistory(self._settings))
        self._entered = True

    def fixed_update(self) -> None:
        self.simulation.advance()
        self.observer.observe(self.simulation)
        self._balance.seen.observe(self.simulation, self.observer.upright.upright_s)

    def drawables(self, blend: float) -> tuple[Layer, ...]:
        return (*self._room, *fighter_layers(self.simulation, 0, blend, self._settings))

    def readouts(self) -> Mapping[str, float | str]:
        simulation, clock = self.simulation, self.observer.upright
        body = simulation.world.characters[0]
        frames = max(1, simulation.frames_run)
        return {
            "input": simulation.fighters[0].source.status,
            "upright_s": clock.upright_s,
            "fell_at_s": -1.0 if clock.fell_at_s is None else clock.fell_at_s,
            "com_height_m": body.com_height(),
            "unexplained_force_n": float(simulation.world.meter.unexplained_force_n[0]),
            "guard_actions": float(simulation.world.guard_actions),
            **{f"{stage}_ms": 1e3 * spent / frames for stage, spent in simulation.stage_s.items()},
        }

    def plots(self) -> tuple[Plot, ...]:
        return self._balance.plots(self.simulation)

    def messages(self) -> tuple[str, ...]:
        fighter, clock = self.simulation.fighters[0], self.observer.upright
        said = [fighter.source.status]
        if fighter.fault:
            said.append(fighter.fault[0].upper() + fighter.fault[1:] + ".")
        if clock.fell_at_s is not None:
            said.append(f"It fell after {clock.fell_at_s:.1f} s{what_follows(fighter)}. R starts again.")
        return tuple(said + self.simulation.world.faults[-1:])

    def score(self) -> str | None:
        return None

    def help_keys(self) -> tuple[tuple[str, str], ...]:
        return keys_for(self._input_name)

    def cameras(self) -> Mapping[str, CameraHint]:
        return CAMERAS["mirror"]

    def report(self) -> dict[str, object]:
        source = self.simulation.fighters[0].source
        length = source.length_s if source.length_s is not None else self.simulation.time_s
        return {
            "scene": self.name,
            "input": self._input_name,
            "character": self._plan.name,
            "clip_s": length,
            **self.observer.summary(),
            **simulation_report(self.simulation, self._settings, self._watch, self._seed),
            "peak_torque_nm": peak_torques(self.simulation, 0),
        }
