"""The clockwork of every scene: hang, release, then frames of sensing, control and physics, the same each time."""

import numpy as np
import pytest

from game import rotation
from game.characters.body_plan import load_body_plan
from game.control.strategies import STRATEGIES
from game.inputs.open_input import open_input
from game.physics.hang import HANG_S
from game.scenes.fighter import Fighter, NoBodyError
from game.scenes.simulation import HANG_FRAMES, Simulation
from game.tunables import Settings
from kinect.body import BodyFrame
from tests.kinect.recordings import standing_joints

WAVING = "performer:waving"


def simulation_of(*specs: str, noise: float = 0.0, seed: int = 0, settings: Settings | None = None, distance: float = 3.0) -> Simulation:
    """One fighter a spec, `distance` apart, each odd one facing back."""
    settings = settings or Settings({"sensor.noise": noise})
    plan = load_body_plan("original")
    fighters = [
        Fighter(
            index,
            plan,
            lambda spec=spec: open_input(spec, noise=noise, seed=seed),
            settings,
            mirrored=False,
            place=(distance * index, 0.0),
            facing_rad=np.pi * (index % 2),
        )
        for index, spec in enumerate(specs)
    ]
    return Simulation(fighters, settings)


def advance(simulation: Simulation, frames: int) -> Simulation:
    for _ in range(frames):
        simulation.advance()
    return simulation


# the hang


@pytest.fixture(scope="module", params=[WAVING, "performer:bowing", "puppet"])
def hung(request) -> tuple[Simulation, list[dict]]:
    """A simulation after its hang, and what was seen in each of the hang's frames."""
    simulation = simulation_of(request.param, request.param)
    seen = []
    for _ in range(HANG_FRAMES):
        seen.append(
            {
                "root": [body.configuration[:7] for body in simulation.world.characters],
                "soles": [float(body.foot_corners[:, :, 2].min(axis=1).max()) for body in simulation.world.characters],
                "target": [fighter.target.joint_rotation for fighter in simulation.fighters],
                "active": simulation.world.meter.active,
                "hanging": simulation.hanging,
            }
        )
        simulation.advance()
    return simulation, seen


def test_the_hang_is_shorter_than_a_second_and_a_half(hung):
    assert HANG_FRAMES / 60 == HANG_S < 1.5
    assert all(frame["hanging"] for frame in hung[1]) and not hung[0].hanging


def test_the_soles_hang_less_than_eight_centimetres_high(hung):
    assert max(max(frame["soles"]) for frame in hung[1]) < 0.08


def test_the_root_is_held_in_the_hang(hung):
    _, seen = hung
    for index in range(2):
        roots = np.array([frame["root"][index] for frame in seen])
        assert np.linalg.norm(roots[:, :3] - roots[0, :3], axis=1).max() < 0.005
        turned = rotation.log(rotation.multiply(rotation.conjugate(roots[0, 3:]), roots[:, 3:]))
        assert np.linalg.norm(turned, axis=1).max() < 0.02


def test_the_hang_is_not_metered_and_all_after_it_is(hung):
    simulation, seen = hung
    assert not any(frame["active"] for frame in seen)
    assert not simulation.world.meter.unexplained_force_n.any()
    advance(simulation, 40)
    assert simulation.world.meter.active
    assert simulation.world.meter.unexplained_force_n.max() < 1e-6 and simulation.world.meter.unexplained_torque_nm.max() < 1e-6
    assert simulation.world.data.eq_active.sum() == 0
    assert simulation.world.stated_pushes == [] and simulation.world.guard_actions == 0


def test_a_recording_waits_in_its_first_frame_during_the_hang():
    simulation = simulation_of(WAVING)
    fighter = simulation.fighters[0]
    advance(simulation, 1)
    first = fighter.target
    advance(simulation, HANG_FRAMES - 1)
    assert fighter.frames_seen == 1 and fighter.target is first
    advance(simulation, 31)
    assert fighter.frames_seen == 16 and fighter.target.time_s == pytest.approx(0.5)


def test_the_pose_is_taken_up_in_the_hang():
    simulation = advance(simulation_of("performer:boxing"), HANG_FRAMES)
    body, target = simulation.world.characters[0], simulation.fighters[0].target
    error = rotation.log(rotation.multiply(rotation.conjugate(body.joint_rotation), target.joint_rotation))
    upper_body = np.linalg.norm(error[:8], axis=1)
    assert upper_body.max() < 0.15


# the clockwork


def test_time_counts_from_the_release():
    simulation = simulation_of(WAVING)
    assert simulation.time_s == pytest.approx(-HANG_S)
    advance(simulation, HANG_FRAMES + 30)
    assert simulation.time_s == simulation.clock_s == pytest.approx(0.5)
    assert simulation.world.step_count == (HANG_FRAMES + 30) * simulation.world.steps_per_frame


@pytest.mark.parametrize(("rate", "per_frame"), [("60", 1), ("120", 2), ("240", 4), ("480", 8)])
def test_control_runs_at_the_rate_that_was_set(rate, per_frame, monkeypatch):
    simulation = simulation_of(WAVING, settings=Settings({"control.rate_hz": rate, "physics.step_s": 1.0 / 480.0}))
    asked = []
    monkeypatch.setattr(Fighter, "control", lambda self, world, dt: asked.append(dt))
    simulation.advance()
    assert asked == pytest.approx([1.0 / float(rate)] * per_frame)


def test_the_last_two_poses_are_kept_for_drawing_and_do_not_change_afterwards():
    simulation = advance(simulation_of(WAVING), HANG_FRAMES + 20)
    shown = simulation.current[0][0]
    copy = shown.copy()
    simulation.advance()
    np.testing.assert_array_equal(shown, copy)
    np.testing.assert_array_equal(simulation.previous[0][0], copy)
    assert not np.array_equal(simulation.current[0][0], copy)


def test_everybody_can_hang_again():
    simulation = advance(simulation_of(WAVING, WAVING), HANG_FRAMES + 30)
    simulation.hang_again()
    assert simulation.hanging and not simulation.world.meter.active
    hanging = [body.configuration[:3] for body in simulation.world.characters]
    advance(simulation, HANG_FRAMES + 60)
    assert simulation.time_s == pytest.approx(1.0) and simulation.clock_s == pytest.approx(2.5)
    assert simulation.world.meter.unexplained_force_n.max() < 1e-6
    for body, place in zip(simulation.world.characters, hanging, strict=True):
        assert body.com_height() > 0.85
        assert np.linalg.norm(body.configuration[:2] - place[:2]) < 0.3


def test_what_it_costs_is_split_into_stages():
    simulation = advance(simulation_of(WAVING), 20)
    assert set(simulation.stage_s) == {"target", "control", "physics"}
    assert all(spent > 0.0 for spent in simulation.stage_s.values())


# repeatable


def sha(*specs: str, frames: int = HANG_FRAMES + 30, **options) -> str:
    return advance(simulation_of(*specs, **options), frames).world.state_sha256


def test_equal_settings_and_seed_give_an_equal_hash():
    assert sha(WAVING, noise=0.5, seed=3) == sha(WAVING, noise=0.5, seed=3)


def test_another_seed_clip_or_setting_gives_another_hash():
    hashes = [
        sha(WAVING, noise=0.5, seed=3),
        sha(WAVING, noise=0.5, seed=4),
        sha("performer:bowing", noise=0.5, seed=3),
        sha(WAVING, seed=3, settings=Settings({"sensor.noise": 0.5, "pd.kp_hat": 900.0})),
    ]
    assert len(set(hashes)) == 4


def test_a_fighter_far_away_does_not_change_the_other_bit_for_bit():
    """The whole chain, through hang and release: only what the second sees differs."""

    def first_fighter(other: str) -> list[np.ndarray]:
        simulation = simulation_of(WAVING, other)
        states = []
        for _ in range(HANG_FRAMES + 60):
            simulation.advance()
            body = simulation.world.characters[0]
            states.append(np.concatenate((body.configuration, body.velocity)))
        return states

    np.testing.assert_array_equal(first_fighter("performer:bowing"), first_fighter("performer:boxing"))


# changed while it plays


def test_every_strategy_can_be_put_in_while_it_plays():
    settings = Settings()
    simulation = advance(simulation_of(WAVING, settings=settings), HANG_FRAMES + 30)
    for name in (*STRATEGIES, *reversed(list(STRATEGIES))):
        before = simulation.world.data.qpos.copy()
        settings.set("balance.strategy", name)
        np.testing.assert_array_equal(before, simulation.world.data.qpos)
        simulation.advance()
        assert simulation.fighters[0].strategy_name == name
        assert np.abs(simulation.world.data.qpos - before).max() < 0.1, "a sixtieth of a second of motion and no jump"
    assert simulation.world.meter.unexplained_force_n.max() < 1e-6 and simulation.world.guard_actions == 0
    assert simulation.world.characters[0].com_height() > 0.85


class Blind:
    """A source of frames in which nobody is to be seen, or only now and then."""

    status = "Blind source."
    length_s = 2.0

    def __init__(self, sound_until_s: float = 0.0) -> None:
        self._sound_until_s, self._next = sound_until_s, 0

    def poll(self, until_s: float) -> list[BodyFrame]:
        frames = []
        while self._next / 30.0 <= min(until_s, self.length_s) + 1e-9:
            time_s = self._next / 30.0
            joints = standing_joints() if time_s < self._sound_until_s else np.full((20, 3), np.nan)
            frames.append(BodyFrame(time_s, joints, np.ones(20) if time_s < self._sound_until_s else np.zeros(20)))
            self._next += 1
        return frames

    def close(self) -> None:
        pass


def test_an_input_without_anybody_is_refused_in_words():
    with pytest.raises(NoBodyError, match=r"^Blind source\. No frame shows a whole body"):
        Fighter(0, load_body_plan("original"), Blind, Settings(), mirrored=False)


def test_frames_without_a_body_hold_the_last_good_target_and_say_so():
    settings = Settings()
    fighter = Fighter(0, load_body_plan("original"), lambda: Blind(0.7), settings, mirrored=False)
    simulation = advance(Simulation([fighter], settings), HANG_FRAMES + 50)
    held = fighter.target
    assert 0.5 < held.time_s < 0.7
    advance(simulation, 20)
    assert fighter.target is held and fighter.fault
    assert simulation.world.guard_actions == 0 and simulation.world.characters[0].com_height() > 0.8
