"""Taking a device for ourselves: kernel driver away, interface claimed, the alternate setting that has the streams."""

import contextlib
from typing import Any, Final

import usb.core
import usb.util

from kinect.usb.errors import Fault, KinectError, explained
from kinect.usb.stream_registers import DEPTH_ENDPOINT, VIDEO_ENDPOINT

INTERFACE: Final = 0
ISOCHRONOUS: Final = 1


def claim_camera(device: Any, what: str) -> None:
    """Claim the camera's interface and choose the setting with both streams. Raises KinectError with the remedy, with nothing left open."""
    try:
        claim_interface(device)
        setting = _setting_with_streams(device, what)
        if setting:
            device.set_interface_altsetting(INTERFACE, setting)
    except (usb.core.USBError, NotImplementedError, KinectError) as error:
        let_go(device)
        raise explained(error, what) from None


def claim_interface(device: Any) -> None:
    """Detach the kernel's driver (on Linux gspca_kinect takes every camera for a webcam) and claim interface 0."""
    with contextlib.suppress(NotImplementedError):  # Windows and macOS know no such thing
        if device.is_kernel_driver_active(INTERFACE):
            device.detach_kernel_driver(INTERFACE)
    usb.util.claim_interface(device, INTERFACE)


def let_go(device: Any) -> None:
    """Release everything of this device and close its handle. Never raises: it may be unplugged by now."""
    with contextlib.suppress(usb.core.USBError):
        usb.util.dispose_resources(device)


def _setting_with_streams(device: Any, what: str) -> int:
    wanted = {VIDEO_ENDPOINT, DEPTH_ENDPOINT}
    for interface in device.get_active_configuration():
        found = {e.bEndpointAddress for e in interface if e.bmAttributes & 3 == ISOCHRONOUS}
        if interface.bInterfaceNumber == INTERFACE and wanted <= found:
            return interface.bAlternateSetting
    raise KinectError(
        Fault.PROTOCOL, f"No setting of {what} offers its two streams: unplug the Kinect, wait five seconds, plug it in again."
    )
