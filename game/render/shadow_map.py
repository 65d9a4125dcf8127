"""The room as the main light sees it: what is nearer to the light than a point shades it."""

from collections.abc import Iterable

import moderngl

from game.render.batch import Batch
from game.render.matrices import Matrix
from game.render.shader_source import assign


class ShadowMap:
    """A square depth picture of `size` pixels."""

    def __init__(self, ctx: moderngl.Context, size: int) -> None:
        self._ctx = ctx
        self.texture = ctx.depth_texture((size, size))
        self._frame = ctx.framebuffer(depth_attachment=self.texture)
        edge = {"repeat_x": False, "repeat_y": False}
        self.comparing = ctx.sampler(**edge, filter=(moderngl.LINEAR, moderngl.LINEAR), compare_func="<=")
        self.plain = ctx.sampler(**edge, filter=(moderngl.NEAREST, moderngl.NEAREST))
        self.texel = 1.0 / size

    def draw(self, batches: Iterable[Batch], program: moderngl.Program, matrix: Matrix) -> None:
        """Draw the casters of the batches."""
        self._frame.use()
        self._frame.clear(depth=1.0)
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
        for held in (self._frame, self.texture, self.comparing, self.plain):
            held.release()
