"""What the overlay is given each picture frame, what it remembers between them, and what it may ask of the loop."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from game.scenes.scene import Plot
from game.tunables import Settings


@dataclass(frozen=True)
class PlacedLabel:
    """A word at a place on the screen, in overlay units from the top left; colour RGBA 0..1."""

    x: float
    y: float
    text: str
    colour: tuple[float, float, float, float]


@dataclass(frozen=True)
class View:
    """One picture frame as the overlay shows it.

    now_s: seconds on the loop's clock since the game began; speed: simulated seconds per second;
    interrupted: why the game waits for the player's sensor, empty while it does not;
    depth_picture: (h, w, 4) RGBA of what a depth camera sees, always of one size, None without one;
    plots, stage_ms (median milliseconds per stage): only filled where the overlay is to show them anew; upright_s: None where no
    scene measures it; fell: the upright time has ended.
    """

    scene: str
    settings: Settings
    now_s: float = 0.0
    time_s: float = 0.0
    score: str | None = None
    status: str = ""
    messages: tuple[str, ...] = ()
    help_keys: tuple[tuple[str, str], ...] = ()
    labels: tuple[PlacedLabel, ...] = ()
    plots: tuple[Plot, ...] = ()
    stage_ms: Mapping[str, float] = field(default_factory=dict)
    upright_s: float | None = None
    fell: bool = False
    speed: float = 1.0
    paused: bool = False
    interrupted: str = ""
    finished: bool = False
    restart_pending: bool = False
    first_input_s: float | None = None
    cameras: tuple[str, ...] = ()
    scenes: tuple[str, ...] = ()
    inputs: tuple[str, ...] = ()
    input_spec: str = ""
    depth_picture: NDArray[np.uint8] | None = None


@dataclass(frozen=True)
class Request:
    """What the player asked for: kind is an action of `game.shortcuts`, or scene, input, preset, save ...; value its object."""

    kind: str
    value: str = ""


@dataclass
class Shown:
    """Which parts of the overlay are open, and what the player has asked for since the loop last looked."""

    panel: bool = False
    plots: bool = False
    help: bool = False
    menu: bool = False
    hud: bool = True
    filter: str = ""
    requests: list[Request] = field(default_factory=list)

    def ask(self, kind: str, value: str = "") -> None:
        """Leave a request for the loop."""
        self.requests.append(Request(kind, value))

    def take_requests(self) -> list[Request]:
        """All requests since the last call, oldest first."""
        taken, self.requests = self.requests, []
        return taken
