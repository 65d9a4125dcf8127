"""Compiles the programs of game/shaders: `#include "x.glsl"` is spliced in and names become #define lines."""

import re
from importlib.resources import files

import moderngl


class ShaderError(RuntimeError):
    """A program does not compile on this driver; the message names the file and quotes the driver."""


def _source(name: str, defines: dict[str, int]) -> str:
    folder = files("game") / "shaders"
    text = (folder / name).read_text(encoding="utf-8")
    text = re.sub(r'#include "([\w.]+)"', lambda found: (folder / found.group(1)).read_text(encoding="utf-8"), text)
    version, rest = text.split("\n", 1)
    return "\n".join([version, *(f"#define {key} {value}" for key, value in defines.items()), rest])


def compile_program(ctx: moderngl.Context, vertex: str, fragment: str, **defines: int) -> moderngl.Program:
    """The program of two files in game/shaders; raises ShaderError."""
    try:
        return ctx.program(vertex_shader=_source(vertex, defines), fragment_shader=_source(fragment, defines))
    except moderngl.Error as broken:
        raise ShaderError(f"The shaders {vertex} and {fragment} do not compile on {ctx.info['GL_RENDERER']}: {broken}") from broken


def assign(program: moderngl.Program, **values: object) -> None:
    """Set uniforms by name; one that the compiler found unused is passed over."""
    for name, value in values.items():
        uniform = program.get(name, None)
        if uniform is not None:
            uniform.value = value  # type: ignore[union-attr]
