"""The floor seen from above, darkened where something stands or hovers near it: ambient occlusion at almost no cost."""

from collections.abc import Iterable

import moderngl

from game.render.batch import Batch

CENTRE_M = (0.2, 0.0)
EXTENT_M = 7.6
_PIXELS = 256


class ContactMap:
    """A square picture of EXTENT_M metres of floor around CENTRE_M; 1 is open, 0 is closed."""

    def __init__(self, ctx: moderngl.Context) -> None:
        self._ctx = ctx
        self.texture = ctx.texture((_PIXELS, _PIXELS), 1)
        self.texture.repeat_x = self.texture.repeat_y = False
        self._frame = ctx.framebuffer([self.texture])

    def draw(self, batches: Iterable[Batch]) -> None:
        """Darken under all solids that cast shadows."""
        self._frame.use()
        self._frame.clear(1.0, 1.0, 1.0, 1.0)
        self._ctx.enable_only(moderngl.BLEND)
        self._ctx.blend_func = moderngl.DST_COLOR, moderngl.ZERO
        for batch in batches:
            batch.draw("contact", casters_only=True)
        self._ctx.blend_func = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA

    def release(self) -> None:
        self._frame.release()
        self.texture.release()
