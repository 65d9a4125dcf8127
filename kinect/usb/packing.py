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
    pixels = flat.reshape(-1, GROUP_PIXELS)
    packed = np.empty((len(pixels), GROUP_BYTES), np.uint8)
    start, end = np.zeros(len(pixels), np.uint64), np.zeros(len(pixels), np.uint32)
    for pixel in range(5):
        start |= pixels[:, pixel].astype(np.uint64) << np.uint64(64 - BITS * (pixel + 1))
    start |= (pixels[:, 5] >> 2).astype(np.uint64)  # 64 bits hold five pixels and nine bits of the sixth
    for pixel in range(5, GROUP_PIXELS):
        end |= pixels[:, pixel].astype(np.uint32) << np.uint32(BITS * (GROUP_PIXELS - 1 - pixel))
    np.ndarray(len(packed), ">u8", packed, 0, (GROUP_BYTES,))[:] = start
    packed[:, 8], packed[:, 9], packed[:, 10] = end >> 16 & 0xFF, end >> 8 & 0xFF, end & 0xFF
    return packed.reshape(-1)
