"""The room as the main light sees it: what is nearer to the light than a point shades it."""

from collections.abc import Iterable

import moderngl

from game.render.batch import Batch
from game.render.matrices import Matrix
from game.render.shader_source import assign


class ShadowMap:
    """A square depth picture of `size` pixels. What stands still is drawn once and copied under what moves."""

    def __init__(self, ctx: moderngl.Context, size: int) -> None:
        self._ctx = ctx
        self.texture = ctx.depth_texture((size, size))
        # moderngl copies a depth picture only along with a colour one: a byte a pixel, never written
        self._frame = ctx.framebuffer([ctx.texture((size, size), 1)], self.texture)
        self._fixed = ctx.framebuffer([ctx.texture((size, size), 1)], ctx.depth_texture((size, size)))
        for frame in (self._frame, self._fixed):
            frame.color_mask = (False, False, False, False)
            frame.viewport = (1, 1, size - 2, size - 2)  # the rim stays empty: what lies outside the map is lit
        linear, nearest = (moderngl.LINEAR, moderngl.LINEAR), (moderngl.NEAREST, moderngl.NEAREST)
        self.comparing = ctx.sampler(repeat_x=False, repeat_y=False, filter=linear, compare_func="<=")
        self.plain = ctx.sampler(repeat_x=False, repeat_y=False, filter=nearest)
        self.texel = 1.0 / size

    def draw_fixed(self, batches: Iterable[Batch], program: moderngl.Program, matrix: Matrix) -> None:
        """Draw the casters that stand still; needed again only when they or the light change."""
        self._fixed.use()
        self._fixed.clear(depth=1.0)
        self._draw(batches, program, matrix)

    def draw_moving(self, batches: Iterable[Batch], program: moderngl.Program, matrix: Matrix) -> None:
        """Draw the casters that move over those that stand still."""
        self._ctx.copy_framebuffer(self._frame, self._fixed)
        self._frame.use()
        self._draw(batches, program, matrix)

    def _draw(self, batches: Iterable[Batch], program: moderngl.Program, matrix: Matrix) -> None:
        self._ctx.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        assign(program, u_view_projection=matrix)
        for batch in batches:
            batch.draw("depth", casters_only=True)

    def bind(self, comparing: int, plain: int) -> None:
        """Offer the map on two texture units: compared with filtering, and as bare depth."""
        self.texture.use(comparing)
        self.comparing.use(comparing)
        self.texture.use(plain)
        self.plain.use(plain)

    def unbind(self, comparing: int, plain: int) -> None:
        self.comparing.clear(comparing)
        self.plain.clear(plain)

    def release(self) -> None:
        for frame in (self._frame, self._fixed):
            for picture in (*frame.color_attachments, frame.depth_attachment):
                if picture is not None:
                    picture.release()
            frame.release()
        self.comparing.release()
        self.plain.release()
