"""How long pictures take on this machine: `python -m game.render.benchmark [low|medium|high] [WIDTHxHEIGHT] [PICTURES]`.

Two fighters and the room, headless, encoding excluded. With GALLIUM_NOOP=1 Mesa draws nothing, and what is left is the Python side.
"""

import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np

from game import rotation
from game.characters.body_plan import BodyPlan, load_body_plan
from game.characters.skeleton import PARTS
from game.drawables import Layer
from game.render.camera import Camera
from game.render.gl_window import GLWindow, open_gl
from game.render.renderer import Renderer
from game.scenes.costume import dressed
from game.scenes.living_room import living_room, room_cameras
from game.tunables import Settings


@dataclass(frozen=True)
class Timing:
    """Milliseconds. open, build: opening the context, making the renderer; first: the first picture; frame: median of the others;
    frame_cpu: process CPU time of a whole picture, all threads.

    python: process CPU time of one `Renderer.render`, all threads; scene: the same for making two dressed fighters.
    """

    renderer_name: str
    open_ms: float
    build_ms: float
    first_ms: float
    frame_ms: float
    frame_cpu_ms: float
    python_ms: float
    scene_ms: float


def two_fighters(plan: BodyPlan, turn_rad: float) -> tuple[Layer, ...]:
    """Two dressed characters an arm's length apart, turned a little, so that every picture is new."""
    layers = []
    for index, (x, facing) in enumerate(((-0.4, 0.0), (0.45, np.pi))):
        orientation = np.tile(rotation.about_z(facing + turn_rad), (len(PARTS), 1))
        position = rotation.rotate(orientation, plan.centre) + (x, 0.0, 0.0)
        layers.append(Layer(f"fighter{index}", dressed(plan, position, orientation, index)))
    return tuple(layers)


def measure(quality: str, size: tuple[int, int], pictures: int) -> Timing:
    """Draw `pictures` pictures of (width, height) pixels."""
    start = time.perf_counter()
    window = open_gl(*size, "benchmark", headless=True)
    opened = time.perf_counter()
    renderer = Renderer(window.ctx, quality, Settings())
    built = time.perf_counter()
    camera = Camera(room_cameras()["mirror"])
    plan = load_body_plan("original")
    walls, whole, cpu, scene = [], [], [], []
    for i in range(pictures + 1):
        begun, begun_cpu = time.perf_counter(), time.process_time()
        fighters = two_fighters(plan, 0.3 * np.sin(0.1 * i))
        posed_cpu = time.process_time()
        renderer.render((*living_room(), *fighters), camera, window.screen, size)
        drawn_cpu = time.process_time()
        _finish(window)
        walls.append(time.perf_counter() - begun)
        whole.append(time.process_time() - begun_cpu)
        cpu.append(drawn_cpu - posed_cpu)
        scene.append(posed_cpu - begun_cpu)
    name = window.ctx.info["GL_RENDERER"]
    renderer.release()
    window.close()
    in_ms = [
        1e3 * value
        for value in (opened - start, built - opened, walls[0], median(walls[1:]), median(whole[1:]), median(cpu[1:]), median(scene[1:]))
    ]
    return Timing(name, *in_ms)


def _finish(window: GLWindow) -> None:
    window.swap()
    window.ctx.finish()


def main(words: Sequence[str]) -> None:
    """Read the words of the command line, measure and print."""
    quality = next((word for word in words if word.isalpha()), "low")
    size = next((word for word in words if "x" in word and word[0].isdigit()), "640x360")
    pictures = next((int(word) for word in words if word.isdigit()), 100)
    width, height = (int(part) for part in size.split("x"))
    timing = measure(quality, (width, height), pictures)
    print(f"{timing.renderer_name}, {quality}, {width} x {height}, two fighters and the room, {pictures} pictures")
    print(f"open {timing.open_ms:.0f} ms, build {timing.build_ms:.0f} ms, first picture {timing.first_ms:.0f} ms")
    print(f"picture {timing.frame_ms:.2f} ms = {1e3 / timing.frame_ms:.1f} frames/s; CPU of all threads {timing.frame_cpu_ms:.1f} ms")
    print(
        f"CPU of render (with GALLIUM_NOOP=1: the Python side) {timing.python_ms:.2f} ms; of posing two fighters {timing.scene_ms:.2f} ms"
    )


if __name__ == "__main__":
    main(sys.argv[1:])
