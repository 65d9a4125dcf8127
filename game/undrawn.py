"""The loop without a picture: fixed updates and nothing else."""

from game.pacing import is_over
from game.scenes.registry import PlayableScene

ENDLESS_S = 20.0


def run_undrawn(scene: PlayableScene, seconds: float | None) -> dict[str, object]:
    """Run a scene to its end or for `seconds` of simulated time after the hang; an endless one stops after 20 s by itself."""
    scene.enter()
    if seconds is None and scene.endless:
        seconds = ENDLESS_S
    try:
        while not is_over(scene, seconds):
            scene.fixed_update()
    finally:
        scene.leave()
    return {"drawn": False}
