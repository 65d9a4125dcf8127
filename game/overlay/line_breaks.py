"""A sentence broken into lines that are not too wide."""

from collections.abc import Callable


def lines_within(text: str, limit: float, width: Callable[[str], float]) -> list[str]:
    """The words of `text` in order, each line at most `limit` wide by `width`, but for a single word wider than that."""
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and width(longer) <= limit:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
