"""Where the panels lie, so that what is written over the picture keeps clear of them. Overlay units from the top left."""

from dataclasses import dataclass

from game.overlay.view import Shown

PANEL_EM = 24.0
PLOTS_EM = 24.0
DEPTH_EM = 15.0
MARGIN_EM = 0.6


@dataclass(frozen=True)
class Area:
    """A box on the screen."""

    left: float
    top: float
    width: float
    height: float

    @property
    def right(self) -> float:
        return self.left + self.width


def panel_area(size: tuple[float, float], em: float) -> Area:
    """The tuning panel: the right edge, over the whole height."""
    width, margin = min(PANEL_EM * em, 0.62 * size[0]), MARGIN_EM * em
    return Area(size[0] - width - margin, margin, width, size[1] - 2 * margin)


def plots_area(size: tuple[float, float], em: float) -> Area:
    """The plots: the left edge, between the input's line and the hints."""
    width, top = min(PLOTS_EM * em, 0.36 * size[0]), 3.1 * em
    return Area(MARGIN_EM * em, top, width, size[1] - top - 3.0 * em)


def depth_area(shown: Shown, size: tuple[float, float], em: float) -> Area:
    """The depth camera's picture: the lower left corner, above the hints and beside the plots."""
    width = min(DEPTH_EM * em, 0.3 * size[0])
    height = 0.75 * width + 1.0 * em
    left = (plots_area(size, em).right if shown.plots else 0.0) + MARGIN_EM * em
    return Area(left, size[1] - height - 3.0 * em, width, height)


def free_span(shown: Shown, size: tuple[float, float], em: float) -> tuple[float, float]:
    """Left and right of what the open panels leave free."""
    left = plots_area(size, em).right if shown.plots else 0.0
    right = panel_area(size, em).left if shown.panel else size[0]
    return left, right
