"""What the computer itself can tell of a Kinect: who holds it, which driver is loaded, whether the udev rule is in place."""

import os
import shlex
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kinect.usb.udev_rule import RULE_PATH, rule_text

WEBCAM_DRIVER: Final = Path("/sys/module/gspca_kinect")
PROCESSES: Final = Path("/proc")


@dataclass(frozen=True)
class HostFacts:
    """system: as sys.platform; webcam_driver: gspca_kinect is loaded; rule: the udev rule is there; holders: who has the camera open."""

    system: str = "linux"
    webcam_driver: bool = False
    rule: bool = False
    holders: tuple[str, ...] = ()


def host_facts(bus: int | None = None, address: int | None = None) -> HostFacts:
    """The facts of this computer; of the device at this bus and address who has it open."""
    node = f"/dev/bus/usb/{bus:03d}/{address:03d}" if bus is not None and address is not None else ""
    return HostFacts(sys.platform, WEBCAM_DRIVER.exists(), rule_in_place(), holders(node) if node else ())


def rule_in_place(path: Path = RULE_PATH) -> bool:
    """Whether the file is there and says what it should."""
    try:
        return path.read_text(encoding="utf-8") == rule_text()
    except OSError:
        return False


def holders(node: str, processes: Path = PROCESSES) -> tuple[str, ...]:
    """Names of the programs that have this device file open, as far as we may see them; this one is left out."""
    names: set[str] = set()
    for process in processes.glob("[0-9]*"):
        try:
            opened = any(str(link.readlink()) == node for link in (process / "fd").iterdir())
            if opened and process.name != str(os.getpid()):
                names.add((process / "comm").read_text(encoding="utf-8", errors="replace").strip())
        except OSError:  # another user's, or it has just ended
            continue
    return tuple(sorted(names))


def door() -> str:
    """How this program was called, to be typed again from anywhere."""
    called = Path(sys.argv[0]).resolve()
    words = [sys.executable, str(called)] if called.suffix == ".py" else [str(called)]
    return " ".join(shlex.quote(word) for word in words)
