"""Tells the layers that stand still (the same objects picture after picture) from those that move."""

from collections.abc import Sequence

from game.drawables import Layer

SETTLING_PICTURES = 6
"""A layer that came unchanged this often stands still; an input at 30 Hz repeats its layer less often than this."""


class StaticLayers:
    """Remembers which layer objects it saw. Holds them, so that an identity is never reused."""

    def __init__(self) -> None:
        self._seen: dict[int, tuple[Layer, int]] = {}
        self._fixed: tuple[int, ...] = ()

    def split(self, layers: Sequence[Layer]) -> tuple[tuple[Layer, ...], tuple[Layer, ...], bool]:
        """(standing, moving, whether the standing ones differ from last time). Translucent layers always count as moving."""
        seen: dict[int, tuple[Layer, int]] = {}
        fixed: list[Layer] = []
        moving: list[Layer] = []
        for layer in layers:
            age = self._seen[id(layer)][1] + 1 if id(layer) in self._seen else 1
            seen[id(layer)] = (layer, age)
            (fixed if age > SETTLING_PICTURES and layer.opacity >= 1.0 else moving).append(layer)
        self._seen = seen
        identities = tuple(map(id, fixed))
        changed = identities != self._fixed
        self._fixed = identities
        return tuple(fixed), tuple(moving), changed
