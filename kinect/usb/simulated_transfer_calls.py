"""libusb's functions that move data: control and bulk requests, isochronous transfers and the events that end them."""

import ctypes
from typing import Any, Final

import numpy as np

from kinect.usb.simulated_devices import ERROR_BUSY, ERROR_NO_DEVICE, ERROR_NOT_FOUND
from kinect.usb.simulated_library import SimulatedLibrary, number_of

CONTROL_S: Final = 0.0005
IN: Final = 0x80
DESCRIPTOR: Final = np.dtype([("length", "<u4"), ("actual", "<u4"), ("status", "<i4")])


class TransferCalls(SimulatedLibrary):
    """Named and called as in libusb.h."""

    def libusb_control_transfer(
        self, handle: Any, kind: int, request: int, value: int, index: int, data: Any, length: int, timeout: int
    ) -> int:
        entry = self.handles.get(number_of(handle))
        if entry is None:
            return ERROR_NO_DEVICE
        host, device = entry
        host.clock.sleep(CONTROL_S)
        with host.lock:
            host.dispatch()  # as in libusb: whoever waits for a control transfer handles the events of the others too
            if device.gone:
                return ERROR_NO_DEVICE
            sent = bytes(data[:length]) if length and not kind & IN else b""
            answer = device.control(not kind & IN, request, value, sent, length, host.clock.now())
        return _hand_over(answer, data, length, len(sent))

    def libusb_bulk_transfer(self, handle: Any, endpoint: int, data: Any, length: int, transferred: Any, timeout: int) -> int:
        entry = self.handles.get(number_of(handle))
        if entry is None or entry[1].gone:
            return ERROR_NO_DEVICE
        sent = b"" if endpoint & IN else bytes(data[:length])
        result = _hand_over(entry[1].bulk(endpoint, sent, length), data, length, len(sent))
        transferred._obj.value = max(result, 0)
        return min(result, 0)

    def libusb_interrupt_transfer(self, *_: Any) -> int:
        return ERROR_NOT_FOUND

    def libusb_get_max_iso_packet_size(self, device: Any, endpoint: int) -> int:
        found = self.known[number_of(device)][1]
        sizes = [size for address, _, size in found.settings[found.setting] if address == endpoint]
        return (sizes[0] & 0x7FF) * (1 + (sizes[0] >> 11 & 3)) if sizes else ERROR_NOT_FOUND

    def libusb_alloc_transfer(self, packets: int) -> Any:
        size = ctypes.sizeof(self.module._libusb_transfer) + max(packets - 1, 0) * DESCRIPTOR.itemsize
        memory = ctypes.create_string_buffer(size)
        transfer = self.module._libusb_transfer.from_buffer(memory)
        self.transfers[ctypes.addressof(transfer)] = transfer
        return ctypes.pointer(transfer)

    def libusb_free_transfer(self, transfer: Any) -> None:
        address = ctypes.addressof(transfer.contents)
        if any(address in host.submissions for host in self.contexts.values()):
            self.misuse.append("freed a transfer in flight")
        self.transfers.pop(address, None)
        self.owners.pop(address, None)

    def libusb_submit_transfer(self, pointer: Any) -> int:
        transfer = pointer.contents
        address = ctypes.addressof(transfer)
        entry = self.handles.get(number_of(transfer.dev_handle))
        if entry is None:
            return ERROR_NO_DEVICE
        host, device = entry
        if address in host.submissions or address not in self.transfers:
            self.misuse.append("submitted a transfer that is in flight or freed")
            return ERROR_BUSY
        if device.claimed_by != number_of(transfer.dev_handle) and not device.gone:
            self.misuse.append("submitted a transfer without a claim")
        kept = self.transfers[address]
        self.owners[address] = host
        packets = transfer.num_iso_packets
        memory = (ctypes.c_char * (packets * DESCRIPTOR.itemsize)).from_address(ctypes.addressof(transfer.iso_packet_desc))
        descriptors = np.frombuffer(memory, DESCRIPTOR)
        buffer = (ctypes.c_ubyte * transfer.length).from_address(transfer.buffer)
        slots = np.frombuffer(buffer, np.uint8).reshape(packets, -1)

        def finish(status: int, lengths: Any, statuses: Any) -> None:
            descriptors["actual"], descriptors["status"] = lengths, statuses
            kept.status, kept.actual_length = status, int(lengths.sum())
            kept.callback(pointer)

        with host.lock:
            return host.submit(address, device, transfer.endpoint, slots, finish)

    def libusb_cancel_transfer(self, pointer: Any) -> int:
        address = ctypes.addressof(pointer.contents)
        for host in self.contexts.values():
            with host.lock:
                if host.cancel(address):
                    return 0
        return ERROR_NOT_FOUND

    def libusb_handle_events(self, context: Any) -> int:
        self.contexts[number_of(context)].handle_events(60.0)
        return 0

    def libusb_handle_events_timeout_completed(self, context: Any, wait: Any, completed: Any) -> int:
        self.contexts[number_of(context)].handle_events(wait._obj.seconds + wait._obj.microseconds * 1e-6)
        return 0


def _hand_over(answer: bytes | int, data: Any, length: int, sent: int) -> int:
    """libusb's result for a transfer: an error, the octets read, or the octets written."""
    if isinstance(answer, int):
        return answer
    answer = answer[:length]
    if answer:
        ctypes.memmove(data, answer, len(answer))
    return len(answer) or sent
