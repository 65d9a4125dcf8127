"""Scenes as the play command makes them, ready to run."""

import os

from game.commands.casting import Casting
from game.scenes.registry import PlayableScene
from game.tunables import Settings

# a scene steps tiny matrices: threads of the BLAS only get into each other's way
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def make_scene(name: str, spec: str = "script", settings: Settings | None = None, seed: int = 0) -> PlayableScene:
    """The scene `name` with input `spec`, not yet entered."""
    return Casting(spec, "original", settings or Settings(), seed).scene(name)


def look_at(scene: PlayableScene) -> tuple[object, ...]:
    """Ask an entered scene for everything that a picture, the overlay and a report ask it for."""
    return scene.drawables(0.3), scene.readouts(), scene.plots(), scene.messages(), scene.score(), scene.report()


def run_s(scene: PlayableScene, seconds: float) -> PlayableScene:
    """Run an entered scene until so many seconds after the hang."""
    while scene.time_s < seconds - 1e-9:
        scene.fixed_update()
    return scene
