"""The names inside pyusb that keeping several transfers in flight needs, gathered in one place, since pyusb does not promise them."""

import sys
from ctypes import POINTER, c_int, c_long, c_void_p
from ctypes import Structure as CStructure
from typing import Any, Final, NamedTuple

LIBRARY_NAMES: Final = (
    "libusb_alloc_transfer",
    "libusb_fill_iso_transfer",
    "libusb_set_iso_packet_lengths",
    "libusb_submit_transfer",
    "libusb_free_transfer",
    "libusb_cancel_transfer",
    "libusb_handle_events_timeout_completed",
    "libusb_get_max_iso_packet_size",
)
MODULE_NAMES: Final = ("_libusb_transfer", "_libusb_transfer_cb_fn_p", "_libusb_iso_packet_descriptor", "_DeviceHandle")


class NamesMissing(Exception):
    """This pyusb is not built as the ring expects; the text lists what it lacks."""


class TimeValue(CStructure):
    """C's struct timeval."""

    _fields_ = (("seconds", c_long), ("microseconds", c_long))


class PyusbInside(NamedTuple):
    """What pyusb has loaded and declared for one opened device: the C library, its context, the open handle, and pyusb's own module."""

    library: Any
    context: Any
    handle: Any
    module: Any


def inside(device: Any) -> PyusbInside:
    """The private side of an opened pyusb device. Raises NamesMissing, naming what this pyusb lacks."""
    backend = device.backend
    missing = [f"backend.{name}" for name in ("lib", "ctx") if not hasattr(backend, name)]
    resources = getattr(device, "_ctx", None)
    missing += [] if hasattr(resources, "managed_open") else ["Device._ctx.managed_open"]
    module = sys.modules.get(type(backend).__module__)
    missing += [name for name in MODULE_NAMES if not hasattr(module, name)]
    library = getattr(backend, "lib", None)
    missing += [name for name in LIBRARY_NAMES if not hasattr(library, name)]
    if missing:
        raise NamesMissing(f"this pyusb lacks {', '.join(missing)}; version 1.3.1 has them")
    assert module is not None and library is not None and resources is not None  # none of them is among what is missing
    library.libusb_cancel_transfer.argtypes = [POINTER(module._libusb_transfer)]
    library.libusb_handle_events_timeout_completed.argtypes = [c_void_p, POINTER(TimeValue), POINTER(c_int)]
    handle = resources.managed_open()
    if not hasattr(handle, "handle"):
        raise NamesMissing("this pyusb lacks _DeviceHandle.handle; version 1.3.1 has it")
    return PyusbInside(library, backend.ctx, handle.handle, module)
