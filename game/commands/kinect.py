"""Look after a Kinect: find out what is wrong with it, let yourself open it, record what it sees."""

import argparse
from collections.abc import Mapping
from importlib import import_module
from typing import Final

PARTS: Final[Mapping[str, tuple[str, str]]] = {
    "doctor": ("game.commands.kinect_doctor", "say in plain words what works, what does not, and what to do about it"),
    "install-rules": ("game.commands.kinect_rules", "the udev rule that lets you open a Kinect on Linux"),
    "record": ("game.commands.kinect_record", "write what the Kinect sees into a folder"),
}
"""Name to module and a line of help; imported only when this command is."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parts = parser.add_subparsers(title="parts", required=True, metavar="|".join(PARTS))
    for name, (path, line) in PARTS.items():
        module = import_module(path)
        part = parts.add_parser(name, help=line, description=module.__doc__)
        module.add_arguments(part)
        part.set_defaults(run_part=module.run)


def run(arguments: argparse.Namespace) -> int:
    return arguments.run_part(arguments)
