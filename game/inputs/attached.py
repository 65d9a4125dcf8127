"""What `auto` says of the Kinect that is, or is not, attached."""

from collections.abc import Callable
from typing import Any, Final

STEERS: Final = "keys and gamepad steer a puppet."


def greeting(load: Callable[[], Any] | None = None) -> str:
    """One or two sentences for a player: why keys steer, and what an attached Kinect can show already. load: gives pyusb's backend."""
    from kinect.usb.discovery import find_kinects
    from kinect.usb.errors import Fault, KinectError
    from kinect.usb.libusb import load_backend

    try:
        model = find_kinects((load or load_backend)()).first().model.value
    except KinectError as fault:
        if fault.fault in (Fault.NO_DEVICE, Fault.NO_LIBUSB):
            return f"No Kinect is attached, so {STEERS}"
        return f"{fault!s} Meanwhile {STEERS}"
    except Exception:  # whatever a bus may do, keys go on steering
        return f"No Kinect can be looked for here, so {STEERS}"
    return f"{model} is attached, but bodies are not tracked from depth yet, so {STEERS} --input kinect shows what it sees."
