"""What the two fighters wear: a colour for each part, and trim (visor, eyes, belt, gloves, soles) that makes a somebody of it."""

from dataclasses import dataclass
from typing import Literal

Place = tuple[float, float, float]
Surface = Literal["shell", "soft", "gloss", "glow"]


@dataclass(frozen=True)
class Trim:
    """A box fixed to a part, in the part's own frame and in units of its half size, so that it fits every morphology.

    at: centre; size: half size; grow_m: metres added to the half size on each axis; tilt_deg: turned about the part's x axis.
    """

    part: str
    at: Place
    size: Place
    colour: str
    surface: Surface = "shell"
    grow_m: Place = (0.0, 0.0, 0.0)
    tilt_deg: float = 0.0


@dataclass(frozen=True)
class Costume:
    """parts: colour "#rrggbb" by part name, sides left out; joints: colour of the balls in the joints; trim: the rest."""

    parts: dict[str, str]
    joints: str
    trim: tuple[Trim, ...]


def _both(part: str, at: Place, size: Place, colour: str, surface: Surface = "shell", grow_m: Place = (0.0, 0.0, 0.0)) -> tuple[Trim, Trim]:
    left = Trim(f"{part}_left", at, size, colour, surface, grow_m)
    return left, Trim(f"{part}_right", (at[0], -at[1], at[2]), size, colour, surface, grow_m)


def _face(visor: str, eye: str, brow_deg: float, eye_size: tuple[float, float]) -> tuple[Trim, ...]:
    """A dark visor round the front of the head, and two glowing eyes on it."""
    wide, tall = eye_size
    return (
        Trim("head", (0.80, 0.0, 0.14), (0.28, 0.90, 0.40), visor, "gloss", (0.0, 0.0, 0.0)),
        Trim("head", (1.04, 0.40, 0.16), (0.06, wide, tall), eye, "glow", (0.0, 0.0, 0.0), -brow_deg),
        Trim("head", (1.04, -0.40, 0.16), (0.06, wide, tall), eye, "glow", (0.0, 0.0, 0.0), brow_deg),
    )


def _shoes(shoe: str, sole: str, lace: str) -> tuple[Trim, ...]:
    rim = (0.006, 0.006, 0.0)
    return (
        *_both("foot", (0.0, 0.0, -0.74), (1.0, 1.0, 0.26), sole, "shell", rim),
        *_both("foot", (0.72, 0.0, -0.10), (0.30, 1.0, 0.62), sole, "soft", (0.004, 0.004, 0.0)),
        *_both("foot", (0.12, 0.0, 1.0), (0.30, 0.62, 0.10), lace, "soft"),
        *_both("foot", (-0.96, 0.0, 0.35), (0.08, 0.5, 0.4), lace, "soft"),
    )


_CREAM, _ORANGE, _TEAL, _DEEP_TEAL, _NIGHT = "#f3e4c8", "#e8622a", "#1f9e96", "#1c646a", "#1d2026"

PLAYER = Costume(
    {
        "pelvis": _DEEP_TEAL,
        "trunk": _ORANGE,
        "head": _CREAM,
        "upper_arm": _ORANGE,
        "lower_arm": _CREAM,
        "hand": _TEAL,
        "upper_leg": _DEEP_TEAL,
        "lower_leg": _CREAM,
        "foot": _ORANGE,
    },
    "#2c2f36",
    (
        *_face(_NIGHT, "#35e8d8", 0.0, (0.17, 0.19)),
        Trim("head", (0.0, 0.0, 0.80), (1.0, 1.0, 0.10), _ORANGE, "soft", (0.004, 0.004, 0.0)),
        Trim("head", (0.0, 0.0, 1.04), (0.80, 0.22, 0.10), _ORANGE, "soft"),
        Trim("head", (0.05, 1.05, 0.05), (0.36, 0.10, 0.24), _TEAL, "soft"),
        Trim("head", (0.05, -1.05, 0.05), (0.36, 0.10, 0.24), _TEAL, "soft"),
        Trim("trunk", (0.0, 0.0, 0.10), (1.0, 1.0, 0.13), _CREAM, "soft", (0.004, 0.004, 0.0)),
        Trim("trunk", (0.0, 0.0, -0.10), (1.0, 1.0, 0.035), _TEAL, "soft", (0.004, 0.004, 0.0)),
        Trim("trunk", (0.0, 0.0, 1.0), (0.85, 0.50, 0.06), _TEAL, "soft"),
        Trim("trunk", (-1.12, 0.0, 0.12), (0.26, 0.62, 0.58), _TEAL, "shell"),
        Trim("trunk", (-1.36, 0.0, 0.30), (0.06, 0.22, 0.12), "#ffb030", "glow"),
        Trim("pelvis", (0.0, 0.0, 0.72), (1.0, 1.0, 0.22), _NIGHT, "soft", (0.005, 0.005, 0.0)),
        Trim("pelvis", (1.02, 0.0, 0.72), (0.06, 0.17, 0.26), "#e9b949", "gloss"),
        *_both("upper_arm", (0.0, 0.0, -0.62), (1.0, 1.0, 0.10), _CREAM, "soft", (0.004, 0.004, 0.0)),
        *_both("lower_arm", (0.0, 0.0, -0.74), (1.0, 1.0, 0.20), _TEAL, "soft", (0.005, 0.005, 0.0)),
        *_both("hand", (0.62, 0.0, 0.30), (0.50, 0.72, 0.30), _TEAL, "soft"),
        *_both("lower_leg", (0.0, 0.0, -0.30), (1.0, 1.0, 0.06), _ORANGE, "soft", (0.004, 0.004, 0.0)),
        *_both("lower_leg", (0.0, 0.0, -0.46), (1.0, 1.0, 0.06), _TEAL, "soft", (0.004, 0.004, 0.0)),
        *_both("lower_leg", (0.62, 0.0, 0.80), (0.55, 0.80, 0.26), _TEAL, "soft", (0.004, 0.0, 0.0)),
        *_shoes(_ORANGE, "#f7f1e4", _DEEP_TEAL),
    ),
)

_LILAC, _VIOLET, _INK, _CRIMSON, _GOLD = "#cfc6d8", "#5a2f8c", "#2a2238", "#c8234a", "#e9b949"

OPPONENT = Costume(
    {
        "pelvis": _INK,
        "trunk": _VIOLET,
        "head": _LILAC,
        "upper_arm": _LILAC,
        "lower_arm": _INK,
        "hand": _CRIMSON,
        "upper_leg": _INK,
        "lower_leg": _LILAC,
        "foot": _INK,
    },
    "#1c1824",
    (
        *_face("#17131f", "#ff2a48", 16.0, (0.24, 0.10)),
        Trim("head", (-0.05, 0.0, 1.16), (0.86, 0.14, 0.24), _CRIMSON, "soft"),
        Trim("head", (-0.35, 0.0, 0.94), (0.66, 0.30, 0.10), _VIOLET, "soft"),
        Trim("head", (0.10, 1.04, 0.0), (0.26, 0.08, 0.30), _GOLD, "gloss"),
        Trim("head", (0.10, -1.04, 0.0), (0.26, 0.08, 0.30), _GOLD, "gloss"),
        Trim("trunk", (1.0, 0.0, 0.12), (0.05, 1.02, 0.10), _GOLD, "soft", (0.0, 0.0, 0.0), 32.0),
        Trim("trunk", (-1.0, 0.0, 0.12), (0.05, 1.02, 0.10), _GOLD, "soft", (0.0, 0.0, 0.0), 32.0),
        Trim("trunk", (0.0, 0.74, 1.0), (0.90, 0.26, 0.08), _CRIMSON, "soft"),
        Trim("trunk", (0.0, -0.74, 1.0), (0.90, 0.26, 0.08), _CRIMSON, "soft"),
        Trim("pelvis", (0.0, 0.0, 0.66), (1.0, 1.0, 0.30), _GOLD, "soft", (0.005, 0.005, 0.0)),
        Trim("pelvis", (1.05, 0.0, 0.66), (0.06, 0.24, 0.36), _CRIMSON, "gloss"),
        *_both("upper_arm", (0.0, 0.0, 0.72), (1.0, 1.0, 0.30), _VIOLET, "soft", (0.008, 0.008, 0.006)),
        *_both("lower_arm", (0.0, 0.0, -0.72), (1.0, 1.0, 0.22), _CRIMSON, "soft", (0.006, 0.006, 0.0)),
        *_both("lower_arm", (0.0, 0.0, -0.44), (1.0, 1.0, 0.05), _GOLD, "soft", (0.006, 0.006, 0.0)),
        *_both("hand", (0.62, 0.0, 0.30), (0.50, 0.72, 0.30), _CRIMSON, "soft"),
        *_both("upper_leg", (0.0, 0.96, 0.0), (0.22, 0.06, 0.98), _GOLD, "soft"),
        *_both("lower_leg", (0.62, 0.0, 0.30), (0.50, 0.84, 0.66), _VIOLET, "soft", (0.004, 0.0, 0.0)),
        *_shoes(_INK, _CRIMSON, _GOLD),
    ),
)

COSTUMES = (PLAYER, OPPONENT)
