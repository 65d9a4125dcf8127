"""The camera's command protocol on control endpoint 0: one question, one answer, each with a tag."""

import errno
import struct
import threading
from types import SimpleNamespace
from typing import Any, Final

import usb.core

from kinect.usb.clock import Clock
from kinect.usb.errors import Fault, KinectError

COMMAND_MAGIC: Final = b"GM"
REPLY_MAGIC: Final = b"RB"
HEADER: Final = struct.Struct("<2sHHH")
OUT: Final = 0x40
IN: Final = 0xC0
REPLY_BYTES: Final = 512
"""Asked for; a reply of exactly so many octets means "not yet", like one of none."""
LARGEST_PAYLOAD: Final = 0x3F8

READ_REGISTER: Final = 0x02
WRITE_REGISTER: Final = 0x03
NOT_READY: Final = 13
ERRORS: Final = {
    1: "unknown error",
    2: "invalid command",
    3: "checksum",
    4: "bad packet size",
    5: "bad parameters",
    12: "bad command size",
    NOT_READY: "not ready",
    14: "overflow",
}

POLL_S: Final = 0.001
REPLY_DEADLINE_S: Final = 1.0
READY_PAUSE_S: Final = 0.01
READY_DEADLINE_S: Final = 2.0
ATTEMPTS: Final = 3
TIMEOUT_MS: Final = 250


class _NoReply(Exception):
    """The deadline passed without the answer to this question."""


class CameraCommands:
    """Questions to one camera, one at a time."""

    def __init__(self, device: Any, clock: Clock, tally: SimpleNamespace) -> None:
        self._device, self._clock, self._tally = device, clock, tally
        self._tag = 0
        self._lock = threading.Lock()

    def ask(self, code: int, payload: bytes = b"") -> bytes:
        """The reply's payload behind its error word. Asks again while the device is not ready, and where an answer got lost.

        Raises KinectError where it refuses or stays silent, usb.core.USBError where the bus does (unplugged, for one).
        """
        if len(payload) % 2 or len(payload) > LARGEST_PAYLOAD:
            raise ValueError(f"a command's payload is an even number of octets, at most {LARGEST_PAYLOAD}; this one has {len(payload)}")
        with self._lock:
            deadline = self._clock.now() + READY_DEADLINE_S
            lost = 0
            while True:
                try:
                    reply = self._ask_once(code, payload)
                except (_NoReply, usb.core.USBError) as error:
                    lost += 1
                    if lost == ATTEMPTS or getattr(error, "errno", None) in (errno.ENODEV, errno.EACCES):
                        raise self._silent(code) if isinstance(error, _NoReply) else error from None
                    self._tally.commands_repeated += 1
                    self._clock.sleep(READY_PAUSE_S)
                    continue
                problem = int.from_bytes(reply[:2], "little")
                if problem == NOT_READY and self._clock.now() < deadline:
                    self._tally.commands_not_ready += 1
                    self._clock.sleep(READY_PAUSE_S)
                    continue
                if problem:
                    name = ERRORS.get(problem, f"error {problem}")
                    raise KinectError(
                        Fault.PROTOCOL, f"The Kinect refuses command {code:#04x} ({name}): unplug it, wait five seconds, plug it in again."
                    )
                return reply[2:]

    def read_register(self, register: int) -> int:
        """The value of one of the camera's registers."""
        reply = self.ask(READ_REGISTER, struct.pack("<H", register))
        if len(reply) < 2:
            raise KinectError(Fault.PROTOCOL, f"The Kinect's answer for register {register:#x} is empty: unplug it and plug it in again.")
        return int.from_bytes(reply[:2], "little")

    def write_register(self, register: int, value: int) -> None:
        """Set one of the camera's registers."""
        self.ask(WRITE_REGISTER, struct.pack("<HH", register, value))

    def _ask_once(self, code: int, payload: bytes) -> bytes:
        """Send once, and poll until the answer with this code and tag has come; older answers are leftovers of a program that died."""
        tag, self._tag = self._tag, (self._tag + 1) & 0xFFFF
        self._tally.commands += 1
        self._device.ctrl_transfer(OUT, 0, 0, 0, HEADER.pack(COMMAND_MAGIC, len(payload) // 2, code, tag) + payload, TIMEOUT_MS)
        deadline = self._clock.now() + REPLY_DEADLINE_S
        while self._clock.now() < deadline:
            reply = bytes(self._device.ctrl_transfer(IN, 0, 0, 0, REPLY_BYTES, TIMEOUT_MS))
            if len(reply) in (0, REPLY_BYTES):
                self._clock.sleep(POLL_S)
                continue
            if _answers(reply, code, tag):
                return reply[HEADER.size :]
            self._tally.replies_stale += 1
        raise _NoReply

    def _silent(self, code: int) -> KinectError:
        return KinectError(
            Fault.PROTOCOL,
            f"The Kinect does not answer command {code:#04x}: unplug it (and its power), wait five seconds, plug it in again.",
        )


def _answers(reply: bytes, code: int, tag: int) -> bool:
    """Whether this is a whole, well-formed reply to the command with this code and tag."""
    if len(reply) < HEADER.size + 2:
        return False
    magic, words, its_code, its_tag = HEADER.unpack_from(reply)
    return magic == REPLY_MAGIC and its_code == code and its_tag == tag and words * 2 == len(reply) - HEADER.size
