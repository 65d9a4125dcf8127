"""The one thing on Linux that installing a package cannot do: let a player open the Kinect."""

from pathlib import Path
from typing import Final

from kinect.usb.models import MICROSOFT, RULE_PRODUCTS

RULE_PATH: Final = Path("/etc/udev/rules.d/70-kinect.rules")


def rule_text() -> str:
    """The file's content: whoever sits at the computer may open any part of a Kinect v1."""
    lines = ["# Kinect v1: whoever is logged in at this computer may open its camera, motor and audio parts."]
    lines += [f'SUBSYSTEM=="usb", ATTR{{idVendor}}=="{MICROSOFT:04x}", ATTR{{idProduct}}=="{p:04x}", TAG+="uaccess"' for p in RULE_PRODUCTS]
    return "\n".join(lines) + "\n"


def install_rule(path: Path = RULE_PATH) -> str:
    """Write the rule and say what to do next. Raises PermissionError or OSError with one sentence where it cannot be written."""
    if path.is_file() and path.read_text(encoding="utf-8") == rule_text():
        return f"{path} is in place already. If the Kinect is still refused, unplug it and plug it in again."
    try:
        path.write_text(rule_text(), encoding="utf-8")
    except PermissionError:
        raise PermissionError(f"You may not write {path}: run the same command with sudo.") from None
    except OSError as error:
        raise OSError(f"{path} cannot be written ({error.strerror}): a system with udev has that folder.") from None
    return f"Wrote {path}. Now run `sudo udevadm control --reload-rules`, then unplug the Kinect and plug it in again."
