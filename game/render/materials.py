"""The sheets of wood, plaster, cloth and pictures that surfaces show: painted once by a shader, then only looked up."""

import moderngl

from game.drawables import MATERIALS
from game.render.quality import draws_in_software
from game.render.shader_source import assign, compile_program


def paint_materials(ctx: moderngl.Context, size: int, anisotropy: float) -> moderngl.TextureArray:
    """An array of len(MATERIALS) sheets of size x size pixels with mipmaps."""
    program = compile_program(ctx, "screen.vert", "materials.frag")
    assign(program, u_sheets=float(len(MATERIALS)))
    wall = ctx.simple_framebuffer((size, size * len(MATERIALS)), components=4)
    wall.use()
    ctx.disable(moderngl.DEPTH_TEST | moderngl.BLEND | moderngl.CULL_FACE)
    canvas = ctx.vertex_array(program, [])
    canvas.render(moderngl.TRIANGLES, vertices=3)
    sheets = ctx.texture_array((size, size, len(MATERIALS)), 4, data=wall.read(components=4))
    sheets.filter = (moderngl.LINEAR_MIPMAP_LINEAR if anisotropy > 1.0 else moderngl.LINEAR_MIPMAP_NEAREST, moderngl.LINEAR)
    sheets.build_mipmaps()
    in_software = draws_in_software(ctx.info["GL_RENDERER"])
    sheets.anisotropy = 1.0 if in_software else min(anisotropy, ctx.max_anisotropy)  # in software it costs seconds a picture
    ctx.screen.use()  # a framebuffer in use must not be released: moderngl would bind it again
    for used in (canvas, wall, program):
        used.release()
    return sheets
