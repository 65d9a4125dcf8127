"""Finding libusb: the system's own, or the one that the package libusb-package brings."""

import logging
from typing import Any

import usb.backend.libusb1

from kinect.usb.errors import Fault, KinectError


def load_backend() -> Any:
    """pyusb's backend on the system's libusb-1.0 if there is one, else on the wheel's. Raises KinectError where there is neither."""
    log = logging.getLogger("usb.backend.libusb1")
    was, log.disabled = log.disabled, True  # pyusb logs an error where the system has none, which is no error here
    try:
        backend = usb.backend.libusb1.get_backend() or _wheels_backend()
    finally:
        log.disabled = was
    if backend is None:
        raise no_libusb()
    return backend


def no_libusb() -> KinectError:
    """What to do where no libusb can be loaded."""
    return KinectError(
        Fault.NO_LIBUSB,
        "There is no libusb on this machine: `pip install libusb-package`, or install libusb-1.0-0 from your system's packages.",
    )


def _wheels_backend() -> Any:
    try:
        import libusb_package
    except ImportError:
        return None
    return usb.backend.libusb1.get_backend(find_library=libusb_package.find_library)
