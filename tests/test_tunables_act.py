"""Every tunable does something: moved by 20 %, it changes the state hash, the picture or a named readout.

A number moves by a fifth of its value (of its range where the default is 0), a switch flips, a choice takes another word. What takes
effect at the next start is set before the scene is entered; everything else while it plays, as a slider would.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from game.render.camera import Camera
from game.render.gl_window import NoPicture, open_gl
from game.scenes.duel import Duel
from game.scenes.registry import PlayableScene
from game.tunables import TUNABLES, Settings, Tunable, Value
from kinect.body import Joint
from kinect.clip import checked_clip, write_clip
from tests.kinect.recordings import moving_clip
from tests.scenes.staged import make_scene, run_s


@dataclass(frozen=True)
class Context:
    """A situation in which a tunable matters: scene, input (`{clip}`: the leaping recording), other settings, seconds after the hang.

    turned_s: when the tunable is turned, if it need not be set before the start; round_s: how old the round is made then.
    """

    scene: str = "mirror"
    spec: str = "performer:boxing"
    others: tuple[tuple[str, Value], ...] = ()
    seconds: float = 1.0
    turned_s: float = 0.0
    round_s: float = 0.0


BOXING = Context()
LEAPING = Context(spec="clip:{clip}")


def seen_by_a_kinect(motion: str, seconds: float, *others: tuple[str, Value]) -> Context:
    """A performer with a real sensor's noise, from the start on."""
    return Context(spec=f"performer:{motion}", others=(("sensor.noise", 1.0), *others), seconds=seconds, turned_s=-0.9)


BY_ANKLES = (("balance.strategy", "virtual-actuation"),)
STEPPING, BOWING = seen_by_a_kinect("stepping", 2.4), seen_by_a_kinect("bowing", 2.2)
CONTEXTS: Mapping[str, Context] = {
    "intake.jump_limit_m": LEAPING,
    "ik.target_clamp_m": LEAPING,
    "balance.ankle_clamp_rad": Context(spec="clip:{clip}", others=(("balance.ankle_clamp_rad", 0.02), *BY_ANKLES)),
    # what the PD law and the older strategies read; whole-body has tunables of its own
    **dict.fromkeys(("pd.kp_hat", "pd.ratio", "pd.gravity_feedforward", "balance.w_com", "balance.w_vel"), Context(others=BY_ANKLES)),
    **dict.fromkeys(("balance.com_stiffness", "balance.com_damping"), Context(others=BY_ANKLES)),
    **dict.fromkeys(("balance.pelvis_stiffness", "balance.pelvis_damping"), Context(others=BY_ANKLES)),
    **dict.fromkeys(("gate.floor_time_s", "gate.lock", "gate.plant_time_s"), STEPPING),
    **dict.fromkeys(("gate.fade_time_s", "gate.on", "gate.buffer_s"), STEPPING),
    "gate.knees": LEAPING,
    "gate.up_m": seen_by_a_kinect("stepping", 3.6, ("gate.up_m", 0.08), ("gate.foot_speed_m_s", 3.0)),
    "gate.down_m": seen_by_a_kinect("jump", 2.5, ("gate.down_m", 0.015)),
    "gate.foot_speed_m_s": seen_by_a_kinect("stepping", 3.6),
    **dict.fromkeys(("gate.pelvis", "gate.leg_slack"), BOWING),
    # values near the limit: a fifth more or less decides
    "gate.jumps": seen_by_a_kinect("jump", 2.5, ("gate.push_off_m_s", 2.0)),
    "gate.push_off_m_s": seen_by_a_kinect("jump", 2.5, ("gate.push_off_m_s", 1.1)),
    "gate.flight_limit_s": seen_by_a_kinect("jump", 2.5, ("gate.flight_limit_s", 0.13)),
    "gate.tilt_rad_s": seen_by_a_kinect("bowing", 2.2, ("gate.tilt_rad_s", 1.0)),
    "gate.turn_rad_s": seen_by_a_kinect("boxing", 2.2, ("gate.turn_rad_s", 0.6)),
    "gate.twist_rad": seen_by_a_kinect("boxing", 2.7, ("gate.twist_rad", 0.15)),
    # a body of ordinary strength boxes without using all of it
    "whole_body.strength": Context(others=(("whole_body.strength", 0.5),)),
    "whole_body.get_up": Context(spec="performer:jump", others=(("whole_body.strength", 0.2),), seconds=6.0),
    "physics.self_collision": Context(spec="clip:{clip}", others=(("intake.smoothing", 0.0), *BY_ANKLES)),
    "duel.strategy": Context("duel", "script", seconds=0.5),
    "duel.distance_m": Context("duel", "script", seconds=0.1),
    # the opponent makes its first plan while it still hangs
    "duel.opponent_vigour": Context("duel", "script", seconds=2.0, turned_s=-0.5),
    "duel.round_limit_s": Context("duel", "script", (("duel.round_limit_s", 5.0),), seconds=0.3, round_s=4.8),
}
"""Where the plain context, a boxing performer in the mirror, would not show it."""

WITH_DEPTH_ONLY = ("layer.points", "layer.depth_picture")
"""Turned by tests/scenes/test_depth_layer.py, where there is a depth camera."""
PICTURE = tuple(name for name, t in TUNABLES.items() if t.group in ("picture", "layer") and name not in WITH_DEPTH_ONLY)
STATE = tuple(name for name in TUNABLES if name not in PICTURE + WITH_DEPTH_ONLY)


def moved(tunable: Tunable, value: Value) -> Value:
    """`value` moved by 20 % in the direction that the tunable's range allows."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, str):
        return next(choice for choice in tunable.choices if choice != value)
    step = 0.2 * (abs(value) if value else tunable.high - tunable.low)
    return value + step if value + step <= tunable.high else value - step


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A recording that leaps: all of the person by 0.38 m (more than 0.35, less than 0.42), then a hand up, the other into the
    trunk and a knee bent back."""
    still = moving_clip()
    positions = still.positions.copy()
    positions[15:, :, 0] += 0.38
    after = positions[20:]
    after[:, [Joint.WRIST_LEFT, Joint.HAND_LEFT], 1] += 0.6
    after[:, [Joint.WRIST_RIGHT, Joint.HAND_RIGHT]] = after[:, [Joint.SPINE]]
    after[:, Joint.ELBOW_RIGHT] = 0.5 * (after[:, Joint.SPINE] + after[:, Joint.SHOULDER_RIGHT])
    after[:, Joint.KNEE_LEFT, 2] += 0.12
    path = tmp_path_factory.mktemp("clips") / "leap.npz"
    write_clip(path, checked_clip(path.name, positions, still.confidence, still.t, None, None, {}))
    return str(path)


def outcome(context: Context, clip: str, name: str | None) -> dict[str, object]:
    """What a run of the context leads to, with tunable `name` moved: the state hash and readouts, stage times and rounding left out."""
    settings = Settings(dict(context.others))
    tunable = None if name is None else TUNABLES[name]

    def turn() -> None:
        if tunable is not None:
            settings.set(tunable.name, moved(tunable, settings.get(tunable.name)))

    if tunable is not None and tunable.restart:
        turn()
    scene = make_scene(context.scene, context.spec.format(clip=clip), settings)
    scene.enter()
    run_s(scene, context.turned_s)
    if tunable is not None and not tunable.restart:
        turn()
    if context.round_s:
        assert isinstance(scene, Duel)
        scene.simulation.frame = round(60 * context.round_s)
    run_s(scene, context.seconds)
    readouts = {key: value for key, value in scene.readouts().items() if not key.endswith("_ms") and key != "unexplained_force_n"}
    scene.leave()
    report = scene.report()
    return {"state_sha256": report["state_sha256"], "rounds": report.get("rounds"), **readouts}


@cache
def unmoved(context: Context, clip: str) -> Mapping[str, object]:
    return outcome(context, clip, None)


@pytest.mark.parametrize("name", STATE)
def test_a_tunable_of_the_method_changes_the_state_or_a_readout(name: str, clip: str) -> None:
    context = CONTEXTS.get(name, BOXING)
    before, after = unmoved(context, clip), outcome(context, clip, name)
    assert {key for key in before if before[key] != after[key]}, f"{name} does nothing"


def test_an_unmoved_run_is_the_same_again(clip: str) -> None:
    assert outcome(BOXING, clip, None) == unmoved(BOXING, clip)


Shoot = Callable[[], NDArray[np.uint8]]


@pytest.fixture(scope="module")
def studio() -> Iterator[tuple[Settings, Shoot]]:
    """The settings of a scene in mid-motion, and a function that draws it small with them."""
    from game.render.capture import read_pixels
    from game.render.renderer import Renderer

    size = (192, 108)
    try:
        window = open_gl(*size, "tunables", headless=True)
    except NoPicture as missing:
        pytest.skip(str(missing))
    settings = Settings()
    scene: PlayableScene = make_scene("mirror", "performer:boxing", settings)
    scene.enter()
    run_s(scene, 0.5)
    renderer = Renderer(window.ctx, "medium", settings)
    camera = Camera(next(iter(scene.cameras().values())))

    def shoot() -> NDArray[np.uint8]:
        renderer.render(scene.drawables(1.0), camera, window.screen, size)
        assert window.ctx.error == "GL_NO_ERROR"
        return read_pixels(window.ctx.screen, size).copy()

    yield settings, shoot
    renderer.release()
    scene.leave()
    window.close()


@pytest.mark.parametrize("name", PICTURE)
def test_a_tunable_of_the_look_changes_the_picture(name: str, studio: tuple[Settings, Shoot]) -> None:
    settings, shoot = studio
    settings.reset()
    before, again = shoot(), shoot()
    assert np.array_equal(before, again)
    settings.set(name, moved(TUNABLES[name], settings.get(name)))
    after = shoot()
    settings.reset()
    assert not np.array_equal(before, after), f"{name} does nothing"
    assert np.array_equal(before, shoot()), f"{name} leaves something behind"


def test_every_context_belongs_to_a_tunable() -> None:
    assert set(CONTEXTS) <= set(STATE)
