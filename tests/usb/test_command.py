"""The command protocol: literal octets, and answers that come late, twice, or not at all."""

import struct
from types import SimpleNamespace
from typing import Any

import pytest

from kinect.usb.command import CameraCommands
from kinect.usb.counters import new_tally
from kinect.usb.errors import Fault, KinectError
from kinect.usb.simulated_clock import VirtualClock


class Pipe:
    """A control pipe that notes what is sent and answers from a list."""

    def __init__(self, answers: list[bytes]) -> None:
        self.sent: list[tuple[int, bytes]] = []
        self.answers = answers

    def ctrl_transfer(self, kind: int, request: int, value: int, index: int, data: Any, timeout: int) -> Any:
        assert (request, value, index) == (0, 0, 0)
        if kind == 0x40:
            self.sent.append((kind, bytes(data)))
            return len(data)
        assert kind == 0xC0 and data == 512
        return self.answers.pop(0) if self.answers else b""


def asked(answers: list[str]) -> tuple[CameraCommands, Pipe, SimpleNamespace]:
    """Commands over a pipe with these answers, in hexadecimal."""
    pipe, tally = Pipe([bytes.fromhex(a) for a in answers]), new_tally()
    return CameraCommands(pipe, VirtualClock(), tally), pipe, tally


def test_writing_a_register_is_twelve_literal_octets() -> None:
    commands, pipe, _ = asked(["52 42 01 00 03 00 00 00 00 00"])
    commands.write_register(0x06, 2)
    assert pipe.sent == [(0x40, bytes.fromhex("47 4D 02 00 03 00 00 00 06 00 02 00"))]


def test_reading_a_register_takes_the_word_behind_the_error_word() -> None:
    commands, pipe, _ = asked(["52 42 02 00 02 00 00 00 00 00 34 12"])
    assert commands.read_register(0x105) == 0x1234
    assert pipe.sent == [(0x40, bytes.fromhex("47 4D 01 00 02 00 00 00 05 01"))]


def test_tags_count_up() -> None:
    commands, pipe, _ = asked(["52 42 01 00 03 00 00 00 00 00", "52 42 01 00 03 00 01 00 00 00"])
    commands.write_register(1, 1)
    commands.write_register(1, 1)
    assert [sent[1][6] for sent in pipe.sent] == [0, 1]


def test_nothing_and_five_hundred_and_twelve_octets_both_mean_not_yet() -> None:
    commands, pipe, _ = asked(["", "00" * 512, "", "52 42 01 00 03 00 00 00 00 00"])
    commands.write_register(6, 0)
    assert len(pipe.sent) == 1


@pytest.mark.parametrize(
    "leftover",
    [
        "52 42 01 00 03 00 39 00 00 00",
        "52 42 01 00 02 00 00 00 00 00",
        "47 4D 01 00 03 00 00 00 00 00",
        "52 42 09 00 03 00 00 00 00 00",
        "52",
    ],
)
def test_answers_to_other_questions_are_passed_over(leftover: str) -> None:
    commands, pipe, tally = asked([leftover, "52 42 01 00 03 00 00 00 00 00"])
    commands.write_register(6, 0)
    assert tally.replies_stale == 1 and len(pipe.sent) == 1


def test_a_device_that_is_not_ready_is_asked_again_with_a_new_tag() -> None:
    commands, pipe, tally = asked(["52 42 01 00 03 00 00 00 0D 00", "52 42 01 00 03 00 01 00 00 00"])
    commands.write_register(6, 2)
    assert len(pipe.sent) == 2 and tally.commands_not_ready == 1


def test_a_device_that_is_never_ready_is_refused_in_the_end() -> None:
    commands, _, _ = asked([f"52 42 01 00 03 00 {tag:02x} {tag >> 8:02x} 0D 00" for tag in range(255)])
    with pytest.raises(KinectError, match="not ready"):
        commands.write_register(6, 2)


def test_a_refusal_names_its_reason() -> None:
    commands, _, _ = asked(["52 42 01 00 03 00 00 00 05 00"])
    with pytest.raises(KinectError, match=r"0x03 \(bad parameters\)"):
        commands.write_register(6, 9)


def test_a_silent_device_is_given_three_chances_and_then_a_sentence() -> None:
    commands, pipe, _ = asked([])
    with pytest.raises(KinectError, match="does not answer command 0x02") as caught:
        commands.read_register(6)
    assert caught.value.fault is Fault.PROTOCOL and len(pipe.sent) == 3


def test_a_payload_is_whole_words_and_not_too_long() -> None:
    commands, _, _ = asked([])
    with pytest.raises(ValueError, match="even number"):
        commands.ask(4, b"\0")
    with pytest.raises(ValueError, match="at most 1016"):
        commands.ask(4, struct.pack("<600H", *range(600)))
