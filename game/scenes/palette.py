"""Colours as people write them, turned into the linear light that drawables carry."""

Colour = tuple[float, float, float, float]


def paint(code: str) -> Colour:
    """Linear RGBA of an sRGB colour "#rrggbb"; raises ValueError for anything else."""
    if len(code) != 7 or code[0] != "#":
        raise ValueError(f"{code!r} is no colour; write it as #rrggbb.")
    red, green, blue = (_linear(int(code[i : i + 2], 16) / 255.0) for i in (1, 3, 5))
    return (red, green, blue, 1.0)


def _linear(value: float) -> float:
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
