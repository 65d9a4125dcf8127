"""What a camera puts on the wire, microframe by microframe: frames cut into packets at the real pace, silence between them."""

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kinect.usb.capture_time import DEPTH_PERIOD_TICKS, TICKS_PER_S
from kinect.usb.packet import FIRST, HEADER_BYTES, LAST, MIDDLE, PacketHeader, StreamFormat, write_header
from kinect.usb.packing import pack11

MICROFRAMES_PER_S: Final = 8000
MICROFRAMES_PER_FRAME: Final = DEPTH_PERIOD_TICKS * MICROFRAMES_PER_S / TICKS_PER_S

Octets = NDArray[np.uint8]
FrameSource = Callable[[int], Octets | None]
"""Frame k as octets, None where the camera sends none in that place."""


def replayed(frames: Sequence[NDArray[np.uint16]], places: Sequence[int] | None = None, loop: bool = True) -> FrameSource:
    """Raw disparity pictures as a camera would send them. `places`: each one's place in time, 33.4 ms apart."""
    where = {place - places[0]: i for i, place in enumerate(places)} if places else {i: i for i in range(len(frames))}
    length = max(where, default=-1) + 1

    @lru_cache(maxsize=64)
    def packed(index: int) -> Octets:
        return pack11(frames[index])

    def frame(k: int) -> Octets | None:
        if not length or (k >= length and not loop):
            return None
        index = where.get(k % length)
        return None if index is None else packed(index)

    return frame


class SimulatedStream:
    """One endpoint's timeline from the microframe in which it was switched on."""

    def __init__(self, layout: StreamFormat, source: FrameSource, start: int, ticks: int = 0) -> None:
        self.layout, self.source, self.start, self.ticks = layout, source, start, ticks
        self.delivered = 0
        self._made: dict[int, Octets | None] = {}

    def packets(self, k: int) -> Octets | None:
        """(packets, header + payload) octets of frame k."""
        if k not in self._made:
            data = self.source(k)
            self._made = {j: p for j, p in self._made.items() if j == k - 1}
            self._made[k] = None if data is None else self._cut(k, data)
        return self._made[k]

    def fill(self, begin: int, slots: Octets) -> NDArray[np.uint32]:
        """Put what the microframes from `begin` on carry into (n, s) slots; the (n,) octets in each."""
        lengths = np.zeros(len(slots), np.uint32)
        end = begin + len(slots)
        k = max(int((begin - self.start) / MICROFRAMES_PER_FRAME) - 1, 0)
        while (at := self._begins(k)) < end:
            low, high = max(at, begin), min(at + self.layout.packets, end)
            packets = self.packets(k) if high > low else None
            if packets is not None:
                slots[low - begin : high - begin, : packets.shape[1]] = packets[low - at : high - at]
                lengths[low - begin : high - begin] = packets.shape[1]
                if high == at + self.layout.packets:
                    lengths[high - begin - 1] = HEADER_BYTES + self.layout.last_payload_bytes
            k += 1
        self.delivered += int(np.count_nonzero(lengths))
        return lengths

    def frames_sent(self, now: int) -> int:
        """Whole frames that the camera has put on the wire up to this microframe."""
        return sum(self._begins(k) + self.layout.packets <= now for k in range(int((now - self.start) / MICROFRAMES_PER_FRAME) + 1))

    def _begins(self, k: int) -> int:
        return self.start + int(np.ceil(k * MICROFRAMES_PER_FRAME))

    def _cut(self, k: int, data: Octets) -> Octets:
        n, payload = self.layout.packets, self.layout.payload_bytes
        packets = np.zeros((n, HEADER_BYTES + payload), np.uint8)
        ticks = self.ticks + DEPTH_PERIOD_TICKS * k
        header = write_header(PacketHeader(self.layout.kind, MIDDLE, 0, HEADER_BYTES + payload, ticks))
        packets[:, :HEADER_BYTES] = np.frombuffer(header, np.uint8)
        packets[0, 3], packets[-1, 3] = self.layout.kind | FIRST, self.layout.kind | LAST
        packets[:, 5] = (n * k + np.arange(n)) & 0xFF
        last = HEADER_BYTES + self.layout.last_payload_bytes
        packets[-1, 6], packets[-1, 7] = last >> 8, last & 0xFF
        whole = (n - 1) * payload
        packets[:-1, HEADER_BYTES:] = data[:whole].reshape(n - 1, payload)
        packets[-1, HEADER_BYTES:last] = data[whole:]
        return packets
