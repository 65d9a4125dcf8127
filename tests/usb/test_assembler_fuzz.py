"""More than a million packets dropped, repeated, exchanged, cut short and corrupted at random: nothing raises, no frame lies."""

import numpy as np
import pytest

from kinect.usb.assembler import AssembledFrame, Assembler
from kinect.usb.counters import new_tally, snapshot
from kinect.usb.packet import DEPTH_11, HEADER_BYTES
from tests.usb.packet_stream import PACKETS, SLOT, marked_frame, slots_of

FRAMES_A_ROUND = 12
SPOILED = 8


def spoiled(slots: np.ndarray, lengths: np.ndarray, random: np.random.Generator) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """One round's packets after a bad journey, mild or rough."""
    count, rate = len(slots), float(random.choice([0.001, 0.01, 0.05]))
    order = np.arange(count)
    order = np.delete(order, np.flatnonzero(random.random(count) < rate))
    if random.random() < 0.5:
        burst, at = int(random.integers(1, 520)), int(random.integers(0, count))
        order = order[(order < at) | (order >= at + burst)]
    order = np.sort(np.append(order, order[random.random(len(order)) < rate]))
    swaps = np.flatnonzero(random.random(len(order) - 1) < rate)
    order[swaps], order[swaps + 1] = order[swaps + 1].copy(), order[swaps].copy()
    slots, lengths = slots[order].copy(), lengths[order].copy()
    statuses = np.where(random.random(len(order)) < rate, random.integers(1, 7, len(order)), 0).astype(np.int32)
    cut = random.random(len(order)) < rate
    lengths[cut] = random.integers(0, SLOT + 1, np.count_nonzero(cut))
    bad = np.flatnonzero(random.random(len(order)) < rate)
    slots[bad, random.integers(0, HEADER_BYTES, len(bad))] = random.integers(0, 256, len(bad))
    return slots, lengths, statuses


def tells_the_truth(frame: AssembledFrame, first: int) -> int:
    """The frame's number; fails where any octet is neither its own nor "no data"."""
    rows = np.full((PACKETS, DEPTH_11.payload_bytes), 0xFF, np.uint8)
    rows.reshape(-1)[: DEPTH_11.frame_bytes] = frame.data
    full = np.flatnonzero(rows[:, 0] != 0xFF)
    assert len(full) >= frame.received
    k = int(rows[full[0], 0]) | int(rows[full[0], 1]) << 7
    true = np.full_like(rows, 0xFF)
    true.reshape(-1)[: DEPTH_11.frame_bytes] = marked_frame(k)
    assert ((rows == true) | (rows == 0xFF)).all(), "a frame shows octets that are not its own"
    assert k >= first, "a frame shows the past"
    if frame.received == PACKETS:
        assert (rows == true).all()
    return k


def fuzz(packets: int, seed: int) -> tuple[int, int]:
    """Packets fed, frames checked."""
    random = np.random.default_rng(seed)
    tally = new_tally()
    assembler = Assembler(DEPTH_11, tally)
    fed = checked = 0
    k = 0
    while fed < packets:
        slots, lengths = slots_of(range(k, k + FRAMES_A_ROUND))
        bad = slice(0, SPOILED * PACKETS)
        clean = slice(SPOILED * PACKETS, None)
        journey = spoiled(slots[bad], lengths[bad], random)
        parts = [*journey], [slots[clean], lengths[clean], np.zeros(len(slots[clean]), np.int32)]
        shown: list[int] = []
        for part in parts:
            at = 0
            while at < len(part[0]):
                n = int(random.integers(1, 130))
                frames = assembler.take(*(np.ascontiguousarray(a[at : at + n]) for a in part))
                shown += [tells_the_truth(frame, k) for frame in frames]
                at += n
            fed += len(part[0])
        assert shown == sorted(set(shown)), "a frame was shown twice, or after its time"
        assert shown[-(FRAMES_A_ROUND - SPOILED) :] == list(range(k + SPOILED, k + FRAMES_A_ROUND)), (
            "not clean again at the first clean frame"
        )
        checked += len(shown)
        k += FRAMES_A_ROUND
    counted = snapshot(tally)
    assert counted.packets <= fed and counted.frames_complete + counted.frames_partial == checked
    return fed, checked


def test_a_hundred_thousand_packets_on_a_bad_journey() -> None:
    fed, checked = fuzz(100_000, seed=20221)
    assert fed >= 100_000 and checked > 150


@pytest.mark.slow
def test_more_than_a_million_packets_on_a_bad_journey() -> None:
    fed, checked = fuzz(1_000_000, seed=1517)
    assert fed >= 1_000_000 and checked > 1_500
