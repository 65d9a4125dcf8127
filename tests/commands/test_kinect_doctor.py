"""The doctor of a Kinect: everything that can be wrong has its sentence and its remedy, and only a picture ends it with 0."""

import subprocess
import threading
from pathlib import Path
from typing import NamedTuple

import pytest

from game.commands import BAD_INPUT, main
from game.commands.kinect_doctor import as_text
from game.commands.kinect_examination import Examination, Sight, examine
from game.commands.kinect_findings import Finding, Mark, findings
from game.commands.kinect_host import HostFacts
from game.commands.kinect_sight import CutOff
from game.commands.kinect_simulations import MEANINGS
from kinect.body import Floor
from kinect.usb.clock import WallClock
from kinect.usb.counters import Counters
from kinect.usb.discovery import Found, FoundKinect
from kinect.usb.errors import Fault
from kinect.usb.models import Model
from kinect.usb.motor import MotorState
from kinect.usb.simulated_clock import VirtualClock
from kinect.usb.simulated_faults import FAULTS, simulate
from kinect.usb.simulated_libusb import in_use
from tests.door.the_door import ROOT, knock


class Expected(NamedTuple):
    """The exit status, the subjects that are marked WRONG, and words of the sentence and of the remedy."""

    status: int
    wrong: tuple[str, ...]
    words: tuple[str, ...]
    seconds: float = 2.0


FINE = "The Kinect sends depth, and all is well."
SAID = {
    "no-libusb": Expected(1, ("libusb",), ("There is no libusb", "pip install libusb-package")),
    "none": Expected(0, (), (FINE, "model 1414", "97% of the picture", "0.90 m over the floor", "looks level", "from 2.3 m on")),
    "permission": Expected(1, ("access",), ("You may not open", "Type: sudo ", "kinect install-rules --yes", "plug it in again")),
    "busy": Expected(1, ("access",), ("Something else is using", "freenect-glview", "rmmod gspca_kinect", "end it")),
    "webcam-driver": Expected(0, (), (FINE, "gspca_kinect was taken off")),
    "refused": Expected(1, ("access",), ("refuses the Kinect's stream", "another port")),
    "short-queue": Expected(0, (), (FINE,)),
    "lossy": Expected(0, ("pictures", "packets"), ("5.0% of", "Try another USB port", "too holey to use", "not its own"), 3.0),
    "silent": Expected(1, ("pictures", "packets"), ("sends no pictures", "12 V supply", "Not one packet came"), 3.0),
    "mute": Expected(1, ("access",), ("does not answer command", "wait five seconds"), 5.0),
    "not-ready": Expected(0, (), (FINE,)),
    "stale": Expected(0, (), (FINE,)),
    "stall": Expected(0, (), (FINE,)),
    "unplugged": Expected(0, ("pictures",), ("It left the bus 1 time", "was unplugged", "a loose plug"), 3.0),
    "replugged": Expected(0, ("pictures",), ("It left the bus 1 time", "It is back now", "a loose plug"), 5.0),
    "no-device": Expected(1, ("device",), ("I see no Kinect", "try another one, with no hub")),
    "no-power": Expected(1, ("device",), ("motor (bus 1, port 2.2) but not its camera", "12 V", "wall plug")),
    "no-power-1473": Expected(1, ("device",), ("but not its camera", "12 V", "wall plug")),
    "kinect-v2": Expected(1, ("device",), ("Kinect v2 (Xbox One), which is not supported",)),
    "azure": Expected(1, ("device",), ("Azure Kinect, which is not supported",)),
    "model-1473": Expected(0, (), (FINE, "model 1473", "tilt it by hand", "By the floor it looks level")),
    "kinect-for-windows": Expected(0, (), (FINE, "Kinect for Windows v1", "tilt it by hand")),
    "sun": Expected(0, ("sight", "floor"), ("8% of the picture", "Most likely sunlight", "draw the curtains", "nearer than 0.5 m")),
    "too-near": Expected(0, ("sight", "floor"), ("0% of the picture", "Most likely something is nearer than 0.5 m", "Or sunlight")),
    "feet-out": Expected(0, ("feet",), ("Something 1.3 m away is cut off 0.4 m above the floor", "your feet are out of view", "step back")),
    "tilted": Expected(0, ("floor",), ("20 degrees up", "No floor in view", "tilt it down until the floor is in the picture", "--tilt -5")),
}


def subjects_marked_wrong(out: str) -> tuple[str, ...]:
    return tuple(line.split()[1] for line in out.splitlines() if line.startswith(Mark.WRONG.value))


@pytest.mark.parametrize("fault", SAID)
def test_each_fault_is_said_in_plain_words_with_its_remedy(fault: str, capsys: pytest.CaptureFixture[str]) -> None:
    expected = SAID[fault]
    status = main(["kinect", "doctor", "--simulate", fault, "--seconds", str(expected.seconds)])
    out = capsys.readouterr().out
    assert out.startswith("Nothing of this is real: ")
    assert (status, subjects_marked_wrong(out)) == (expected.status, expected.wrong)
    assert [words for words in expected.words if words not in out] == []
    last = out.splitlines()[-1]
    assert last == "No depth picture arrived." if status else last.startswith("The Kinect sends depth")


def test_nothing_that_can_be_simulated_is_left_out(capsys: pytest.CaptureFixture[str]) -> None:
    assert set(SAID) == set(FAULTS) == set(MEANINGS)
    assert main(["kinect", "doctor", "--simulate", "list"]) == 0
    listed = {line.split()[0] for line in capsys.readouterr().out.splitlines()}
    assert listed == set(FAULTS)


@pytest.mark.parametrize(("fault", "status"), [("no-power", 1), ("feet-out", 0)])
def test_the_door_shows_the_messages_without_hardware(tmp_path: Path, fault: str, status: int) -> None:
    visit = knock(tmp_path, "kinect", "doctor", "--simulate", fault, "--seconds", "2")
    assert visit.status == status and visit.err == ""
    assert [words for words in SAID[fault].words if words not in visit.out] == []


def test_without_a_kinect_the_door_ends_with_1_and_soon(tmp_path: Path) -> None:
    try:
        visit = knock(tmp_path, "kinect", "doctor", "--seconds", "60")
    except subprocess.TimeoutExpired:
        pytest.fail("the doctor waits for what will not come")
    if visit.status == 0:
        pytest.skip("a real Kinect is plugged in here")
    assert visit.status == 1 and visit.out.splitlines()[-1] == "No depth picture arrived."
    assert "WRONG" in visit.out and "Traceback" not in visit.err


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("--simulate", "gremlins"), "'gremlins'"),
        (("--seconds", "0"), "between 1 and 600"),
        (("--seconds", "nan"), "between 1 and 600"),
        (("--tilt", "40"), "between -27 and 27"),
        (("--tilt", "nan"), "between -27 and 27"),
    ],
)
def test_bad_input_is_one_sentence(words: tuple[str, ...], named: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["kinect", "doctor", *words]) == BAD_INPUT
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1 and named in said.err


def test_the_motor_of_a_1414_turns_the_head_when_asked() -> None:
    clock = VirtualClock()
    simulated = simulate("none", clock)
    seen = examine(simulated.load, clock, 1.5, lambda _: HostFacts(), -5.0)
    assert simulated.kinect.motor.half_degrees == -10 and "asked for -5 degrees" in as_text(findings(seen))


def test_a_kinect_whose_motor_is_out_of_reach_says_so_when_asked(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["kinect", "doctor", "--simulate", "model-1473", "--tilt", "5", "--seconds", "2"]) == 0
    tilt = capsys.readouterr().out.split("tilt      ")[1]
    assert "behind firmware" in tilt


def test_on_a_real_clock_it_listens_in_a_thread_and_lets_go_of_everything() -> None:
    before, simulated = threading.active_count(), simulate("none")
    seen = examine(simulated.load, WallClock(), 1.5, lambda used: HostFacts(holders=(used.place if used else "",)))
    assert seen.frames > 15 and seen.first_s is not None and seen.first_s < 1.0
    assert seen.sight is not None and seen.sight.floor is not None and seen.host.holders == ("bus 1, port 2.1",)
    assert 0.0 < seen.stall_s < 1.0
    assert threading.active_count() == before
    assert in_use(simulated.host)["handles"] == in_use(simulated.host)["transfers"] == 0


def test_every_subject_and_mark_of_a_line_is_explained_in_the_docs() -> None:
    page = (ROOT / "docs" / "kinect.md").read_text(encoding="utf-8")
    subjects = {"libusb", "device", "access", "pictures", "packets", "sight", "tilt", "floor", "feet"}
    assert {finding.subject for finding in findings(examined(sight=SIGHT))} == subjects
    assert [word for word in (*subjects, *(mark.value for mark in Mark)) if f"`{word}`" not in page] == []


class Part:
    """Stands for pyusb's device of a camera, motor or audio part."""

    bus, address, port_numbers = 1, 7, (2, 1)


CAMERA = FoundKinect(Model.XBOX_1414, Part())
SIGHT = Sight(0.9, Floor(0.0, 1.0, 0.0, 1.0), "", 2.4, None)


def examined(**changed: object) -> Examination:
    """A Kinect with which all is well, but for what is changed."""
    usual = {
        "host": HostFacts(), "seconds": 5.0, "libusb": "libusb", "found": Found((CAMERA,)), "used": CAMERA, "fault": None, "sentence": "",
        "counters": Counters(packets=36_000), "frames": 145, "first_s": 0.2, "listened_s": 4.8, "queue_s": 0.112,
    }  # fmt: skip
    return Examination(**{**usual, **changed})  # type: ignore[arg-type]


def said_of(seen: Examination, subject: str) -> Finding:
    return next(finding for finding in findings(seen) if finding.subject == subject)


def test_losses_are_not_blamed_on_the_host_where_the_program_itself_stood_still() -> None:
    lossy = {"counters": Counters(packets=30_000, lost_packets=1500), "fault": Fault.LOSSY}
    assert "the losses are not its own" in as_text([said_of(examined(stall_s=0.03, **lossy), "packets")])
    own = said_of(examined(stall_s=0.4, **lossy), "packets")
    assert own.mark is Mark.WRONG and "stood still for 400 ms" in own.remedies[1] and "losses may be its own" in own.remedies[1]


def test_a_few_losses_are_worth_a_note_only() -> None:
    few = said_of(examined(counters=Counters(packets=36_000, lost_packets=100)), "packets")
    assert few.mark is Mark.NOTE and "the game copes" in few.sentence


@pytest.mark.parametrize(("height", "mark"), [(0.4, Mark.NOTE), (0.6, Mark.OK), (1.8, Mark.OK), (2.2, Mark.NOTE)])
def test_a_sensor_too_low_or_too_high_is_noted(height: float, mark: Mark) -> None:
    assert said_of(examined(sight=Sight(0.9, Floor(0.0, 1.0, 0.0, height), "", 2.0, None)), "floor").mark is mark


def test_a_sensor_that_leans_is_noted_by_accelerometer_or_floor() -> None:
    leaning = MotorState((0.17, 0.98, 0.0), 0.0, False)
    assert "leans 10 degrees to its side" in said_of(examined(level=leaning, sight=SIGHT), "tilt").sentence
    floor = Floor(0.17, 0.98, 0.0, 1.0)
    assert "By the floor" in said_of(examined(sight=Sight(0.9, floor, "", 2.4, None)), "tilt").sentence
    assert said_of(examined(sight=Sight(0.9, None, "no floor", 9.0, None)), "tilt").mark is Mark.NOTE


def test_a_picture_half_empty_is_noted() -> None:
    assert said_of(examined(sight=Sight(0.4, SIGHT.floor, "", 2.4, None)), "sight").mark is Mark.NOTE


def test_a_floor_that_begins_far_away_is_noted_and_who_is_cut_off_is_told_to_step_back() -> None:
    assert "nearer than that your feet" in said_of(examined(sight=Sight(0.9, SIGHT.floor, "", 4.0, None)), "feet").sentence
    cut = said_of(examined(sight=Sight(0.9, SIGHT.floor, "", 4.0, CutOff(1.5, 0.3))), "feet")
    assert cut.mark is Mark.WRONG and "from 4.0 m on: step back" in cut.remedies[0]


def test_who_has_the_rule_but_no_rights_is_told_of_replugging_and_of_ssh() -> None:
    seen = examined(fault=Fault.PERMISSION, sentence="You may not.", frames=0, host=HostFacts(rule=True))
    assert "over ssh" in " ".join(said_of(seen, "access").remedies)


def test_on_windows_a_missing_kinect_is_told_of_zadig() -> None:
    seen = examined(fault=Fault.NO_DEVICE, sentence="I see no Kinect.", frames=0, found=Found(), host=HostFacts("win32"))
    assert "Zadig" in " ".join(said_of(seen, "device").remedies)


def test_a_newer_kinect_or_a_second_one_beside_it_is_mentioned() -> None:
    sentence = said_of(examined(found=Found((CAMERA, CAMERA), newer=(Fault.KINECT_V2,))), "device").sentence
    assert "2 Kinects are plugged in" in sentence and "newer Kinect" in sentence
