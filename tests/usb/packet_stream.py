"""Depth packets that know where they belong, for tests of the assembler."""

import numpy as np

from kinect.usb.packet import DEPTH_11, HEADER_BYTES
from kinect.usb.simulated_stream import SimulatedStream

PACKETS = DEPTH_11.packets
SLOT = 1920


def marked_frame(k: int) -> np.ndarray:
    """(422400,) octets below 0x80 in which every packet's piece tells its frame and place."""
    places = np.arange(PACKETS)
    rows = np.empty((PACKETS, DEPTH_11.payload_bytes), np.uint8)
    rows[:] = ((places * 31 + k * 17) & 0x7F)[:, None]
    rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3] = k & 0x7F, k >> 7 & 0x7F, places & 0x7F, places >> 7
    return rows.reshape(-1)[: DEPTH_11.frame_bytes]


def frame_number(data: np.ndarray, place: int) -> int:
    """Which frame the piece at this place came from."""
    at = place * DEPTH_11.payload_bytes
    return int(data[at]) | int(data[at + 1]) << 7


def slots_of(frames: range) -> tuple[np.ndarray, np.ndarray]:
    """(242 n, 1920) slots and (242 n,) lengths of these frames."""
    stream = SimulatedStream(DEPTH_11, marked_frame, 0)
    slots = np.zeros((PACKETS * len(frames), SLOT), np.uint8)
    lengths = np.full(len(slots), HEADER_BYTES + DEPTH_11.payload_bytes, np.uint32)
    for i, k in enumerate(frames):
        packets = stream.packets(k)
        assert packets is not None
        slots[PACKETS * i : PACKETS * (i + 1), : packets.shape[1]] = packets
    lengths[PACKETS - 1 :: PACKETS] = HEADER_BYTES + DEPTH_11.last_payload_bytes
    return slots, lengths
