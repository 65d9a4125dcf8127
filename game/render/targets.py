"""The pictures a frame passes through, for one picture size."""

import moderngl

from game.render.finish import glow_frames
from game.render.occlusion import Occlusion, OcclusionPrograms
from game.render.quality import Quality


class Targets:
    """canvas: where solids are drawn, multisampled or not; picture: the linear result after `resolve`."""

    def __init__(self, ctx: moderngl.Context, quality: Quality, occlusion: OcclusionPrograms | None, size: tuple[int, int]) -> None:
        self._ctx, self.size = ctx, size
        samples = min(quality.samples, ctx.max_samples)
        self.picture = ctx.texture(size, 4, dtype="f2")
        self.picture.repeat_x = self.picture.repeat_y = False
        if not quality.glow:
            self.picture.filter = (moderngl.NEAREST, moderngl.NEAREST)  # read pixel by pixel: in software a blend costs four times as much
        if samples > 1:
            colour = ctx.renderbuffer(size, 4, samples=samples, dtype="f2")
            self.canvas = ctx.framebuffer([colour], ctx.depth_renderbuffer(size, samples=samples))
            self._resolved = ctx.framebuffer([self.picture])
        else:
            self.canvas = self._resolved = ctx.framebuffer([self.picture], ctx.depth_renderbuffer(size))
        self.occlusion = Occlusion(ctx, occlusion, size) if occlusion else None
        self.glow = glow_frames(ctx, size) if quality.glow else ()

    def resolve(self) -> None:
        """Average the samples of each pixel."""
        if self._resolved is not self.canvas:
            self._ctx.copy_framebuffer(self._resolved, self.canvas)

    def release(self) -> None:
        self._ctx.screen.use()  # a framebuffer in use must not be released: moderngl would bind it again
        frames = {id(f): f for f in (self.canvas, self._resolved, *self.glow)}.values()
        for frame in frames:
            for attached in (*frame.color_attachments, frame.depth_attachment):
                if attached is not None:
                    attached.release()
            frame.release()
        if self.occlusion is not None:
            self.occlusion.release()
