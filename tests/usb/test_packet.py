"""A packet's header, octet by octet, and how frames are cut."""

import pytest

from kinect.usb.packet import (
    DEPTH,
    DEPTH_11,
    FIRST,
    INFRARED_10,
    LAST,
    RGB_BAYER,
    VIDEO,
    PacketHeader,
    StreamFormat,
    read_header,
    write_header,
)

FIRST_DEPTH_PACKET = bytes.fromhex("52 42 00 71 00 05 06 E0 78 56 34 12")
LAST_VIDEO_PACKET = bytes.fromhex("52 42 00 85 00 FF 00 18 01 00 00 80")


def test_twelve_literal_octets_are_a_first_depth_packet() -> None:
    header = PacketHeader(DEPTH, FIRST, 5, 1760, 0x12345678)
    assert read_header(FIRST_DEPTH_PACKET) == header
    assert write_header(header) == FIRST_DEPTH_PACKET


def test_twelve_literal_octets_are_a_last_video_packet() -> None:
    assert read_header(LAST_VIDEO_PACKET + b"anything") == PacketHeader(VIDEO, LAST, 255, 24, 0x80000001)


@pytest.mark.parametrize("octets", [b"", FIRST_DEPTH_PACKET[:11], b"BR" + FIRST_DEPTH_PACKET[2:]])
def test_what_is_no_packet_has_no_header(octets: bytes) -> None:
    assert read_header(octets) is None


@pytest.mark.parametrize(
    ("layout", "octets", "packets", "last"),
    [(DEPTH_11, 422_400, 242, 1132), (RGB_BAYER, 307_200, 162, 12), (INFRARED_10, 390_400, 205, 1168)],
)
def test_each_stream_is_cut_as_the_device_cuts_it(layout: StreamFormat, octets: int, packets: int, last: int) -> None:
    assert (layout.frame_bytes, layout.packets, layout.last_payload_bytes) == (octets, packets, last)
