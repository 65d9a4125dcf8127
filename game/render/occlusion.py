"""Screen-space ambient occlusion at half the picture's size: depth first, then the corners, then smoothing."""

from collections.abc import Iterable

import moderngl

from game.render.batch import Batch
from game.render.matrices import Matrix
from game.render.shader_source import assign, compile_program


class OcclusionPrograms:
    """The two programs, independent of the picture's size."""

    def __init__(self, ctx: moderngl.Context, taps: int) -> None:
        self.search = compile_program(ctx, "screen.vert", "occlusion.frag", OCCLUSION_TAPS=taps)
        self.smooth = compile_program(ctx, "screen.vert", "smooth.frag")
        self.search_canvas = ctx.vertex_array(self.search, [])
        self.smooth_canvas = ctx.vertex_array(self.smooth, [])

    def release(self) -> None:
        for held in (self.search_canvas, self.smooth_canvas, self.search, self.smooth):
            held.release()


class Occlusion:
    """For one picture size; `texture` holds how open each place is, 0 to 1."""

    def __init__(self, ctx: moderngl.Context, programs: OcclusionPrograms, size: tuple[int, int]) -> None:
        self._ctx, self._programs = ctx, programs
        half = (max(size[0] // 2, 1), max(size[1] // 2, 1))
        self._texel = (1.0 / half[0], 1.0 / half[1])
        self._depth = ctx.depth_texture(half)
        self._depth.compare_func = ""
        self._rough = ctx.texture(half, 2, dtype="f2")
        self.texture = ctx.texture(half, 1)
        for picture in (self._depth, self._rough, self.texture):
            picture.repeat_x = picture.repeat_y = False
        self._depth.filter = (moderngl.NEAREST, moderngl.NEAREST)
        self._frames = (ctx.framebuffer(depth_attachment=self._depth), ctx.framebuffer([self._rough]), ctx.framebuffer([self.texture]))

    def draw(self, batches: Iterable[Batch], program: moderngl.Program, matrix: Matrix, lens: tuple[float, float, float, float]) -> None:
        """lens: tangents of half the field of view (x, y), near and far distance (m)."""
        depth, rough, smooth = self._frames
        depth.use()
        depth.clear(depth=1.0)
        self._ctx.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        assign(program, u_view_projection=matrix)
        for batch in batches:
            batch.draw("depth")
        self._ctx.enable_only(moderngl.NOTHING)
        rough.use()
        self._depth.use(0)
        assign(self._programs.search, u_depth=0, u_lens=lens, u_texel=self._texel)
        self._programs.search_canvas.render(moderngl.TRIANGLES, vertices=3)
        smooth.use()
        self._rough.use(0)
        assign(self._programs.smooth, u_picture=0, u_texel=self._texel)
        self._programs.smooth_canvas.render(moderngl.TRIANGLES, vertices=3)

    def release(self) -> None:
        for held in (*self._frames, self._depth, self._rough, self.texture):
            held.release()
