"""What is laid over the finished solids: translucent ghosts, lines and points. Compiled when first needed."""

import moderngl

from game.render.batch import Batch, upload_mesh
from game.render.instances import Rows
from game.render.matrices import Matrix, Vector
from game.render.shader_source import assign, compile_program

_GHOST_INFLATE_M = 0.004
"""A ghost is drawn this much larger, so that it stays visible where it coincides with the solid it belongs to."""


class Ghosts:
    """Solids of translucent layers: only their front surface, strongest at the rim."""

    def __init__(self, ctx: moderngl.Context) -> None:
        self._ctx = ctx
        self._program = compile_program(ctx, "surface.vert", "surface.frag", GHOST=1, SHADOW_TAPS=1, LAMPS=1, GLOSS=0, OCCLUSION=0)
        self._mesh = upload_mesh(ctx, 3)
        self._batch = Batch(ctx, {"surface": (self._program, self._mesh)})

    def draw(self, rows: Rows, matrix: Matrix, eye: Vector, canvas: moderngl.Framebuffer) -> None:
        self._batch.upload(rows)
        assign(self._program, u_view_projection=matrix, u_eye=eye, u_inflate=_GHOST_INFLATE_M)
        self._ctx.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE | moderngl.BLEND)
        canvas.color_mask = (False, False, False, False)  # depth first, so that no limb shows through another
        self._batch.draw("surface")
        canvas.color_mask = (True, True, True, True)
        self._ctx.depth_func = "<="
        self._batch.draw("surface")
        self._ctx.depth_func = "<"

    def release(self) -> None:
        self._batch.release()
        self._mesh.vertices.release()
        self._mesh.indices.release()
        self._program.release()


class Strokes:
    """Lines and points of a width in pixels."""

    def __init__(self, ctx: moderngl.Context) -> None:
        self._ctx = ctx
        self._program = compile_program(ctx, "stroke.vert", "stroke.frag")
        self._batch = Batch(ctx, {"stroke": (self._program, None)}, strokes=True)

    def draw(self, rows: Rows, matrix: Matrix, size: tuple[int, int], canvas: moderngl.Framebuffer, on_top: bool) -> None:
        self._batch.upload(rows)
        assign(self._program, u_view_projection=matrix, u_size=(float(size[0]), float(size[1])))
        self._ctx.enable_only(moderngl.BLEND if on_top else moderngl.BLEND | moderngl.DEPTH_TEST)
        canvas.depth_mask = False
        self._batch.draw("stroke")
        canvas.depth_mask = True

    def release(self) -> None:
        self._batch.release()
        self._program.release()
