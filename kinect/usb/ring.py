"""A ring of isochronous transfers on pyusb's own libusb handle: while one is read, the others go on listening.

The stream fills almost every one of 8,000 microframes a second, and a microframe without a queued transfer is lost. The ring's length in
milliseconds (transfers x packets / 8) must exceed the longest time for which this process can hold the interpreter lock.
"""

from collections.abc import Callable
from ctypes import POINTER, addressof, byref, c_char, c_ubyte, cast
from types import SimpleNamespace
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinect.usb.errors import Fault, KinectError
from kinect.usb.pyusb_names import TimeValue, inside

Consume = Callable[[NDArray[np.uint8], NDArray[np.uint32], NDArray[np.int32]], None]
"""Takes (k, s) slots, (k,) octets that arrived in each, (k,) their statuses. All three are overwritten after it returns."""

COMPLETED: Final = 0
CANCELLED: Final = 3
NO_DEVICE: Final = 5
ERROR_NO_DEVICE: Final = -4
DESCRIPTOR: Final = np.dtype([("length", "<u4"), ("actual", "<u4"), ("status", "<i4")])
SMALL: Final = (16, 16)
"""What to try where the host refuses the asked length."""

_kept_for_ever: list[Any] = []
"""Transfers that never came back: libusb may still write to their memory, so it is never freed."""


class RingSize(NamedTuple):
    """Transfers in flight, packets in each (a multiple of 8 for WinUSB). 14 x 64 listens for 112 ms ahead."""

    transfers: int = 14
    packets: int = 64


DEFAULT_SIZE: Final = RingSize()


class _Slot(NamedTuple):
    transfer: Any
    data: NDArray[np.uint8]
    descriptors: NDArray[Any]


class IsoRing:
    """The transfers of one endpoint of one opened and claimed device."""

    def __init__(self, device: Any, endpoint: int, consume: Consume, tally: SimpleNamespace, size: RingSize = DEFAULT_SIZE) -> None:
        if size.transfers < 1 or size.packets < 8 or size.packets % 8:
            raise ValueError(f"a ring has at least one transfer, of a multiple of 8 packets; {size.transfers} x {size.packets} is not one")
        self.size = size
        self.unplugged = False
        self.last_error = ""
        self.in_flight = 0
        self._device, self._endpoint, self._consume, self._tally = device, endpoint, consume, tally
        self._inside = inside(device)
        self._callback: Any = None
        self._slots: dict[int, _Slot] = {}
        self._stopping = False

    def start(self) -> None:
        """Queue all transfers; where the host refuses so many, queue 16 x 16. Raises KinectError where it refuses these too."""
        if self._slots:
            raise RuntimeError("this ring is already running; stop it first")
        for size in (self.size, RingSize(*SMALL)):
            self.size = size
            refused = self._submit_all()
            if refused == 0:
                return
            self.stop()
            if self.unplugged:
                raise KinectError(Fault.UNPLUGGED, "The Kinect was unplugged while its stream was being started: plug it in again.")
        raise KinectError(
            Fault.REFUSED,
            f"The USB host refuses the Kinect's stream (libusb error {refused}): plug the Kinect into another port, "
            "straight into the computer, with no hub and no webcam beside it.",
        )

    def pump(self, timeout_s: float) -> None:
        """Let libusb call back for what has arrived, waiting at most `timeout_s`."""
        seconds = int(timeout_s)
        wait = TimeValue(seconds, int((timeout_s - seconds) * 1e6))
        self._inside.library.libusb_handle_events_timeout_completed(self._inside.context, byref(wait), None)

    def stop(self, patience: int = 20) -> None:
        """Cancel every transfer, wait until each has come back (at most `patience` x 100 ms), free them. Harmless when stopped."""
        self._stopping = True
        for slot in self._slots.values():
            self._inside.library.libusb_cancel_transfer(slot.transfer)  # an error means that it is on its way back already
        for _ in range(patience):
            if self.in_flight <= 0:
                break
            self.pump(0.1)
        if self.in_flight > 0:
            self._tally.transfers_undrained += self.in_flight
            _kept_for_ever.append((self._slots, self._callback, self._device))
        else:
            for slot in self._slots.values():
                self._inside.library.libusb_free_transfer(slot.transfer)
        self._slots, self._callback = {}, None  # the callback refers to this ring: without this only the garbage collector would free both
        self.in_flight = 0
        self._stopping = False

    def _submit_all(self) -> int:
        """0, or libusb's first refusal."""
        library = self._inside.library
        packet_bytes = library.libusb_get_max_iso_packet_size(self._device._ctx.dev.devid, self._endpoint)
        if packet_bytes <= 0:
            return int(packet_bytes)
        self._callback = self._inside.module._libusb_transfer_cb_fn_p(self._completed)
        slots = [self._make(packet_bytes) for _ in range(self.size.transfers)]
        self._slots = {addressof(slot.transfer.contents): slot for slot in slots}
        for slot in slots:
            result = library.libusb_submit_transfer(slot.transfer)
            if result != 0:
                self._tally.submissions_failed += 1
                self.unplugged |= result == ERROR_NO_DEVICE
                return int(result)
            self.in_flight += 1
        return 0

    def _make(self, packet_bytes: int) -> _Slot:
        library, packets = self._inside.library, self.size.packets
        data = np.zeros((packets, packet_bytes), np.uint8)
        transfer = library.libusb_alloc_transfer(packets)
        buffer = cast(data.ctypes.data, POINTER(c_ubyte))
        library.libusb_fill_iso_transfer(
            transfer, self._inside.handle, self._endpoint, buffer, data.nbytes, packets, self._callback, None, 0
        )
        library.libusb_set_iso_packet_lengths(transfer, packet_bytes)
        memory: Any = (c_char * (packets * DESCRIPTOR.itemsize)).from_address(addressof(transfer.contents.iso_packet_desc))
        return _Slot(transfer, data, np.ndarray(packets, DESCRIPTOR, memory))

    def _completed(self, transfer: Any) -> None:
        """libusb's call for a transfer that came back, in any thread that handles events. It must always give the transfer back."""
        slot = self._slots.get(addressof(transfer.contents))
        if slot is None:
            return  # of a ring that gave up waiting for it
        status = transfer.contents.status
        try:
            if status == COMPLETED:
                self._tally.transfers_completed += 1
                if not self._stopping:
                    self._consume(slot.data, slot.descriptors["actual"], slot.descriptors["status"])
            elif status == NO_DEVICE or (status == CANCELLED and not self._stopping):
                self.unplugged = True
            elif status != CANCELLED:
                self._tally.transfers_failed += 1
        except Exception as error:  # ctypes would print and swallow it, and this transfer would never listen again
            self._tally.callback_errors += 1
            self.last_error = f"{type(error).__name__}: {error}"
        finally:
            self._give_back(slot)

    def _give_back(self, slot: _Slot) -> None:
        result = 0
        if not (self._stopping or self.unplugged):
            result = self._inside.library.libusb_submit_transfer(slot.transfer)
            if result == 0:
                return
            self._tally.submissions_failed += 1
            self.unplugged |= result == ERROR_NO_DEVICE
        self.in_flight -= 1
