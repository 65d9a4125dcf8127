"""From linear light to the screen: glow, exposure, film curve, saturation, vignette, sRGB."""

from typing import Any

import moderngl

from game.render.shader_source import assign, compile_program
from game.tunables import Settings

_GLOW_DIVISORS = (4, 8, 16)


class Finish:
    """The last pass; with `glow` bright things bleed a little light over their surroundings."""

    def __init__(self, ctx: moderngl.Context, glow: bool) -> None:
        self._ctx, self.glow = ctx, glow
        self._program = compile_program(ctx, "screen.vert", "finish.frag", GLOW=int(glow))
        self._canvas = ctx.vertex_array(self._program, [])
        self._blur = compile_program(ctx, "screen.vert", "glow.frag") if glow else None
        self._blur_canvas = ctx.vertex_array(self._blur, []) if self._blur else None

    def adopt(self, settings: Settings) -> None:
        """Take over the tunables of the picture."""
        number = settings.number
        assign(
            self._program,
            u_exposure=number("picture.exposure"),
            u_saturation=number("picture.saturation"),
            u_vignette=number("picture.vignette"),
            u_glow_strength=number("picture.glow"),
        )

    def draw(
        self, picture: moderngl.Texture, glow: tuple[moderngl.Framebuffer, ...], target: moderngl.Framebuffer, size: tuple[int, int]
    ) -> None:
        """Write the picture (linear) to the target (sRGB) of (width, height) pixels."""
        self._ctx.enable_only(moderngl.NOTHING)
        last: Any = picture
        if self._blur is not None and self._blur_canvas is not None:
            for frame in glow:
                frame.use()
                last.use(0)
                assign(self._blur, u_picture=0, u_step=(1.0 / frame.size[0], 1.0 / frame.size[1]))
                self._blur_canvas.render(moderngl.TRIANGLES, vertices=3)
                last = frame.color_attachments[0]
        target.use()
        target.viewport = (0, 0, *size)
        picture.use(0)
        last.use(1)
        assign(self._program, u_picture=0, u_glow=1, u_aspect=size[0] / size[1])
        self._canvas.render(moderngl.TRIANGLES, vertices=3)

    def release(self) -> None:
        for held in (self._canvas, self._program, self._blur_canvas, self._blur):
            if held is not None:
                held.release()


def glow_frames(ctx: moderngl.Context, size: tuple[int, int]) -> tuple[moderngl.Framebuffer, ...]:
    """Ever smaller pictures, then back up, for a wide soft blur."""
    frames = []
    for divisor in (*_GLOW_DIVISORS, *_GLOW_DIVISORS[-2::-1]):
        texture = ctx.texture((max(size[0] // divisor, 1), max(size[1] // divisor, 1)), 4, dtype="f2")
        texture.repeat_x = texture.repeat_y = False
        frames.append(ctx.framebuffer([texture]))
    return tuple(frames)
