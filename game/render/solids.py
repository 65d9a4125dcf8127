"""All solids of a picture on the graphics card: moving and standing, sharp-edged and round, and the programs that draw them."""

import moderngl

from game.render.batch import Batch, upload_mesh
from game.render.instances import Packed
from game.render.quality import Quality
from game.render.shader_source import compile_program


class Solids:
    """One instanced draw call a kind and pass. `batches` lists what moves first and the walls last: what is hidden need not be shaded."""

    def __init__(self, ctx: moderngl.Context, quality: Quality) -> None:
        options = {
            "SHADOW_TAPS": quality.shadow_taps,
            "SOFT_SHADOWS": int(quality.soft_shadows),
            "OCCLUSION": int(quality.occlusion_taps > 0),
            "LAMPS": quality.lamps,
            "GLOSS": int(quality.gloss),
        }
        self.surface = compile_program(ctx, "surface.vert", "surface.frag", **options)
        self.depth = compile_program(ctx, "depth.vert", "depth.frag")
        self.contact = compile_program(ctx, "contact.vert", "contact.frag")
        segments = {"edged": quality.edge_segments, "round": quality.round_segments, "cube": 0, "ball": 2}
        self._meshes = {name: upload_mesh(ctx, count) for name, count in segments.items()}
        self.moving = (self._batch(ctx, "edged", "cube"), self._batch(ctx, "round", "ball"))
        self.fixed = (self._batch(ctx, "edged", "cube"), self._batch(ctx, "round", "ball"))
        self.batches = (*self.moving, *reversed(self.fixed))

    def _batch(self, ctx: moderngl.Context, seen: str, hull: str) -> Batch:
        draws = {"surface": (self.surface, self._meshes[seen]), "depth": (self.depth, self._meshes[hull]), "contact": (self.contact, None)}
        return Batch(ctx, draws)

    def upload_moving(self, packed: Packed) -> None:
        """Hand over the solids of this picture."""
        self.moving[0].upload(packed.edged, packed.edged_casters)
        self.moving[1].upload(packed.round, packed.round_casters)

    def upload_fixed(self, packed: Packed) -> None:
        """Hand over the solids that stand still until the next call."""
        self.fixed[0].upload(packed.edged, packed.edged_casters)
        self.fixed[1].upload(packed.round, packed.round_casters)

    @property
    def fixed_uploads(self) -> int:
        """How often standing solids were sent to the graphics card."""
        return sum(batch.uploads for batch in self.fixed)

    def release(self) -> None:
        for batch in self.batches:
            batch.release()
        for mesh in self._meshes.values():
            mesh.vertices.release()
            mesh.indices.release()
        for program in (self.surface, self.depth, self.contact):
            program.release()
