"""From no to yes without a jump."""

from game.compiled import compiled


@compiled
def smooth_step(x: float) -> float:
    """Smoothly from 0 at 0 to 1 at 1, level at both ends; as it ends beyond them."""
    x = min(1.0, max(0.0, x))
    return x * x * (3.0 - 2.0 * x)
