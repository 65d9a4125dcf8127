"""libusb-1.0's functions over simulated hosts, called by pyusb's own, unchanged backend.

pyusb keeps the library in a variable of its module, so the simulation runs in a second copy of that module: the real libusb, if
there is one, never sees a simulated pointer, nor the other way round.
"""

import importlib.util
import sys
from functools import lru_cache
from typing import Any, Final

from kinect.usb.simulated_bus_calls import BusCalls
from kinect.usb.simulated_host import SimulatedHost
from kinect.usb.simulated_transfer_calls import TransferCalls

MODULE: Final = "kinect.usb._pyusb_libusb1_simulated"


def simulated_backend(host: SimulatedHost) -> Any:
    """pyusb's libusb-1.0 backend on this host, for `usb.core.find(backend=...)`."""
    module = _pyusb()
    module._lib.next_host = host
    return module._LibUSB(module._lib)


def in_use(host: SimulatedHost) -> dict[str, int]:
    """How much the programs under simulation hold of this host at this moment."""
    library = _pyusb()._lib
    mine = {number for number, (owner, _) in library.known.items() if owner is host}
    return {
        "handles": sum(owner is host for owner, _ in library.handles.values()),
        "transfers": sum(library.owners.get(address, host) is host for address in library.transfers),
        "references": sum(library.references[number] for number in mine),
    }


def kill_program(host: SimulatedHost) -> None:
    """The program that uses this host dies without a word: the system closes what it held, the devices stay as they are."""
    _pyusb()._lib.forget_program(host)


def misuse() -> list[str]:
    """What would have corrupted memory or hung in the real library, since the last call."""
    library = _pyusb()._lib
    found, library.misuse = library.misuse, []
    return found


@lru_cache(maxsize=1)
def _pyusb() -> Any:
    spec = importlib.util.find_spec("usb.backend.libusb1")
    assert spec is not None and spec.origin is not None
    copy = importlib.util.spec_from_file_location(MODULE, spec.origin)
    assert copy is not None and copy.loader is not None
    module: Any = importlib.util.module_from_spec(copy)
    sys.modules[MODULE] = module
    copy.loader.exec_module(module)
    module._lib = SimulatedLibusb(module)
    module._setup_prototypes(module._lib)
    return module


class SimulatedLibusb(BusCalls, TransferCalls):
    """The library object. Its functions are plain ones, so that pyusb can write prototypes onto them as onto C's."""

    def __init__(self, module: Any) -> None:
        super().__init__(module)
        for name in dir(type(self)):
            if name.startswith("libusb_"):
                setattr(self, name, _plain(getattr(self, name)))


def _plain(method: Any) -> Any:
    return lambda *arguments: method(*arguments)
