"""The parts of the benchmark, each for a process of its own: `python -m game.commands.benchmark_parts PART [ARGUMENTS]` prints JSON.

The parent sets the environment first: one BLAS thread, and for the Python side of drawing a Mesa that draws nothing.
"""

import json
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from game.commands.casting import Casting
from game.scenes.simulation import HANG_FRAMES, Simulation
from game.tunables import Settings

RUNS = 5
READER_RUNS = 3
FRAMES = 300
SETTLING_FRAMES = HANG_FRAMES + 60
"""The hang and the first second after the release: what comes then is the steady play."""
SIZE = (640, 360)
PLAYS: Mapping[str, str] = {"mirror": "performer:boxing", "duel": "script"}
"""The input of each scene that is measured."""

Figures = dict[str, object]


@dataclass(frozen=True)
class ChainRun:
    """One run without drawing, process CPU seconds. stage_s: wall seconds of each stage in the measured stretch."""

    entering_s: float
    first_s: float
    measured_s: float
    stage_s: Mapping[str, float]


def chain(name: str, seconds: str, *settings: str) -> Figures:
    """The whole chain without drawing, medians of RUNS runs of a scene, with `settings` as NAME=VALUE.

    Each run enters the scene, plays SETTLING_FRAMES (the hang and the first second after it), then is measured for `seconds` more
    of simulated time. Process CPU time throughout: real_time_factor of the measured stretch alone, from_start_real_time_factor with
    entering and settling in it, entering_s for opening the input, calibrating and building the world. ms_per_frame: wall
    milliseconds of each stage per measured 60 Hz frame.
    """
    frames = max(1, round(60 * float(seconds)))
    values = dict(setting.split("=", 1) for setting in settings)
    chain_run(name, values, 10)  # the first one loads and compiles
    runs = [chain_run(name, values, frames) for _ in range(RUNS)]
    factors = [frames / 60.0 / run.measured_s for run in runs]
    whole_s = (SETTLING_FRAMES + frames) / 60.0
    return {
        "real_time_factor": median(factors),
        "runs": factors,
        "from_start_real_time_factor": median(whole_s / (run.entering_s + run.first_s + run.measured_s) for run in runs),
        "entering_s": median(run.entering_s for run in runs),
        "settings": values,
        "ms_per_frame": {stage: median(1e3 * run.stage_s[stage] / frames for run in runs) for stage in runs[0].stage_s},
    }


def chain_run(name: str, values: Mapping[str, str], frames: int) -> ChainRun:
    """Enter a scene, let it settle, then measure `frames` frames."""
    times = [time.process_time()]
    scene = Casting(PLAYS[name], "original", Settings(values), 0).scene(name)
    scene.enter()
    simulation = getattr(scene, "simulation", None)
    assert isinstance(simulation, Simulation)
    times.append(time.process_time())
    for _ in range(SETTLING_FRAMES):
        scene.fixed_update()
    before = dict(simulation.stage_s)
    times.append(time.process_time())
    for _ in range(frames):
        scene.fixed_update()
    times.append(time.process_time())
    scene.leave()
    entering, first, measured = (end - start for start, end in pairwise(times))
    return ChainRun(entering, first, measured, {stage: spent - before[stage] for stage, spent in simulation.stage_s.items()})


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


def kinect_reader(seconds: str) -> Figures:
    """Share of one core that the driver needs to read a simulated Kinect in real time, the simulation's own share taken off."""
    from kinect.usb.reader_cost import reader_cost

    costs = sorted((reader_cost(float(seconds)) for _ in range(READER_RUNS)), key=lambda cost: cost.cpu_share)
    middle = costs[len(costs) // 2]
    return {"core_share": middle.cpu_share, "with_simulation": middle.with_simulation, "frames_per_s": middle.frames / middle.seconds}


def _app(name: str):
    """The loop on a window without a display, made as the play command makes it."""
    from game.app import App, Options

    settings = Settings()
    casting = Casting(PLAYS[name], "original", settings, 0)
    return App(casting.scene(name), settings, Options(headless=True, size=SIZE, quality="low"), casting)


PARTS: Mapping[str, Callable[..., Figures]] = {
    "chain": chain,
    "drawing": drawing,
    "headless": headless,
    "first_frame": first_frame,
    "kinect_reader": kinect_reader,
}


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
