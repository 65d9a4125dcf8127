"""The loop without a picture: fixed updates and nothing else."""

import sys

from game.scenes.registry import PlayableScene

ENDLESS_S = 20.0


def run_undrawn(scene: PlayableScene, seconds: float | None) -> dict[str, object]:
    """Run an entered scene to its end or for `seconds` of simulated time after the hang."""
    limit = seconds if seconds is not None else (ENDLESS_S if scene.endless else float("inf"))
    try:
        while not scene.finished and scene.time_s < limit - 1e-9:
            scene.fixed_update()
    finally:
        scene.leave()
    return {"drawn": False, "platform": sys.platform}
