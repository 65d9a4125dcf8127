"""What can go wrong on the wire, each in one sentence that says what to do about it."""

import errno
from enum import Enum

import usb.core


class Fault(Enum):
    """The kinds of trouble that have a remedy of their own."""

    NO_LIBUSB = "no libusb"
    NO_DEVICE = "no device"
    NO_POWER = "no 12 V supply"
    PERMISSION = "permission"
    BUSY = "busy"
    UNPLUGGED = "unplugged"
    REFUSED = "stream refused"
    SILENT = "no frames"
    LOSSY = "packets lost"
    KINECT_V2 = "Kinect v2"
    AZURE = "Azure Kinect"
    PROTOCOL = "no sensible answer"
    UNSUPPORTED = "not possible with this model"
    WRONG_DRIVER = "wrong driver"


class KinectError(Exception):
    """Something about the device that a person can act on; its text is one plain sentence with the remedy."""

    def __init__(self, fault: Fault, sentence: str) -> None:
        super().__init__(sentence)
        self.fault = fault


def explained(error: Exception, what: str) -> KinectError:
    """The same trouble in plain words. `what` names the device, as in "the Kinect's camera (bus 1, port 2.1)"."""
    if isinstance(error, KinectError):
        return error
    number = error.errno if isinstance(error, usb.core.USBError) else None
    if isinstance(error, NotImplementedError):
        return KinectError(
            Fault.WRONG_DRIVER,
            f"libusb cannot use {what} with the driver it has now; on Windows, bind it to WinUSB or libusbK with Zadig.",
        )
    if number == errno.EACCES:
        return KinectError(
            Fault.PERMISSION,
            f"You may not open {what}: install the udev rule (run_game.py kinect install-rules) and plug the Kinect in again.",
        )
    if number == errno.EBUSY:
        return KinectError(
            Fault.BUSY, f"Something else is using {what}: close the other program, or unload its kernel driver (sudo rmmod gspca_kinect)."
        )
    if number in (errno.ENODEV, errno.ENOENT):
        return KinectError(Fault.UNPLUGGED, f"{what[:1].upper()}{what[1:]} is gone: plug the Kinect in again.")
    return KinectError(Fault.PROTOCOL, f"{what[:1].upper()}{what[1:]} does not answer ({error}): unplug the Kinect and plug it in again.")
