"""Packets to frames: whole, with holes, and out of step."""

import numpy as np
import pytest

from kinect.usb.assembler import AssembledFrame, Assembler
from kinect.usb.counters import Counters, new_tally, snapshot
from kinect.usb.packet import DEPTH_11
from kinect.usb.simulated_stream import SimulatedStream
from tests.usb.packet_stream import PACKETS, frame_number, marked_frame, slots_of


def assemble(
    slots: np.ndarray, lengths: np.ndarray, statuses: np.ndarray | None = None, at_once: int = 64
) -> tuple[list[AssembledFrame], Counters]:
    """Feed transfers of 64 slots to a new assembler."""
    tally = new_tally()
    assembler = Assembler(DEPTH_11, tally)
    statuses = np.zeros(len(slots), np.int32) if statuses is None else statuses
    frames: list[AssembledFrame] = []
    for i in range(0, len(slots), at_once):
        part = slice(i, i + at_once)
        frames += assembler.take(np.ascontiguousarray(slots[part]), lengths[part], statuses[part])
    return frames, snapshot(tally)


def without(places: list[int], frames: range = range(3)) -> tuple[list[AssembledFrame], Counters]:
    """Three frames, less these packets of all that are sent."""
    slots, lengths = slots_of(frames)
    keep = np.setdiff1d(np.arange(len(slots)), places)
    return assemble(slots[keep], lengths[keep])


def holes(frame: AssembledFrame) -> list[int]:
    """Places at which a frame is all ones."""
    rows = np.full(PACKETS * DEPTH_11.payload_bytes, 0xFF, np.uint8)
    rows[: frame.data.size] = frame.data
    return np.flatnonzero((rows.reshape(PACKETS, -1) == 0xFF).all(axis=1)).tolist()


@pytest.mark.parametrize("at_once", [1, 16, 64, 1000])
def test_whole_frames_come_out_octet_by_octet_however_they_are_dealt_out(at_once: int) -> None:
    slots, lengths = slots_of(range(5))
    frames, counted = assemble(slots, lengths, at_once=at_once)
    assert [f.received for f in frames] == [242] * 5
    for k, frame in enumerate(frames):
        np.testing.assert_array_equal(frame.data, marked_frame(k))
    assert counted == Counters(packets=5 * 242, frames_complete=5)


def test_a_frame_bears_the_ticks_of_its_last_packet() -> None:
    slots, lengths = slots_of(range(1))
    slots[-1, 8:12] = [1, 2, 3, 4]
    slots[:-1, 8:12] = [0, 2, 3, 4]
    assert assemble(slots, lengths)[0][0].ticks == 0x04030201


@pytest.mark.parametrize("missing", [[300], [300, 301], [300, 301, 302, 303, 304], [300, 310, 400]])
def test_up_to_five_missing_in_a_row_are_holes_without_data(missing: list[int]) -> None:
    frames, counted = without(missing)
    assert [f.received for f in frames] == [242, 242 - len(missing), 242]
    assert holes(frames[1]) == [m - PACKETS for m in missing]
    assert counted.lost_packets == len(missing) and counted.frames_partial == 1 and counted.resyncs == 0


def test_six_missing_in_a_row_give_the_frame_up_and_the_next_one_is_whole() -> None:
    frames, counted = without([300, 301, 302, 303, 304, 305])
    assert [frame_number(f.data, 0) for f in frames] == [0, 2]
    assert counted.frames_abandoned == 1 and counted.resyncs == 1 and counted.lost_packets == 6


@pytest.mark.parametrize(
    ("missing", "received"), [([241], [241, 242, 242]), ([242], [242, 241, 242]), ([240, 241, 242, 243], [240, 240, 242])]
)
def test_a_gap_across_the_end_closes_one_frame_and_begins_the_next(missing: list[int], received: list[int]) -> None:
    frames, _ = without(missing)
    assert [f.received for f in frames] == received
    assert [frame_number(f.data, 100) for f in frames] == [0, 1, 2]


def test_a_stream_caught_in_the_middle_begins_with_the_next_whole_frame() -> None:
    frames, counted = without(list(range(100)))
    assert [frame_number(f.data, 0) for f in frames] == [1, 2]
    assert counted.resyncs == 0


def test_a_repeated_packet_is_dropped_without_a_trace() -> None:
    slots, lengths = slots_of(range(2))
    order = np.sort(np.append(np.arange(len(slots)), [63, 64, 100, 241, 242]))
    frames, counted = assemble(slots[order], lengths[order])
    assert [f.received for f in frames] == [242, 242]
    assert counted.repeated_packets == 5 and counted.resyncs == 0


def test_exchanged_packets_never_join_two_frames() -> None:
    slots, lengths = slots_of(range(3))
    order = np.arange(len(slots))
    order[[100, 101]] = [101, 100]
    frames, _ = assemble(slots[order], lengths[order])
    assert [frame_number(f.data, 0) for f in frames] == [1, 2]


def test_as_many_lost_packets_as_the_sequence_counts_do_not_join_two_frames() -> None:
    frames, _ = without(list(range(100, 100 + 256)), range(4))
    for frame in frames:
        assert {frame_number(frame.data, n) for n in range(PACKETS)} == {frame_number(frame.data, 0)}
    assert [frame_number(f.data, 0) for f in frames] == [2, 3]


@pytest.mark.parametrize("spoil", ["status", "magic", "short", "video", "long"])
def test_an_unsound_packet_is_a_hole(spoil: str) -> None:
    slots, lengths = slots_of(range(2))
    statuses = np.zeros(len(slots), np.int32)
    if spoil == "status":
        statuses[50] = 1
    elif spoil == "magic":
        slots[50, 0] = 0
    elif spoil == "short":
        lengths[50] = 11
    elif spoil == "video":
        slots[50, 3] = 0x82
    else:
        lengths[50] = 1800
    frames, counted = assemble(slots, lengths, statuses)
    assert [f.received for f in frames] == [241, 242]
    assert holes(frames[0]) == [50] and counted.bad_packets == 1


def test_a_truncated_packet_gives_what_it_has_and_the_rest_is_no_data() -> None:
    slots, lengths = slots_of(range(1))
    lengths[50] = 12 + 1000
    frame = assemble(slots, lengths)[0][0]
    start = 50 * 1748
    np.testing.assert_array_equal(frame.data[start : start + 1000], marked_frame(0)[start : start + 1000])
    assert (frame.data[start + 1000 : start + 1748] == 0xFF).all() and frame.received == 241


def test_sequence_numbers_wrap_across_frames_and_empty_slots_do_not_matter() -> None:
    stream = SimulatedStream(DEPTH_11, marked_frame, 0)
    slots = np.zeros((267 * 10, 1920), np.uint8)
    lengths = stream.fill(0, slots)
    frames, counted = assemble(slots, lengths)
    assert len(frames) == 10 and counted.empty_packets == 267 * 10 - 2420 and counted.lost_packets == 0
