"""The udev rule: printed and explained unless asked to be written, and what the computer tells of who holds a Kinect."""

import sys
from pathlib import Path

import pytest

from game.commands import BAD_INPUT, main
from game.commands.kinect_host import holders, host_facts, rule_in_place
from kinect.usb.udev_rule import RULE_PATH, rule_text

LINUX = pytest.mark.skipif(sys.platform != "linux", reason="udev is Linux's")


def test_the_rule_is_printed_and_nothing_is_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "70-kinect.rules"
    assert main(["kinect", "install-rules", "--path", str(path)]) == 0
    out = capsys.readouterr().out
    assert rule_text() in out and not path.exists()
    assert "uaccess" in out and "Nothing was written" in out and "kinect install-rules --yes" in out and "plug it in again" in out


def test_where_it_goes_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    main(["kinect", "install-rules"])
    assert str(RULE_PATH) in capsys.readouterr().out


@LINUX
def test_it_is_written_when_asked_and_what_to_do_next_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "70-kinect.rules"
    assert not rule_in_place(path)
    for said in ("Wrote", "is in place already"):
        assert main(["kinect", "install-rules", "--yes", "--path", str(path)]) == 0
        out = capsys.readouterr().out
        assert said in out and "plug it in again" in out
    assert path.read_text(encoding="utf-8") == rule_text() and rule_in_place(path)


@LINUX
def test_who_may_not_write_it_is_told_of_sudo(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    def refuse(*_: object, **__: object) -> int:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "write_text", refuse)
    assert main(["kinect", "install-rules", "--yes", "--path", str(tmp_path / "a.rules")]) == BAD_INPUT
    err = capsys.readouterr().err
    assert "with sudo" in err and err.count("\n") == 1


@LINUX
def test_a_system_without_udev_is_told_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["kinect", "install-rules", "--yes", "--path", str(tmp_path / "nowhere" / "a.rules")]) == BAD_INPUT
    assert "udev" in capsys.readouterr().err


def test_elsewhere_there_is_nothing_to_write(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    assert main(["kinect", "install-rules", "--yes"]) == BAD_INPUT
    assert "for Linux" in capsys.readouterr().err


@LINUX
def test_the_programs_that_hold_a_device_are_named(tmp_path: Path) -> None:
    node = "/dev/bus/usb/001/007"
    for number, name, held in (("11", "glview", node), ("12", "editor", "/dev/null"), ("13", "broken", None)):
        folder = tmp_path / number
        (folder / "fd").mkdir(parents=True) if held else folder.mkdir()
        (folder / "comm").write_text(f"{name}\n")
        if held:
            (folder / "fd" / "3").symlink_to(held)
    assert holders(node, tmp_path) == ("glview",)


def test_the_facts_of_this_computer_can_be_asked_for() -> None:
    facts = host_facts(1, 7)
    assert facts.system == sys.platform and facts.holders == ()
