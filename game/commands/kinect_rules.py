"""Print the udev rule that lets whoever sits at a Linux computer open a Kinect, and explain it; --yes writes it."""

import argparse
import sys
from pathlib import Path

from game.commands import DONE, BadInput
from game.commands.kinect_host import door
from kinect.usb.udev_rule import RULE_PATH, install_rule, rule_text


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--yes", action="store_true", help=f"write the rule to {RULE_PATH} (needs sudo)")
    parser.add_argument("--path", type=Path, default=RULE_PATH, metavar="FILE.rules", help="where to write it instead")


def run(arguments: argparse.Namespace) -> int:
    if arguments.yes:
        if sys.platform != "linux":
            raise BadInput(f"udev rules are for Linux; on {sys.platform} none is needed, see docs/kinect.md for what is.")
        try:
            print(install_rule(arguments.path))
        except OSError as fault:  # a PermissionError is one
            raise BadInput(str(fault)) from fault
        return DONE
    print(rule_text())
    print("This is all of the rule, one line for each part of each model. USB devices belong to root on Linux; the mark `uaccess`")
    print("tells the system to lend these to whoever is logged in at this computer, and to nobody else.")
    print(f"Nothing was written. To write it to {arguments.path}:")
    print(f"    sudo {door()} kinect install-rules --yes")
    print("Then unplug the Kinect and plug it in again. To be rid of the rule, delete that file.")
    return DONE
