"""Models 1473 and K4W: newer ones leave the bus after seconds unless their LED is set once, through the audio device."""

import struct
from typing import Any, Final

import usb.core

from kinect.usb.claim import claim_interface, let_go

MAGIC: Final = 0x06022009
SET_LED: Final = 0x10
GREEN: Final = 3
BULK_OUT: Final = 0x01
BULK_IN: Final = 0x81
REPLY_BYTES: Final = 512
TIMEOUT_MS: Final = 250


def led_command(tag: int, colour: int = GREEN) -> bytes:
    """The twenty octets that set the LED."""
    return struct.pack("<5I", MAGIC, tag, 0, SET_LED, colour)


def keep_alive(audio: Any) -> bool:
    """Set the LED green. False where the device would not: harmless, since older ones stay on the bus without it."""
    try:
        claim_interface(audio)
        audio.write(BULK_OUT, led_command(1), TIMEOUT_MS)
        audio.read(BULK_IN, REPLY_BYTES, TIMEOUT_MS)
        return True
    except (usb.core.USBError, NotImplementedError, ValueError):
        return False
    finally:
        let_go(audio)
