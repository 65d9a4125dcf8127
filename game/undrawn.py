"""The loop without a picture: fixed updates and nothing else."""

from game.scenes.registry import PlayableScene

ENDLESS_S = 20.0


def run_undrawn(scene: PlayableScene, seconds: float | None) -> dict[str, object]:
    """Run a scene to its end or for `seconds` of simulated time after the hang; an endless one stops after 20 s by itself."""
    scene.enter()
    limit = seconds if seconds is not None else (ENDLESS_S if scene.endless else float("inf"))
    try:
        while not scene.finished and scene.time_s < limit - 1e-9:
            scene.fixed_update()
    finally:
        scene.leave()
    return {"drawn": False}
