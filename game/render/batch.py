"""A stream of instances on the graphics card, drawn by several programs, each with the mesh that suits it."""

from collections.abc import Mapping
from dataclasses import dataclass

import moderngl

from game.render.instances import Rows
from game.render.meshes import rounded_box

_SOLID = (("i_place", 4), ("i_orientation", 4), ("i_half", 4), ("i_colour", 4), ("i_stuff", 2))
_STROKE = (("i_start", 3), ("i_end", 3), ("i_colour", 4), ("i_width", 1))
_VERTEX = (("in_sign", 3), ("in_way", 3), ("in_face", 3))


@dataclass(frozen=True)
class Mesh:
    """A rounded box on the graphics card."""

    vertices: moderngl.Buffer
    indices: moderngl.Buffer


def upload_mesh(ctx: moderngl.Context, segments: int) -> Mesh:
    vertices, triangles = rounded_box(segments)
    return Mesh(ctx.buffer(vertices.tobytes()), ctx.buffer(triangles.tobytes()))


class Batch:
    """Instances of one kind. `draws` maps the name of a pass to its program and mesh; without a mesh four corners are drawn."""

    def __init__(self, ctx: moderngl.Context, draws: Mapping[str, tuple[moderngl.Program, Mesh | None]], strokes: bool = False) -> None:
        self.count = 0
        self.casters = 0
        self.uploads = 0
        self._row_bytes = 4 * sum(size for _, size in (_STROKE if strokes else _SOLID))
        self._buffer = ctx.buffer(reserve=64 * self._row_bytes, dynamic=True)
        self._arrays: dict[str, moderngl.VertexArray] = {}
        for name, (program, mesh) in draws.items():
            content = [(self._buffer, *_layout(program, _STROKE if strokes else _SOLID, "/i"))]
            if mesh is not None:
                content.append((mesh.vertices, *_layout(program, _VERTEX, "")))
            mode = moderngl.TRIANGLES if mesh is not None else moderngl.TRIANGLE_STRIP
            self._arrays[name] = ctx.vertex_array(program, content, index_buffer=mesh.indices if mesh else None, mode=mode)

    def upload(self, rows: Rows, casters: int = 0) -> None:
        """Replace the instances; the first `casters` of them cast a shadow."""
        self.count, self.casters = len(rows), casters
        if self.count:
            self.uploads += 1
            needed = self.count * self._row_bytes
            self._buffer.orphan(max(needed, self._buffer.size))
            self._buffer.write(rows)

    def draw(self, name: str, casters_only: bool = False) -> None:
        """One instanced draw call, or none where there is nothing to draw."""
        count = self.casters if casters_only else self.count
        if count:
            array = self._arrays[name]
            array.render(vertices=-1 if array.index_buffer is not None else 4, instances=count)

    def release(self) -> None:
        for array in self._arrays.values():
            array.release()
        self._buffer.release()


def _layout(program: moderngl.Program, attributes: tuple[tuple[str, int], ...], suffix: str) -> tuple[str, ...]:
    """moderngl's format and names; what the program does not read is skipped as padding."""
    used = [(name, size, name in program) for name, size in attributes]
    form = " ".join(f"{size}f" if read else f"{4 * size}x" for _, size, read in used)
    return (form + suffix, *(name for name, _, read in used if read))
