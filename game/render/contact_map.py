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
        self._fixed = ctx.framebuffer([ctx.texture((_PIXELS, _PIXELS), 1)])

    def draw_fixed(self, batches: Iterable[Batch]) -> None:
        """Darken under what stands still; needed again only when that changes."""
        self._fixed.use()
        self._fixed.clear(1.0, 1.0, 1.0, 1.0)
        self._draw(batches)

    def draw_moving(self, batches: Iterable[Batch]) -> None:
        """Darken further under what moves."""
        self._ctx.copy_framebuffer(self._frame, self._fixed)
        self._frame.use()
        self._draw(batches)

    def _draw(self, batches: Iterable[Batch]) -> None:
        self._ctx.enable_only(moderngl.BLEND)
        self._ctx.blend_func = moderngl.DST_COLOR, moderngl.ZERO
        for batch in batches:
            batch.draw("contact", casters_only=True)
        self._ctx.blend_func = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA

    def release(self) -> None:
        for frame in (self._frame, self._fixed):
            for picture in frame.color_attachments:
                picture.release()
            frame.release()
