"""From packets to frames: whole ones at the speed of a block copy, holes filled with "no data", never with old pixels."""

from types import SimpleNamespace
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinect.usb.packet import FIRST, HEADER_BYTES, LAST, MIDDLE, StreamFormat

Octets = NDArray[np.uint8]

LONGEST_GAP: Final = 5
"""Packets that may be missing in a row before the place in the frame is held to be lost.

256 packets lost at once look like none, but 256 is no multiple of a frame's 242: the place is then wrong, and the flags tell."""
FARTHEST_GAP: Final = 240
"""Beyond it a sequence number is held for one from the past, which tells of no loss."""
_HEADER: Final = np.dtype({"names": ["magic", "flag", "sequence", "ticks"], "formats": ["<u2", "u1", "u1", "<u4"], "offsets": [0, 3, 5, 8]})
_MAGIC: Final = int.from_bytes(b"RB", "little")


class AssembledFrame(NamedTuple):
    """data: (frame_bytes,) octets, all ones where a packet is missing; ticks: of its last packet; received: packets, of `expected`."""

    data: Octets
    ticks: int
    received: int
    expected: int


class Assembler:
    """Takes what transfers bring, slot by slot, and gives frames as they close.

    A frame starts as all ones (2047 in eleven bits: no data). Gaps of up to five packets leave holes; longer ones, or a packet whose
    flag contradicts its place, give the frame up until the next first packet. Nothing that arrives raises.
    """

    def __init__(self, layout: StreamFormat, tally: SimpleNamespace) -> None:
        self.layout = layout
        self._tally = tally
        n = layout.packets
        self._places = np.full(n, layout.kind | MIDDLE, np.uint8)
        self._places[0], self._places[-1] = layout.kind | FIRST, layout.kind | LAST
        self._lengths = np.full(n, HEADER_BYTES + layout.payload_bytes)
        self._lengths[-1] = HEADER_BYTES + layout.last_payload_bytes
        self._closed: list[AssembledFrame] = []
        self._rows = np.empty((n, layout.payload_bytes), np.uint8)
        self._n = -1  # the next packet's place in the frame; -1 while out of step
        self._sequence = 0  # the next packet's sequence number
        self._received = 0
        self._last_ticks = 0
        self._previous = np.empty(0, np.uint8)

    def take(self, slots: Octets, lengths: NDArray[np.uint32], statuses: NDArray[np.int32]) -> list[AssembledFrame]:
        """One transfer: (k, s) slots, (k,) octets that arrived in each, (k,) status of each (0 is sound). The frames that it closed."""
        sound = (lengths >= HEADER_BYTES) & (lengths <= slots.shape[1]) & (statuses == 0)
        header = np.ndarray(len(slots), _HEADER, slots, 0, (slots.strides[0],))
        sound &= (header["magic"] == _MAGIC) & ((header["flag"] & 0xF0) == self.layout.kind)
        used = np.flatnonzero(sound)
        empty = int(np.count_nonzero((lengths == 0) & (statuses == 0)))
        self._tally.packets += len(used)
        self._tally.empty_packets += empty
        self._tally.bad_packets += len(slots) - len(used) - empty
        flags, sequences, ticks, sizes = header["flag"][used], header["sequence"][used], header["ticks"][used], lengths[used]
        at = 0
        while at < len(used):
            run = self._regular(flags[at:], sequences[at:], sizes[at:]) if self._n >= 0 else 0
            if run:
                self._copy(slots, used[at : at + run], int(ticks[at + run - 1]))
                at += run
            else:
                if at:
                    self._previous = slots[used[at - 1], : sizes[at - 1]]
                self._irregular(slots[used[at]], int(flags[at]), int(sequences[at]), int(ticks[at]), int(sizes[at]))
                at += 1
        if len(used):
            self._previous = slots[used[-1], : lengths[used[-1]]].copy()
        closed, self._closed = self._closed, []
        return closed

    def reset(self) -> None:
        """Forget the frame in work: the stream starts anew."""
        if self._n > 0:
            self._tally.frames_abandoned += 1
        self._n = -1
        self._previous = np.empty(0, np.uint8)

    def _regular(self, flags: Octets, sequences: Octets, sizes: NDArray[np.uint32]) -> int:
        """How many of these packets simply follow one another up to the end of the frame."""
        k = min(len(flags), self.layout.packets - self._n)
        here = slice(self._n, self._n + k)
        follows = (sequences[:k] - np.arange(k, dtype=np.uint8)) == (self._sequence & 0xFF)
        wrong = np.flatnonzero(~(follows & (flags[:k] == self._places[here]) & (sizes[:k] == self._lengths[here])))
        return int(wrong[0]) if len(wrong) else k

    def _copy(self, slots: Octets, which: NDArray[np.intp], ticks: int) -> None:
        """Put packets that simply follow into their places."""
        k = len(which)
        if self._n == 0:
            self._begin(ticks)
        if which[-1] - which[0] == k - 1:
            which = slice(which[0], which[-1] + 1)  # type: ignore[assignment]  # a view instead of a copy
        self._rows[self._n : self._n + k] = slots[which, HEADER_BYTES : HEADER_BYTES + self.layout.payload_bytes]
        self._received += k
        self._sequence = (self._sequence + k) & 0xFF
        self._last_ticks = ticks
        self._n += k
        if self._n == self.layout.packets:
            self._close()

    def _irregular(self, slot: Octets, flag: int, sequence: int, ticks: int, size: int) -> None:
        """One packet that does not simply follow: a gap, a repetition, a wrong place or length, or any packet while out of step."""
        if self._n < 0:
            if flag != self._places[0]:
                return
            self._n, self._sequence = 0, sequence
        gap = (sequence - self._sequence) & 0xFF
        if gap == 0xFF and self._repeats(slot, size):
            self._tally.repeated_packets += 1
            return
        if gap:
            if gap > LONGEST_GAP:
                self._tally.lost_packets += gap if gap < FARTHEST_GAP else 0
                return self._lose_step(slot, flag, sequence, ticks, size)
            self._skip(gap, ticks)
        if flag != self._places[self._n]:
            return self._lose_step(slot, flag, sequence, ticks, size)
        if self._n == 0:
            self._begin(ticks)
        if size == self._lengths[self._n]:
            self._received += 1
        else:
            self._tally.bad_packets += 1
        if size <= self._lengths[self._n]:  # of a short one the rest is a hole, a long one is a hole altogether
            self._rows[self._n, : size - HEADER_BYTES] = slot[HEADER_BYTES:size]
        self._sequence, self._last_ticks = (sequence + 1) & 0xFF, ticks
        self._n += 1
        if self._n == self.layout.packets:
            self._close()

    def _skip(self, gap: int, ticks: int) -> None:
        """Leave a hole of `gap` packets, closing the frame if it reaches past its end."""
        self._tally.lost_packets += gap
        self._sequence = (self._sequence + gap) & 0xFF
        if self._n == 0:
            self._begin(ticks)
        self._n += gap
        beyond = self._n - self.layout.packets
        if beyond >= 0:
            self._close()
            self._n = beyond
            if beyond:
                self._begin(ticks)

    def _lose_step(self, slot: Octets, flag: int, sequence: int, ticks: int, size: int) -> None:
        """Give the frame up; if this packet begins one, go on with it."""
        self._tally.resyncs += 1
        if self._n > 0:
            self._tally.frames_abandoned += 1
        self._n = -1
        if flag == self._places[0]:
            self._irregular(slot, flag, sequence, ticks, size)

    def _begin(self, ticks: int) -> None:
        """An empty frame: all ones, so that what is missing reads as no data."""
        self._rows = np.full((self.layout.packets, self.layout.payload_bytes), 0xFF, np.uint8)
        self._received = 0
        self._last_ticks = ticks

    def _close(self) -> None:
        """Hand the frame on."""
        self._n = 0
        expected = self.layout.packets
        if self._received == expected:
            self._tally.frames_complete += 1
        else:
            self._tally.frames_partial += 1
        self._closed.append(AssembledFrame(self._rows.reshape(-1)[: self.layout.frame_bytes], self._last_ticks, self._received, expected))

    def _repeats(self, slot: Octets, size: int) -> bool:
        """Whether this packet is the one before it once more, octet by octet."""
        return np.array_equal(self._previous, slot[:size])
