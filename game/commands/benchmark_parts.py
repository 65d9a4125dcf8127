"""The parts of the benchmark, each for a process of its own: `python -m game.commands.benchmark_parts PART [ARGUMENTS]` prints JSON.

The parent sets the environment first: one BLAS thread, and for the Python side of drawing a Mesa that draws nothing.
"""

import json
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from statistics import median

from game.commands.casting import Casting
from game.scenes.simulation import Simulation
from game.tunables import Settings

RUNS = 5
FRAMES = 300
SIZE = (640, 360)
PLAYS: Mapping[str, str] = {"mirror": "performer:boxing", "duel": "script"}
"""The input of each scene that is measured."""

Figures = dict[str, object]


def chain(name: str, seconds: str) -> Figures:
    """The whole chain without drawing: medians of RUNS runs of a scene for `seconds` of simulated time, the hang included.

    real_time_factor: simulated seconds over process CPU seconds; ms_per_frame: wall milliseconds of each stage per 60 Hz frame.
    """
    factors: list[float] = []
    stages: dict[str, list[float]] = {}
    frames = max(1, round(60 * float(seconds)))
    for run in range(RUNS + 1):
        scene = Casting(PLAYS[name], "original", Settings(), 0).scene(name)
        scene.enter()
        start = time.process_time()
        for _ in range(frames if run else 10):
            scene.fixed_update()
        spent = time.process_time() - start
        simulation = getattr(scene, "simulation", None)
        assert isinstance(simulation, Simulation)
        scene.leave()
        if run == 0:
            continue  # the first one loads and compiles
        factors.append(frames / 60.0 / spent)
        for stage, taken_s in simulation.stage_s.items():
            stages.setdefault(stage, []).append(1e3 * taken_s / frames)
    return {"real_time_factor": median(factors), "runs": factors, "ms_per_frame": {stage: median(ms) for stage, ms in stages.items()}}


def drawing() -> Figures:
    """Process CPU milliseconds of drawing one picture of two fighters and the room, `low`; the Python side where Mesa draws nothing."""
    from game.render.benchmark import measure

    timing = measure("low", SIZE, FRAMES)
    return {"renderer": timing.renderer_name, "render_ms": timing.python_ms, "posing_ms": timing.scene_ms}


def headless(name: str) -> Figures:
    """Median wall milliseconds of FRAMES whole frames (update, picture, overlay) headless in `low`, each finished, nothing encoded."""
    app = _app(name)
    taken: list[float] = []
    for _ in range(FRAMES + 1):
        start = time.perf_counter()
        app.frame()
        app.picture.window.ctx.finish()
        taken.append(1e3 * (time.perf_counter() - start))
    renderer = app.picture.window.ctx.info["GL_RENDERER"]
    report = app.close()
    ms = median(taken[1:])
    return {"renderer": renderer, "gl": report.gl, "ms": ms, "frames_per_s": 1e3 / ms, "stage_ms": dict(report.stage_ms)}


def first_frame(name: str) -> Figures:
    """Draw one frame and say when it was finished (s since the epoch), for a parent that knows when it started this process."""
    app = _app(name)
    app.frame()
    app.picture.window.ctx.finish()
    finished = time.time()
    app.close()
    return {"finished_s": finished}


def _app(name: str):
    """The loop on a window without a display, made as the play command makes it."""
    from game.app import App, Options

    settings = Settings()
    casting = Casting(PLAYS[name], "original", settings, 0)
    return App(casting.scene(name), settings, Options(headless=True, size=SIZE, quality="low"), casting)


PARTS: Mapping[str, Callable[..., Figures]] = {"chain": chain, "drawing": drawing, "headless": headless, "first_frame": first_frame}


def main(words: Sequence[str]) -> None:
    """Measure the part that the words name and print its figures; where nothing can be drawn, the reason."""
    try:
        figures = PARTS[words[0]](*words[1:])
    except RuntimeError as fault:
        # named, not imported: what draws may be missing on this machine
        if type(fault).__name__ != "NoPicture":
            raise
        figures = {"no_picture": str(fault)}
    print(json.dumps(figures))


if __name__ == "__main__":
    main(sys.argv[1:])
