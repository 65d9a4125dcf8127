"""One isochronous packet: a header of twelve octets, then a piece of a frame."""

import struct
from typing import Final, NamedTuple

MAGIC: Final = b"RB"
HEADER_BYTES: Final = 12
FIRST: Final = 1
MIDDLE: Final = 2
LAST: Final = 5
DEPTH: Final = 0x70
VIDEO: Final = 0x80

_HEADER: Final = struct.Struct("<2sBBBB2sI")
_LENGTH: Final = struct.Struct(">H")


class PacketHeader(NamedTuple):
    """kind: DEPTH or VIDEO; place: FIRST, MIDDLE or LAST of its frame; sequence: 0..255; length: of the whole packet, octets (a hint, since
    not every driver trusts it); ticks: the device's 60 MHz clock, 32 bits."""

    kind: int
    place: int
    sequence: int
    length: int
    ticks: int


class StreamFormat(NamedTuple):
    """How one kind of frame is cut into packets: which high nibble its flag carries, octets of a frame, octets a full packet carries."""

    kind: int
    frame_bytes: int
    payload_bytes: int

    @property
    def packets(self) -> int:
        """Packets that make a frame."""
        return -(-self.frame_bytes // self.payload_bytes)

    @property
    def last_payload_bytes(self) -> int:
        """What is left for the last packet."""
        return self.frame_bytes - (self.packets - 1) * self.payload_bytes


DEPTH_11: Final = StreamFormat(DEPTH, 640 * 480 * 11 // 8, 1748)
RGB_BAYER: Final = StreamFormat(VIDEO, 640 * 480, 1908)
INFRARED_10: Final = StreamFormat(VIDEO, 640 * 488 * 10 // 8, 1908)


def read_header(packet: bytes) -> PacketHeader | None:
    """The header of a packet, None where these octets are none: shorter than a header, or without its magic."""
    if len(packet) < HEADER_BYTES:
        return None
    magic, _, flag, _, sequence, length, ticks = _HEADER.unpack_from(packet)
    if magic != MAGIC:
        return None
    return PacketHeader(flag & 0xF0, flag & 0x0F, sequence, _LENGTH.unpack(length)[0], ticks)


def write_header(header: PacketHeader) -> bytes:
    """The twelve octets of a header."""
    length = _LENGTH.pack(header.length)
    return _HEADER.pack(MAGIC, 0, header.kind | header.place, 0, header.sequence & 0xFF, length, header.ticks & 0xFFFFFFFF)
