"""Scene `duel`: who falls loses, the score counts, the next round starts by itself, and the opponent strikes when you are near."""

from dataclasses import replace
from statistics import median

import numpy as np
import pytest

from game.control.joint_command import BalanceStrategy, BodyState, JointCommand
from game.inputs.sparring import NEAR_M, SparringPartner
from game.scenes.duel import AFTERMATH_FRAMES, Duel
from game.target.kinematic_target import KinematicTarget
from game.tunables import Settings
from kinect.body import Joint
from tests.scenes.staged import look_at, make_scene, run_s
from tests.scenes.twenty_rounds import first_rounds, table


class Limp:
    """A balance strategy without muscles."""

    def __init__(self, strategy: BalanceStrategy) -> None:
        self._strategy = strategy

    def reset(self, dynamics: BodyState) -> None:
        self._strategy.reset(dynamics)

    def command(self, target: KinematicTarget, dynamics: BodyState, dt: float) -> JointCommand:
        command = self._strategy.command(target, dynamics, dt)
        return replace(command, kp=0.0 * command.kp, kd=0.0 * command.kd + 1.0, feedforward=0.0 * command.feedforward)


def duel(*limp: int, **values: object) -> Duel:
    """A duel at its release, far enough apart that nobody touches; the fighters in `limp` have no muscles."""
    settings = Settings({"duel.distance_m": 2.0, **{key.replace("__", "."): value for key, value in values.items()}})
    scene = make_scene("duel", "script", settings)
    assert isinstance(scene, Duel)
    scene.enter()
    run_s(scene, 0.0)
    for index in limp:
        fighter = scene.simulation.fighters[index]
        fighter.strategy = Limp(fighter.strategy)
    return scene


def play_round(scene: Duel, limit_s: float = 3.0) -> None:
    """Run on until one more round is over."""
    rounds, until = len(scene.rounds), scene.time_s + limit_s
    while len(scene.rounds) == rounds:
        assert scene.time_s < until, "the round does not end"
        scene.fixed_update()


@pytest.mark.parametrize(("loser", "score", "said"), [(1, "You 1 : 0 Opponent", "You win"), (0, "You 0 : 1 Opponent", "The opponent wins")])
def test_who_falls_loses_the_round(loser: int, score: str, said: str) -> None:
    scene = duel(loser)
    assert scene.score() == "You 0 : 0 Opponent"
    play_round(scene)
    ended = scene.rounds[0]
    assert ended.winner == 1 - loser
    assert 0.2 < ended.length_s < 2.0
    assert scene.score() == score
    assert scene.messages()[-1].startswith(f"{said} round 1")
    scene.leave()


def test_when_both_go_down_at_once_nobody_wins(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = duel()
    monkeypatch.setattr(scene, "_is_down", lambda index: True)
    scene.fixed_update()
    scene.fixed_update()
    assert scene.rounds[0].winner is None
    assert scene.score() == "You 0 : 0 Opponent"
    assert scene.messages()[-1].startswith("Nobody wins round 1")
    scene.leave()


def test_who_stands_is_not_down_and_who_lies_is() -> None:
    scene = duel(1)
    assert not scene._is_down(0) and not scene._is_down(1)
    play_round(scene)
    assert scene._is_down(1) and not scene._is_down(0)
    scene.leave()


def test_a_crouch_is_no_fall_but_a_centre_of_mass_near_the_floor_is() -> None:
    scene = duel()
    world = scene.simulation.world
    standing = scene._plan.idle_com_height
    heights = {"crouched": 0.7 * standing, "sunk": 0.4 * standing}
    for state, height in heights.items():
        world.characters[0].com_height = lambda height=height: height  # type: ignore[method-assign]
        assert scene._is_down(0) == (state == "sunk")
    scene.leave()


def test_the_next_round_starts_by_itself_with_everybody_back_on_their_feet() -> None:
    scene = duel(1)
    play_round(scene)
    assert scene.readouts()["round"] == 1.0
    for _ in range(AFTERMATH_FRAMES):
        assert not scene.simulation.hanging
        scene.fixed_update()
    assert scene.simulation.hanging and scene.readouts()["round"] == 2.0
    upright = scene._plan.idle_com_height
    for body, x in zip(scene.simulation.world.characters, (-1.0, 1.0)):
        assert body.com_height() == pytest.approx(upright, abs=0.1)
        assert body.com[:2] == pytest.approx([x, 0.0], abs=0.25)
    assert len(scene.rounds) == 1, "the fall is counted once"
    play_round(scene, 4.0)
    assert scene.score() == "You 2 : 0 Opponent"
    assert scene.report()["unexplained_force_max_n"] < 1e-6  # type: ignore[operator]
    scene.leave()


def test_a_round_that_lasts_too_long_is_a_draw() -> None:
    scene = duel(duel__round_limit_s=5.0)
    run_s(scene, 0.1)
    scene.simulation.frame = 298
    scene.fixed_update()
    assert scene.rounds == []
    scene.fixed_update()
    assert [(r.winner, r.why) for r in scene.rounds] == [(None, "time is up")]
    assert scene.rounds[0].length_s == pytest.approx(5.0)
    scene.leave()


def test_rounds_go_the_same_way_whether_or_not_somebody_watches() -> None:
    watched, alone = duel(1), duel(1)
    while alone.simulation.time_s > alone.time_s - 1.0 / 120.0:
        for scene in (watched, alone):
            scene.fixed_update()
        look_at(watched)
        assert alone.time_s < 5.0, "the next round does not begin"
    assert len(alone.rounds) == 1
    assert watched.rounds == alone.rounds
    assert watched.report()["state_sha256"] == alone.report()["state_sha256"]


def test_the_two_face_each_other_at_the_asked_distance_and_their_bodies_collide() -> None:
    for distance, met in ((0.4, True), (1.5, False)):
        scene = make_scene("duel", settings=Settings({"duel.distance_m": distance}))
        assert isinstance(scene, Duel)
        scene.enter()
        mine, theirs = (body.joint[0] for body in scene.simulation.world.characters)
        assert theirs - mine == pytest.approx([distance, 0.0, 0.0], abs=0.02)
        ahead = [body.turn[0, :, 0] for body in scene.simulation.world.characters]
        assert ahead[0] @ (1.0, 0.0, 0.0) > 0.95 and ahead[1] @ (-1.0, 0.0, 0.0) > 0.95
        run_s(scene, 1.5)
        partners = scene.report()["contact_partners"]
        assert isinstance(partners, list) and ("c0 - c1" in partners) == met
        scene.leave()


def reaches(distance_m: float, vigour: float = 1.0, seed: int = 0, seconds: float = 9.0) -> np.ndarray:
    """How far a hand of the opponent is before its hips, m, frame by frame, while the other stays `distance_m` away."""
    partner = SparringPartner(seed)
    ahead = []
    for frame in range(int(60 * seconds)):
        partner.see(distance_m, vigour)
        for seen in partner.poll(frame / 60.0):
            at = seen.positions
            ahead.append(at[Joint.HIP_CENTER, 2] - at[[Joint.WRIST_LEFT, Joint.WRIST_RIGHT], 2].min())
    return np.array(ahead)


def test_the_opponent_strikes_only_when_you_are_near() -> None:
    far, near = reaches(NEAR_M + 0.05), reaches(NEAR_M - 0.05)
    assert near.max() > far.max() + 0.1
    struck = near > far.max() + 0.05
    assert np.sum(np.diff(struck.astype(int)) == 1) >= 2, "in nine seconds it strikes more than once"


def test_a_more_vigorous_opponent_strikes_more_often() -> None:
    guard = reaches(2.0, seconds=4.0).max() + 0.05
    calm, wild = (int(np.sum(np.diff((reaches(0.7, vigour, seconds=20.0) > guard).astype(int)) == 1)) for vigour in (0.0, 1.0))
    assert wild > calm


def test_equal_seeds_give_equal_opponents() -> None:
    assert np.array_equal(reaches(0.7, seed=5, seconds=4.0), reaches(0.7, seed=5, seconds=4.0))
    assert not np.array_equal(reaches(0.7, seed=5, seconds=4.0), reaches(0.7, seed=6, seconds=4.0))


@pytest.mark.slow
def test_twenty_rounds_are_a_fair_fight_of_the_right_length() -> None:
    rounds = first_rounds(range(20))
    print(table(rounds))
    wins = [sum(r.winner == side for r in rounds) for side in (0, 1)]
    assert min(wins) >= 3, table(rounds)
    assert 4.0 <= median(r.length_s for r in rounds) <= 30.0, table(rounds)
    assert sum(r.timed_out for r in rounds) <= 2, table(rounds)
