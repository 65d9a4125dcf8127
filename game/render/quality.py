"""What each quality preset spends on the picture."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

QualityName = Literal["low", "medium", "high"]


@dataclass(frozen=True)
class Quality:
    """shadow_taps: 1 is four texels blended by the hardware; samples: of multisampling, 0 off;
    occlusion_taps: of screen-space ambient occlusion, 0 leaves the contact shading alone;
    point_stride: every so many-th pixel and row of a depth picture becomes a point."""

    shadow_size: int
    shadow_taps: int
    soft_shadows: bool
    samples: int
    occlusion_taps: int
    glow: bool
    gloss: bool
    lamps: int
    edge_segments: int
    round_segments: int
    material_size: int
    anisotropy: float
    point_stride: int


QUALITIES: Mapping[str, Quality] = {
    "low": Quality(1024, 1, False, 0, 0, False, False, 2, 1, 2, 256, 1.0, 2),
    "medium": Quality(2048, 8, False, 4, 8, True, True, 3, 2, 5, 512, 4.0, 1),
    "high": Quality(2048, 16, True, 4, 16, True, True, 3, 3, 8, 512, 8.0, 1),
}


def draws_in_software(renderer_name: str) -> bool:
    """Whether OpenGL's GL_RENDERER is one of Mesa's that draw on the processor."""
    return any(name in renderer_name.lower() for name in ("llvmpipe", "softpipe", "swrast"))


def usual_quality(renderer_name: str) -> str:
    """What to draw with where nobody chose: high on a graphics card, low where the processor has to do it all."""
    return "low" if draws_in_software(renderer_name) else "high"


def quality_named(name: str) -> Quality:
    """The preset; raises ValueError naming the valid ones."""
    if name not in QUALITIES:
        raise ValueError(f"there is no quality {name!r}; valid: {', '.join(QUALITIES)}.")
    return QUALITIES[name]
