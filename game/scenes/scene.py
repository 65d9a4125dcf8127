"""The one contract of a scene: what the loop, the renderer, the overlay and the report may ask of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from game.drawables import Layer


@dataclass(frozen=True)
class Plot:
    """One live plot: its title, the unit of its y axis, and named series of (x, y) arrays, newest last.

    kind "time": x is seconds, y may hold NaN where there was nothing to show; kind "plan": x, y are metres seen from above
    (x right = world -y, y up = world +x); kind "bars": y is a share of each of `names`, x its row there.
    looks: how a series is drawn where its kind leaves a choice. Of a plan: area, trail, point, goal (of the point with that name
    less its " wanted"), other (of somebody else), landing (of a step), and a foot that touches, lifted, stands, follows (the
    player's), steps (on its own) or flies. Over time: planned (of the series with that name less its " planned").
    note: what has to be said about it, empty for nothing.
    """

    title: str
    unit: str
    series: Mapping[str, tuple[NDArray[np.float64], NDArray[np.float64]]]
    kind: str = "time"
    looks: Mapping[str, str] = field(default_factory=dict)
    names: tuple[str, ...] = ()
    note: str = ""


@dataclass(frozen=True)
class CameraHint:
    """Where a scene would like the camera: eye and target (3,) m, world frame, vertical field of view in degrees."""

    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    fov_deg: float = 40.0


class Scene(Protocol):
    """One playable situation. All time inside is simulated time."""

    @property
    def name(self) -> str: ...

    @property
    def time_s(self) -> float:
        """Simulated seconds since `enter`, the start-up hang excluded (negative during it)."""
        ...

    @property
    def finished(self) -> bool:
        """True once a recording has been played to its end (never for a live input)."""
        ...

    def enter(self) -> None:
        """Build the world and place the characters. May be called again to restart from the beginning."""
        ...

    def fixed_update(self) -> None:
        """Advance exactly one 60 Hz picture frame of simulated time (a whole number of physics steps, 8 of 1/480 s by default)."""
        ...

    def drawables(self, blend: float) -> tuple[Layer, ...]:
        """What to draw, `blend` of the way (0..1) from the state before the last fixed update to the state after it."""
        ...

    def readouts(self) -> Mapping[str, float | str]:
        """Named measures for the overlay and the report; units are part of the name."""
        ...

    def plots(self) -> tuple[Plot, ...]:
        """Live plots for the overlay."""
        ...

    def messages(self) -> tuple[str, ...]:
        """Sentences for the player: which input is live, what was lost, who fell. Newest last."""
        ...

    def score(self) -> str | None:
        """The score line of a game, or None where nothing is counted."""
        ...

    def help_keys(self) -> tuple[tuple[str, str], ...]:
        """(key, what it does) pairs to show on screen for this scene's input."""
        ...

    def cameras(self) -> Mapping[str, CameraHint]:
        """Camera presets by name; the first is where a newcomer starts."""
        ...

    def leave(self) -> None:
        """Release inputs. Calling it twice is harmless."""
        ...
