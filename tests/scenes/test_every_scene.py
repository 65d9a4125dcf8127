"""What holds for every scene there is, whoever plays: the contract, determinism, finite and unaliased results."""

import dataclasses
import math
from collections.abc import Iterator, Mapping

import numpy as np
import pytest
from numpy.typing import NDArray

from game.drawables import MATERIALS, Boxes, Capsules, Label, Layer, Lines, Points
from game.scenes.registry import SCENES, PlayableScene
from game.tunables import TUNABLES, Settings
from tests.door.the_door import numbers_in
from tests.scenes.staged import look_at, make_scene, run_s

EVERY_LAYER = {name: True for name, t in TUNABLES.items() if t.group == "layer"}
FRAMES = 100
"""Through the hang and half a second beyond."""


def played(name: str, frames: int = FRAMES, seed: int = 0, values: Mapping[str, object] | None = None) -> PlayableScene:
    """The scene `name` with the scripted puppet, so many frames after it was entered."""
    scene = make_scene(name, "script", Settings(values), seed)
    scene.enter()
    for _ in range(frames):
        scene.fixed_update()
    return scene


def arrays_of(layers: tuple[Layer, ...]) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Every array in the layers, with the place where it stands."""
    for layer in layers:
        for number, drawable in enumerate(layer.drawables):
            for field in dataclasses.fields(drawable):
                value = getattr(drawable, field.name)
                if isinstance(value, np.ndarray):
                    yield f"{layer.name}.{number}.{field.name}", value


def fighter_boxes(layers: tuple[Layer, ...]) -> Boxes:
    """The fifteen boxes of the first fighter."""
    boxes = next(layer for layer in layers if layer.name == "fighter0").drawables[0]
    assert isinstance(boxes, Boxes)
    return boxes


@pytest.fixture(scope="module", params=sorted(SCENES))
def name(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture(scope="module")
def scene(name: str) -> Iterator[PlayableScene]:
    """The scene half a second after the hang, with every layer switched on. Tests only look at it."""
    scene = make_scene(name, "script", Settings(EVERY_LAYER))
    scene.enter()
    for _ in range(FRAMES):
        scene.fixed_update()
    yield scene
    scene.leave()


class TestEveryScene:
    def test_it_goes_by_the_name_it_is_registered_under(self, name: str, scene: PlayableScene) -> None:
        assert scene.name == name

    def test_time_is_a_sixtieth_of_a_second_each_update_and_negative_in_the_hang(self, name: str) -> None:
        scene = make_scene(name)
        scene.enter()
        start = scene.time_s
        assert -1.5 < start < 0.0, "the hang lasts less than a second and a half"
        for update in range(1, 4):
            scene.fixed_update()
            assert scene.time_s == pytest.approx(start + update / 60.0)
        scene.leave()

    def test_a_live_input_never_finishes_and_a_recording_does(self, name: str, scene: PlayableScene) -> None:
        assert scene.endless and not scene.finished
        recorded = make_scene(name, "performer:jump")
        recorded.enter()
        assert not recorded.endless and not recorded.finished
        recorded.leave()

    def test_equal_settings_and_seed_give_equal_states(self, name: str) -> None:
        noisy = {"sensor.noise": 0.3, "sensor.outliers": 0.3}
        first, again, other = (played(name, seed=seed, values=noisy) for seed in (3, 3, 4))
        assert first.report()["state_sha256"] == again.report()["state_sha256"]
        assert first.report()["state_sha256"] != other.report()["state_sha256"]

    def test_asking_and_drawing_change_nothing(self, name: str, scene: PlayableScene) -> None:
        asked = make_scene(name)
        asked.enter()
        for frame in range(FRAMES):
            asked.fixed_update()
            if frame % 5 == 0:
                look_at(asked)
        assert asked.report()["state_sha256"] == scene.report()["state_sha256"]

    def test_entering_again_begins_anew(self, name: str, scene: PlayableScene) -> None:
        twice = played(name, frames=7)
        twice.enter()
        twice.enter()
        assert twice.time_s < 0.0
        for _ in range(FRAMES):
            twice.fixed_update()
        assert twice.report()["state_sha256"] == scene.report()["state_sha256"]
        assert twice.score() == scene.score()

    def test_leaving_twice_and_leaving_before_entering_are_harmless(self, name: str) -> None:
        scene = make_scene(name)
        scene.leave()
        scene.enter()
        scene.leave()
        scene.leave()
        scene.enter()
        scene.fixed_update()
        scene.leave()

    def test_everything_drawn_is_finite_and_well_formed(self, scene: PlayableScene) -> None:
        for layer in scene.drawables(0.5):
            assert 0.0 < layer.opacity <= 1.0
            for drawable in layer.drawables:
                self.check(drawable)
        for place, array in arrays_of(scene.drawables(0.5)):
            assert array.dtype == np.float64, place
            assert np.isfinite(array).all(), place

    @staticmethod
    def check(drawable: object) -> None:
        """Shapes agree, sizes are positive, orientations are unit quaternions, colours lie in range."""
        if isinstance(drawable, Label):
            assert drawable.position.shape == (3,) and drawable.text
            return
        if isinstance(drawable, Boxes):
            n = len(drawable.position)
            assert (drawable.position.shape, drawable.orientation.shape, drawable.half_size.shape) == ((n, 3), (n, 4), (n, 3))
            assert np.linalg.norm(drawable.orientation, axis=1) == pytest.approx(np.ones(n), abs=1e-9)
            assert (drawable.half_size > 0.0).all() and drawable.material in MATERIALS
        elif isinstance(drawable, Capsules):
            n = len(drawable.start)
            assert (drawable.start.shape, drawable.end.shape, drawable.radius.shape) == ((n, 3), (n, 3), (n,))
            assert (drawable.radius > 0.0).all()
        elif isinstance(drawable, Lines):
            n = len(drawable.points)
            assert drawable.points.shape == (n, 2, 3) and drawable.width_px > 0.0
        else:
            assert isinstance(drawable, Points)
            n = len(drawable.position)
            assert drawable.position.shape == (n, 3) and drawable.diameter_px > 0.0
        assert n > 0 and drawable.colour.shape == (n, 4)
        assert (drawable.colour >= 0.0).all() and (drawable.colour <= 1.0).all()

    def test_what_was_handed_out_stays_as_it_was(self, name: str) -> None:
        scene = played(name, frames=75, values=EVERY_LAYER)
        shown, plots = scene.drawables(1.0), scene.plots()
        copies = [array.copy() for _, array in arrays_of(shown)]
        lines = [np.array(axis) for plot in plots for series in plot.series.values() for axis in series]
        for _ in range(5):
            scene.fixed_update()
            later = scene.drawables(1.0)
        changed = [place for (place, array), copy in zip(arrays_of(shown), copies, strict=True) if not np.array_equal(array, copy)]
        assert changed == []
        after = [axis for plot in plots for series in plot.series.values() for axis in series]
        assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(lines, after, strict=True))
        first, last = (fighter_boxes(layers).position for layers in (shown, later))
        assert not np.array_equal(first, last)

    def test_a_drawing_in_between_lies_between_the_two_states(self, name: str) -> None:
        scene = played(name, frames=90)

        def first_body(blend: float) -> NDArray[np.float64]:
            return fighter_boxes(scene.drawables(blend)).position

        before, between, after = (first_body(blend) for blend in (0.0, 0.25, 1.0))
        assert between == pytest.approx(0.75 * before + 0.25 * after, abs=1e-12)
        assert np.abs(after - before).max() > 1e-6
        scene.fixed_update()
        assert first_body(0.0) == pytest.approx(after, abs=1e-12), "the next update begins where this one ended"

    def test_readouts_are_finite_numbers_or_words(self, scene: PlayableScene) -> None:
        readouts = scene.readouts()
        assert readouts
        for name, value in readouts.items():
            assert isinstance(value, str) or (isinstance(value, float) and math.isfinite(value)), name

    def test_plots_are_finite_curves(self, scene: PlayableScene) -> None:
        plots = scene.plots()
        assert plots and len({plot.title for plot in plots}) == len(plots)
        for plot in plots:
            assert plot.unit and plot.kind in ("time", "plan", "bars") and plot.series
            assert set(plot.looks) <= set(plot.series)
            for x, y in plot.series.values():
                assert x.shape == y.shape and x.ndim == 1 and len(x) > 0
                assert np.isfinite(x).all()
                # over time there may be stretches of which nothing was to be shown
                assert np.isfinite(y).any() and not np.isinf(y).any() if plot.kind == "time" else np.isfinite(y).all()
                assert plot.kind == "plan" or (np.diff(x) > 0.0).all()

    def test_plots_may_be_asked_for_before_anything_happened(self, name: str) -> None:
        scene = make_scene(name)
        scene.enter()
        assert isinstance(scene.plots(), tuple)
        scene.leave()

    def test_it_says_something_and_names_its_keys(self, scene: PlayableScene) -> None:
        assert all(message and message[0].isupper() and message.endswith(".") for message in scene.messages())
        assert scene.messages()
        assert all(key and does for key, does in scene.help_keys())

    def test_its_cameras_look_at_something_in_the_room(self, scene: PlayableScene) -> None:
        assert scene.cameras()
        for hint in scene.cameras().values():
            assert 1.0 < math.dist(hint.eye, hint.target) < 6.0
            assert hint.eye[2] > 0.1 and 20.0 <= hint.fov_deg <= 90.0

    def test_its_report_holds_finite_numbers_and_what_every_report_must(self, name: str, scene: PlayableScene) -> None:
        report = scene.report()
        assert (report["scene"], report["input"], report["seed"]) == (name, "script", 0)
        assert {"clip_s", "state_sha256", "real_time_factor", "ms_per_frame", "guard_actions", "warnings", "settings"} <= set(report)
        assert all(math.isfinite(number) for number in numbers_in(report))

    def test_nothing_but_contact_and_joints_acts(self, scene: PlayableScene) -> None:
        report = scene.report()
        assert report["pushes"] == []
        assert isinstance(report["unexplained_force_max_n"], float) and report["unexplained_force_max_n"] < 1e-6
        assert isinstance(report["unexplained_torque_max_nm"], float) and report["unexplained_torque_max_nm"] < 1e-6
        assert (report["guard_actions"], report["warnings"]) == (0, 0)


def test_a_scene_of_a_recording_ends_with_it(name: str) -> None:
    scene = make_scene(name, "performer:jump")
    scene.enter()
    length = run_s(scene, 0.1).report()["clip_s"]
    assert isinstance(length, float) and length == pytest.approx(21.2, abs=0.05)
    scene.leave()
