"""Draws what a scene lists: solids with shadows, ambient light and lamps, then ghosts and lines, then the film.

The renderer knows arrays only. Layers that a scene hands out again and again as the same objects (the furniture) are uploaded once.
"""

import math
from collections.abc import Sequence

import moderngl
import numpy as np

from game.drawables import DepthPoints, Layer
from game.render.camera import FAR_M, NEAR_M, Camera
from game.render.contact_map import FLOOR, ContactMap
from game.render.culling import View
from game.render.finish import Finish
from game.render.instances import Packed, Rows, pack
from game.render.lights import find_lamps, glowing, room_lights, shadow_matrix
from game.render.materials import paint_materials
from game.render.matrices import Matrix
from game.render.occlusion import OcclusionPrograms
from game.render.point_cloud import PointCloud
from game.render.quality import quality_named
from game.render.see_through import Ghosts, Strokes
from game.render.shader_source import assign
from game.render.shadow_map import ShadowMap
from game.render.solids import Solids
from game.render.static_layers import StaticLayers
from game.render.targets import Targets
from game.tunables import TUNABLES, Settings

_MATERIALS, _SHADOW, _SHADOW_DEPTH, _CONTACT, _OCCLUSION = range(5)
_BACKGROUND = (0.05, 0.045, 0.04)


class Renderer:
    """Everything the graphics card needs to draw a room. quality: low, medium or high. Belongs to one context and thread."""

    def __init__(self, ctx: moderngl.Context, quality: str, settings: Settings) -> None:
        self.ctx, self.quality, self.settings = ctx, quality_named(quality), settings
        self._solids = Solids(ctx, self.quality)
        self._ghosts: Ghosts | None = None
        self._strokes: Strokes | None = None
        self._cloud: PointCloud | None = None
        self._materials = paint_materials(ctx, self.quality.material_size, self.quality.anisotropy)
        self._shadow = ShadowMap(ctx, self.quality.shadow_size)
        self._contact = ContactMap(ctx, 0 if self.quality.gloss else self.quality.lamps)
        self._occlusion = OcclusionPrograms(ctx, self.quality.occlusion_taps) if self.quality.occlusion_taps else None
        self._finish = Finish(ctx, self.quality.glow)
        self._targets: Targets | None = None
        self._static = StaticLayers()
        self._view = View()
        self._fixed = Packed()
        self._fixed_lamps: Rows = self._fixed.edged
        self._lamps: Rows = self._fixed.edged
        self._adopted = -1
        self._shade_stale = True
        self._light_matrix: Matrix = ()
        self._assign_units()

    @property
    def fixed_uploads(self) -> int:
        """How often standing solids were sent to the graphics card."""
        return self._solids.fixed_uploads

    def render(self, layers: Sequence[Layer], camera: Camera, framebuffer: moderngl.Framebuffer, size: tuple[int, int]) -> None:
        """Draw the layers as the camera sees them into the framebuffer of (width, height) pixels."""
        if size[0] < 1 or size[1] < 1:
            return  # a minimised window
        targets = self._fit_targets(size)
        moving = self._take(layers)
        fov_deg = self.settings.number("picture.fov_deg")
        matrix = camera.view_projection(size[0] / size[1], fov_deg)
        self._draw_shade()
        seen = self._view.choose(self._fixed, matrix)
        if seen is not None:
            self._solids.upload_fixed(seen)
        if targets.occlusion is not None:
            slope = math.tan(camera.fov_rad(fov_deg) / 2.0)
            lens = (slope * size[0] / size[1], slope, NEAR_M, FAR_M)
            targets.occlusion.draw(self._solids.batches, self._solids.depth, matrix, lens)
        self._draw_solids(matrix, camera, targets)
        for cloud in self._clouds(layers):
            self._cloud = self._cloud or PointCloud(self.ctx, self.quality.point_stride)
            self._cloud.draw(cloud, matrix, camera.fov_rad(fov_deg), size[1], targets.canvas)
        if len(moving.ghosts):
            self._ghosts = self._ghosts or Ghosts(self.ctx)
            self._ghosts.draw(moving.ghosts, matrix, camera.eye, targets.canvas)
        for packed in (self._fixed, moving):
            for rows, on_top in ((packed.strokes, False), (packed.strokes_on_top, True)):
                if len(rows):
                    self._strokes = self._strokes or Strokes(self.ctx)
                    self._strokes.draw(rows, matrix, size, targets.canvas, on_top)
        targets.resolve()
        self._finish.draw(targets.picture, targets.glow, framebuffer, size)

    def release(self) -> None:
        """Give everything back to the driver."""
        passes = (
            self._solids,
            self._ghosts,
            self._strokes,
            self._shadow,
            self._contact,
            self._occlusion,
            self._finish,
            self._targets,
            self._cloud,
        )
        for held in (*passes, self._materials):
            if held is not None:
                held.release()

    def _take(self, layers: Sequence[Layer]) -> Packed:
        fixed, moving, changed = self._static.split([layer for layer in layers if self._shows(layer)])
        packed = pack(moving)
        if changed:
            self._fixed = pack(fixed)
            self._fixed_lamps = np.concatenate((glowing(self._fixed.edged), glowing(self._fixed.round)))
            self._shade_stale = True
        self._solids.upload_moving(packed)
        lamps = np.concatenate((self._fixed_lamps, glowing(packed.edged), glowing(packed.round)))
        if self._adopted != self.settings.version or not np.array_equal(lamps, self._lamps):
            self._lamps = lamps
            self._adopt_settings()
        return packed

    def _clouds(self, layers: Sequence[Layer]) -> list[DepthPoints]:
        return [item for layer in layers if self._shows(layer) for item in layer.drawables if isinstance(item, DepthPoints)]

    def _shows(self, layer: Layer) -> bool:
        name = f"layer.{layer.name}"
        return name not in TUNABLES or self.settings.switch(name)

    def _adopt_settings(self) -> None:
        self._adopted = self.settings.version
        lights = room_lights(self.settings)
        self._light_matrix = shadow_matrix(lights.to_light)
        self._shade_stale = True
        places, colours = find_lamps(self._lamps, self.settings.number("picture.lamps"), self.quality.lamps)
        assign(
            self._solids.surface,
            u_light=self._light_matrix,
            u_to_light=lights.to_light,
            u_key=lights.key,
            u_sky=lights.sky,
            u_ground=lights.ground,
            u_fill=lights.fill,
            u_to_fill=lights.to_fill,
            u_rim=lights.rim,
            u_lamp=places,
            u_lamp_colour=colours,
            u_ambient_occlusion=self.settings.number("picture.ambient_occlusion"),
        )
        if self._contact.program is not None:
            assign(self._contact.program, u_lamp=places, u_lamp_colour=colours)
        self._finish.adopt(self.settings)

    def _assign_units(self) -> None:
        assign(
            self._solids.surface,
            u_materials=_MATERIALS,
            u_shadow_map=_SHADOW,
            u_shadow_depth=_SHADOW_DEPTH,
            u_contact=_CONTACT,
            u_occlusion=_OCCLUSION,
            u_shadow_texel=self._shadow.texel,
            u_inflate=0.0,
        )
        assign(self._solids.surface, u_floor=FLOOR)
        assign(self._solids.contact, u_floor=FLOOR)

    def _fit_targets(self, size: tuple[int, int]) -> Targets:
        if self._targets is None or self._targets.size != size:
            if self._targets is not None:
                self._targets.release()
            self._targets = Targets(self.ctx, self.quality, self._occlusion, size)
            assign(self._solids.surface, u_occlusion_scale=(1.0 / size[0], 1.0 / size[1]))
        return self._targets

    def _draw_shade(self) -> None:
        """Shadows and the darkening of the floor; of what stands still only where it or the light changed."""
        solids = self._solids
        if self._shade_stale:
            solids.upload_fixed(self._fixed)
            self._shadow.draw_fixed(solids.fixed, solids.depth, self._light_matrix)
            self._contact.draw_fixed(solids.fixed)
            self._shade_stale = False
            self._view.forget()
        self._shadow.draw_moving(solids.moving, solids.depth, self._light_matrix)
        self._contact.draw_moving(solids.moving)

    def _draw_solids(self, matrix: Matrix, camera: Camera, targets: Targets) -> None:
        targets.canvas.use()
        targets.canvas.clear(*_BACKGROUND, 1.0, depth=1.0)
        self._materials.use(_MATERIALS)
        self._contact.texture.use(_CONTACT)
        if targets.occlusion is not None:
            targets.occlusion.texture.use(_OCCLUSION)
        self._shadow.bind(_SHADOW, _SHADOW_DEPTH)
        assign(self._solids.surface, u_view_projection=matrix, u_eye=camera.eye)
        self.ctx.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        for batch in self._solids.batches:
            batch.draw("surface")
        self._shadow.unbind(_SHADOW, _SHADOW_DEPTH)
