"""The fall-back where pyusb's inside has changed: several threads, each waiting in pyusb's public, synchronous isochronous read.

It keeps the endpoint busy like the ring, but learns neither statuses nor lengths, and cannot be cancelled: a stop waits up to one read.
pyusb 1.3.1 never frees the transfer of a synchronous read (3 kB each here, 30 a second): good for an evening, not for a museum.
"""

import array
import errno
import queue
import threading
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, Final

import numpy as np
import usb.core
from numpy.typing import NDArray

from kinect.usb.packet import HEADER_BYTES, MAGIC

THREADS: Final = 4
PACKETS: Final = 256
TIMEOUT_MS: Final = 1000
_MAGIC: Final = np.frombuffer(MAGIC, np.uint8)


class IsoReadThreads:
    """Same interface as the ring."""

    def __init__(
        self,
        device: Any,
        endpoint: int,
        consume: Callable[[NDArray[np.uint8], NDArray[np.uint32], NDArray[np.int32]], None],
        tally: SimpleNamespace,
        threads: int = THREADS,
        packets: int = PACKETS,
    ) -> None:
        self.unplugged = False
        self.last_error = ""
        self._device, self._endpoint, self._consume, self._tally = device, endpoint, consume, tally
        self._count, self._packets = threads, packets
        self._threads: list[threading.Thread] = []
        self._turn = threading.Lock()
        self._taken = 0
        self._arrived: queue.SimpleQueue[tuple[int, NDArray[np.uint8] | None]] = queue.SimpleQueue()
        self._waiting: dict[int, NDArray[np.uint8] | None] = {}
        self._next = 0
        self._stopping = threading.Event()

    @property
    def in_flight(self) -> int:
        """Threads that read."""
        return sum(thread.is_alive() for thread in self._threads)

    def start(self) -> None:
        """Let all threads read."""
        self._stopping.clear()
        self._taken = self._next = 0
        self._waiting.clear()
        self._arrived = queue.SimpleQueue()
        endpoint = next(e for i in self._device.get_active_configuration() for e in i if e.bEndpointAddress == self._endpoint)
        size = endpoint.wMaxPacketSize & 0x7FF
        size *= 1 + (endpoint.wMaxPacketSize >> 11 & 3)
        names = [f"kinect-read-{i}" for i in range(self._count)]
        self._threads = [threading.Thread(target=self._read, args=(size,), name=name, daemon=True) for name in names]
        for thread in self._threads:
            thread.start()

    def pump(self, timeout_s: float) -> None:
        """Hand on what was read, in the order in which the reads were begun."""
        try:
            turn, slots = self._arrived.get(timeout=timeout_s)
        except queue.Empty:
            return
        self._waiting[turn] = slots
        while self._next in self._waiting:
            slots = self._waiting.pop(self._next)
            self._next += 1
            if slots is not None:
                self._consume(slots, slot_lengths(slots), np.zeros(len(slots), np.int32))

    def stop(self) -> None:
        """Let every thread finish its read."""
        self._stopping.set()
        for thread in self._threads:
            thread.join(2 * TIMEOUT_MS / 1000)
        self._tally.transfers_undrained += self.in_flight
        self._threads = []

    def _read(self, packet_bytes: int) -> None:
        while not (self._stopping.is_set() or self.unplugged):
            buffer = array.array("B", bytes(self._packets * packet_bytes))
            with self._turn:
                turn, self._taken = self._taken, self._taken + 1
            slots = None
            try:
                self._device.read(self._endpoint, buffer, TIMEOUT_MS)
                slots = np.frombuffer(buffer, np.uint8).reshape(self._packets, packet_bytes)
                self._tally.transfers_completed += 1
            except usb.core.USBError as error:
                self._tally.transfers_failed += 1
                self.last_error = str(error)
                self.unplugged |= error.errno == errno.ENODEV
            self._arrived.put((turn, slots))


def slot_lengths(slots: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """What a synchronous read does not tell: a slot without a packet's magic is empty, and a packet's header tells its length."""
    lengths = slots[:, 6].astype(np.uint32) << 8 | slots[:, 7]
    full = (slots[:, :2] == _MAGIC).all(axis=1)
    return np.where(full, np.maximum(lengths, HEADER_BYTES), 0).astype(np.uint32)
