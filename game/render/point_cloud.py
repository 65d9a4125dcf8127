"""Depth pictures as points: the codes go to the graphics card as they are, a vertex shader places them. Compiled when first needed."""

import math

import moderngl
import numpy as np
from numpy.typing import NDArray

from game.drawables import DepthPoints
from game.render.matrices import Matrix
from game.render.shader_source import assign, compile_program

_CODES, _METRES = 0, 1


class PointCloud:
    """Draws DepthPoints. stride: every so many-th pixel and row becomes a point, the coarser the slower the machine."""

    def __init__(self, ctx: moderngl.Context, stride: int) -> None:
        self._ctx, self._stride = ctx, stride
        self._program = compile_program(ctx, "depth_points.vert", "depth_points.frag")
        self._array = ctx.vertex_array(self._program, [], mode=moderngl.POINTS)
        self._codes: moderngl.Texture | None = None
        self._metres: moderngl.Texture | None = None
        self._sent: tuple[NDArray[np.uint16] | None, NDArray[np.float32] | None] = (None, None)
        self.uploads = 0
        assign(self._program, u_codes=_CODES, u_metres=_METRES, u_stride=stride)

    def draw(self, cloud: DepthPoints, matrix: Matrix, fov_rad: float, lines: int, canvas: moderngl.Framebuffer) -> None:
        """Lay the points over what the canvas holds, hidden by and hiding what stands in the room; lines: the picture's height."""
        codes, metres = self._upload(cloud)
        place = np.eye(4)
        place[:3, :3], place[:3, 3] = cloud.turn, cloud.shift
        assign(
            self._program,
            u_lens=(cloud.focal_px, *cloud.centre_px),
            u_place=tuple(place.T.ravel().tolist()),
            u_view_projection=matrix,
            u_diameter=cloud.diameter_m * self._stride,
            u_lines=0.5 * lines / math.tan(fov_rad / 2.0),
            u_reach=cloud.reach_m,
            u_near_colour=cloud.colour,
        )
        codes.use(_CODES)
        metres.use(_METRES)
        canvas.use()
        self._ctx.enable_only(moderngl.DEPTH_TEST | moderngl.PROGRAM_POINT_SIZE)
        height, width = cloud.codes.shape
        self._array.render(vertices=-(-height // self._stride) * -(-width // self._stride))

    def release(self) -> None:
        """Give everything back to the driver."""
        for held in (self._array, self._program, self._codes, self._metres):
            if held is not None:
                held.release()

    def _upload(self, cloud: DepthPoints) -> tuple[moderngl.Texture, moderngl.Texture]:
        """The textures, written anew only where the arrays are others than last time."""
        sent_codes, sent_metres = self._sent
        codes, metres = self._codes, self._metres
        if metres is None or sent_metres is not cloud.metres:
            if metres is not None:
                metres.release()
            row = np.nan_to_num(cloud.metres).astype("<f4")
            metres = self._metres = self._ctx.texture((len(row), 1), 1, row.tobytes(), dtype="f4")
            metres.filter = (moderngl.NEAREST, moderngl.NEAREST)
        size = cloud.codes.shape[::-1]
        if codes is not None and codes.size != size:
            codes.release()
            codes = None
        if codes is None or sent_codes is not cloud.codes:
            if codes is None:
                codes = self._codes = self._ctx.texture(size, 1, alignment=2, dtype="u2")
                codes.filter = (moderngl.NEAREST, moderngl.NEAREST)
            codes.write(np.ascontiguousarray(cloud.codes))
            self.uploads += 1
        self._sent = (cloud.codes, cloud.metres)
        return codes, metres
