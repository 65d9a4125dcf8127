"""The floor plan of the room, darkened where something stands or hovers near the floor: ambient occlusion at almost no cost.

On low quality it also carries the light of the lamps, so that no pixel has to ask each lamp.
"""

from collections.abc import Iterable

import moderngl

from game.render.batch import Batch
from game.render.shader_source import assign, compile_program

CENTRE_M = (0.2, 0.0)
EXTENT_M = 7.6
FLOOR = (*CENTRE_M, 1.0 / EXTENT_M, 0.0)
"""As the shaders want it: centre of the plan (m), 1 / extent."""
_PIXELS = 256


class ContactMap:
    """A square picture of EXTENT_M metres of floor around CENTRE_M. Alpha: 1 is open, 0 is closed. RGB: half the lamps' light.

    lamps: how many lamps the plan carries, 0 for none.
    """

    def __init__(self, ctx: moderngl.Context, lamps: int) -> None:
        self._ctx = ctx
        self.texture = ctx.texture((_PIXELS, _PIXELS), 4)
        self.texture.repeat_x = self.texture.repeat_y = False
        self._frame = ctx.framebuffer([self.texture])
        self._fixed = ctx.framebuffer([ctx.texture((_PIXELS, _PIXELS), 4)])
        self.program = compile_program(ctx, "screen.vert", "plan_light.frag", LAMPS=lamps) if lamps else None
        self._canvas = ctx.vertex_array(self.program, []) if self.program else None
        if self.program:
            assign(self.program, u_floor=FLOOR)

    def draw_fixed(self, batches: Iterable[Batch]) -> None:
        """Lay out the lamps' light and darken under what stands still; needed again only when that changes."""
        self._fixed.use()
        self._fixed.clear(1.0, 1.0, 1.0, 1.0)
        if self._canvas is not None:
            self._ctx.enable_only(moderngl.NOTHING)
            self._canvas.render(moderngl.TRIANGLES, vertices=3)
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
        for held in (self._canvas, self.program):
            if held is not None:
                held.release()
