"""What the simulated libusb knows: contexts, devices, handles, transfers, and what a program did wrong with them."""

import itertools
from typing import Any

from kinect.usb.simulated_devices import ERROR_NO_DEVICE, SimulatedDevice
from kinect.usb.simulated_host import SimulatedHost


def number_of(value: Any) -> int:
    """What a pointer-like argument points to, as the C side would see it."""
    return int(getattr(value, "value", value) or 0)


class SimulatedLibrary:
    """The state behind the functions. `module`: the copy of pyusb's libusb1 that calls them."""

    def __init__(self, module: Any) -> None:
        self.module = module
        self.next_host: SimulatedHost | None = None
        self.contexts: dict[int, SimulatedHost] = {}
        self.known: dict[int, tuple[SimulatedHost, SimulatedDevice]] = {}
        self.references: dict[int, int] = {}
        self.handles: dict[int, tuple[SimulatedHost, SimulatedDevice]] = {}
        self.transfers: dict[int, Any] = {}
        self.owners: dict[int, SimulatedHost] = {}
        self.misuse: list[str] = []
        self._numbers = itertools.count(0x1000, 0x10)
        self._configurations: dict[int, Any] = {}
        self._lists: dict[int, Any] = {}

    def forget_program(self, host: SimulatedHost) -> None:
        """The program that used this host was killed: its handles and transfers are gone without a word."""
        self.handles = {h: entry for h, entry in self.handles.items() if entry[0] is not host}
        for address in list(host.submissions):
            self.transfers.pop(address, None)
        host.forget_program()

    def device_number(self, host: SimulatedHost, device: SimulatedDevice) -> int:
        for number, entry in self.known.items():
            if entry == (host, device):
                return number
        number = next(self._numbers)
        self.known[number] = (host, device)
        self.references[number] = 0
        return number

    def device_of(self, handle: Any) -> SimulatedDevice | None:
        entry = self.handles.get(number_of(handle))
        return entry[1] if entry else None

    def gone(self, handle: Any) -> int:
        device = self.device_of(handle)
        return ERROR_NO_DEVICE if device is None or device.gone else 0
