"""Eleven-bit pixels: eight of them in eleven octets, the most significant bit first, as the depth stream packs them."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

BITS: Final = 11
GROUP_PIXELS: Final = 8
GROUP_BYTES: Final = 11


def unpack11(packed: NDArray[np.uint8]) -> NDArray[np.uint16]:
    """(n,) octets, a multiple of 11, to (n * 8 / 11,) values 0..2047."""
    if packed.ndim != 1 or packed.size % GROUP_BYTES:
        raise ValueError(f"eleven-bit pixels come in groups of 11 octets; {packed.size} octets of shape {packed.shape} do not divide so")
    groups = np.ascontiguousarray(packed).reshape(-1, GROUP_BYTES)
    values = np.empty((len(groups), GROUP_PIXELS), np.uint16)
    # Two big-endian words cover a group's 88 bits: octets 0..7 hold pixels 0..4, octets 3..10 hold pixels 3..7.
    start = np.ndarray(len(groups), ">u8", groups, 0, (GROUP_BYTES,)).astype(np.uint64)
    end = np.ndarray(len(groups), ">u8", groups, GROUP_BYTES - 8, (GROUP_BYTES,)).astype(np.uint64)
    for pixel in range(GROUP_PIXELS):
        word, shift = (start, 64 - BITS * (pixel + 1)) if pixel < 5 else (end, BITS * (GROUP_PIXELS - 1 - pixel))
        values[:, pixel] = word >> np.uint64(shift)  # the cast to 16 bits drops most of what is above
    values &= 0x7FF
    return values.reshape(-1)


def pack11(values: NDArray[np.uint16]) -> NDArray[np.uint8]:
    """Values 0..2047, a multiple of 8 of them in any shape, to (n * 11 / 8,) octets: the inverse of `unpack11`."""
    flat = np.asarray(values).reshape(-1)
    if flat.size % GROUP_PIXELS:
        raise ValueError(f"eleven-bit pixels are packed in groups of 8; {flat.size} values do not divide so")
    if flat.size and (flat.min() < 0 or flat.max() > 0x7FF):
        raise ValueError(f"eleven-bit pixels lie in 0..2047, but these reach from {flat.min()} to {flat.max()}")
    p = flat.reshape(-1, GROUP_PIXELS).astype(np.uint32).T
    packed = np.empty((len(flat) // GROUP_PIXELS, GROUP_BYTES), np.uint8)
    for octet in range(GROUP_BYTES):
        bits = np.zeros(packed.shape[0], np.uint32)
        for pixel in range(GROUP_PIXELS):
            left = 8 * (octet + 1) - BITS * (pixel + 1)  # how far the pixel's last bit stands before the octet's last bit
            if -8 < -left < BITS:
                bits |= p[pixel] << left if left >= 0 else p[pixel] >> -left
        packed[:, octet] = bits & 0xFF
    return packed.reshape(-1)
