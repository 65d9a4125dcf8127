"""What a source that sees depth can be asked, besides bodies."""

from typing import Protocol, runtime_checkable

from kinect.body import Floor
from kinect.depth.depth_frame import DepthFrame


@runtime_checkable
class SeesDepth(Protocol):
    """A body source with a depth camera."""

    @property
    def floor(self) -> Floor | None:
        """The plane of the floor in the sensor frame, None while none was seen."""
        ...

    @property
    def drawn_floor(self) -> Floor | None:
        """The floor, or a guess good enough to draw with; None before the first picture."""
        ...

    def depth(self) -> DepthFrame | None:
        """The newest depth frame of the time last polled for, None before the first."""
        ...


def depth_seen_by(source: object) -> SeesDepth | None:
    """The source with a depth camera inside `source`, however deeply it is wrapped; None where there is none."""
    while source is not None and not isinstance(source, SeesDepth):
        source = getattr(source, "source", None)
    return source
