"""One depth picture as the sensor sent it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class RawDepthFrame:
    """disparity: (480, 640) raw values 0..2047, growing with distance, 2047 no data; rows run down, columns right, not mirrored.

    ticks: the device's 60 MHz clock, 32 bits. time_s: capture time, seconds since the source's first frame, strictly growing.
    packets, packets_expected: how many of the frame's packets arrived; what is missing reads 2047.
    """

    disparity: NDArray[np.uint16]
    ticks: int
    time_s: float
    packets: int = 242
    packets_expected: int = 242

    @property
    def has_holes(self) -> bool:
        """Whether packets of this frame were lost."""
        return self.packets < self.packets_expected


@dataclass(frozen=True)
class RawVideoFrame:
    """One colour (Bayer GRBG, 640x480 octets) or infrared (10-bit packed, 640x488) picture as octets; ticks and time_s as in depth."""

    octets: NDArray[np.uint8]
    ticks: int
    host_s: float
    packets: int
    packets_expected: int
