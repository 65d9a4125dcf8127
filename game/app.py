"""The one loop of the game, in a window or headless: events, fixed updates, picture, overlay."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from game.actions import Actions, Staged
from game.inputs.steering import Controls, Steering
from game.output import Output
from game.pacing import UPDATE_S, StepPace, WallPace, is_over
from game.picture import Picture
from game.progress import Progress
from game.scenes.scene import Scene
from game.stage_times import StageTimes
from game.tunables import Settings

HEADLESS_S = 20.0
"""How long a headless run of a scene lasts that never ends by itself, where `seconds` does not say."""


@dataclass(frozen=True)
class Options:
    """How to play. size: pixels headless, points in a window; quality: low, medium or high, None for what suits the machine;
    seconds: simulated, None for as long as it takes; picture, video: files to write; fps: of the video, 60 or 30 (one or two fixed
    updates a picture); overlay: draw it; scenes, inputs: what the menu offers; settings_path: where Save and Load go, None for the
    platform's own place."""

    headless: bool = False
    size: tuple[int, int] = (1280, 720)
    quality: str | None = None
    seconds: float | None = None
    picture: Path | None = None
    video: Path | None = None
    fps: int = 60
    overlay: bool = True
    scenes: tuple[str, ...] = ()
    inputs: tuple[str, ...] = ()
    input_spec: str = ""
    settings_path: Path | None = None
    output_dir: Path = Path("topple-output")


@dataclass(frozen=True)
class AppReport:
    """What a run was. stage_ms: median milliseconds of update, draw, overlay, swap; files: written; gl: window, egl or osmesa."""

    frames: int
    updates: int
    simulated_s: float
    wall_s: float
    stage_ms: Mapping[str, float]
    gl: str
    files: tuple[Path, ...] = ()


@dataclass
class App:
    """The loop, one picture frame at a time. Raises NoPicture where nothing can be drawn on this machine.

    controls: what keys and gamepad steer, or a function that gives it, None for nothing; clock: seconds, paces a window and never
    changes what an update does; on_request(kind, value) answers "scene" and "input" with a new Staged and raises ValueError with a
    sentence where it cannot.
    """

    scene: Scene
    settings: Settings
    options: Options = field(default_factory=Options)
    controls: Controls = None
    on_request: Callable[[str, str], Staged | None] | None = None
    clock: Callable[[], float] = time.perf_counter
    renderer: Any = None
    steering: Steering | None = None

    def __post_init__(self) -> None:
        options = self.options
        stepped = options.headless or options.video is not None
        self.pace: WallPace | StepPace = StepPace(max(1, round(60 / options.fps))) if stepped else WallPace()
        self.times = StageTimes()
        self.frames = self.updates = 0
        self.picture = Picture(self.scene, self.settings, options, self.renderer)
        try:
            self.output = Output(options.picture, options.video, options.fps, self.picture.window)
            self.actions = Actions(self, self.steering or _puppet_steering())
            self.scene.enter()
        except BaseException:
            self.scene.leave()
            self.picture.close()
            raise
        self._began_s = self.clock()

    @property
    def now_s(self) -> float:
        """Seconds since the loop began: of the clock in a window, of the updates where there is no clock."""
        return self.updates * UPDATE_S if isinstance(self.pace, StepPace) else self.clock() - self._began_s

    @property
    def over(self) -> bool:
        """Nothing is left to do: the run is at its end, or the player has had enough."""
        if self.picture.window.should_close or self.actions.quit:
            return True
        return is_over(self.scene, self.seconds) if self.options.headless else self._timed_out

    @property
    def seconds(self) -> float | None:
        """The end of a run nobody watches: as asked, else 20 s of what never ends by itself; None up to the recording's end."""
        endless = getattr(self.scene, "endless", False)
        return HEADLESS_S if self.options.seconds is None and endless else self.options.seconds

    @property
    def _timed_out(self) -> bool:
        return self.options.seconds is not None and self.scene.time_s >= self.options.seconds - 1e-6

    def frame(self) -> None:
        """One picture frame: events, the fixed updates that are due, the picture, the overlay."""
        self.picture.window.poll_events()
        self.actions.obey()
        due = self.pace.due(self.clock(), self.actions.paused)
        with self.times.measure("update"):
            for _ in range(due.updates + self.actions.take_advances()):
                if self.over:
                    break
                self.scene.fixed_update()
                self.updates += 1
        if min(self.picture.window.framebuffer_size) > 0:  # a minimised window has no pixels
            self._show(due.blend)
        with self.times.measure("swap"):
            self.picture.window.swap()
        self.frames += 1

    def _show(self, blend: float) -> None:
        with self.times.measure("draw"):
            self.picture.draw(self.scene, blend, self.actions.frame_s(self.now_s))
        if self.picture.overlay is not None:
            with self.times.measure("overlay"):
                self.picture.overlay.draw(self.actions.view())
        self.output.frame()

    def close(self) -> AppReport:
        """End the run: write the picture, finish the video, give back the window. Calling it twice is harmless."""
        files = self.output.close()
        self.scene.leave()
        self.picture.close()
        wall_s = self.clock() - self._began_s
        return AppReport(
            self.frames, self.updates, self.updates * UPDATE_S, wall_s, self.times.medians(), self.picture.window.kind, tuple(files)
        )


def _puppet_steering() -> Steering:
    from game.inputs.puppet_controls import controls_from_gamepad, controls_from_keys

    return Steering(controls_from_keys, controls_from_gamepad)


def play(
    scene: Scene,
    settings: Settings,
    options: Options,
    *,
    controls: Controls = None,
    on_request: Callable[[str, str], Staged | None] | None = None,
    clock: Callable[[], float] = time.perf_counter,
) -> AppReport:
    """Play a scene until it is over or the player quits; headless with a progress bar on stderr. Raises NoPicture."""
    app = App(scene, settings, options, controls, on_request, clock)
    progress = Progress("topple", app.seconds, start_s=app.scene.time_s) if options.headless else None
    try:
        while not app.over:
            app.frame()
            if progress is not None:
                progress.show(app.scene.time_s)
    finally:
        if progress is not None:
            progress.close()
        report = app.close()
    return report
