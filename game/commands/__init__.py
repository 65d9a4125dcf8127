"""The commands of the door: one module a command with `add_arguments` and `run`, one line here. No command means play."""

import argparse
import sys
from collections.abc import Mapping, Sequence
from importlib import import_module

COMMANDS: Mapping[str, str] = {
    "play": "game.commands.play",
    "benchmark": "game.commands.benchmark",
    "upright": "game.commands.upright",
    "pushes": "game.commands.pushes",
    "getups": "game.commands.getups",
    "search-getups": "game.commands.search_getups",
    "kinect": "game.commands.kinect",
}
"""Name to module; imported only when asked for, so that a run without a picture never imports what draws one."""

DONE, BAD_INPUT = 0, 2


class BadInput(ValueError):
    """What a user gave cannot be used; the message is one sentence that names it and what would be valid."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit status: 0 done (a fall is no error), 2 bad input."""
    words = list(sys.argv[1:] if argv is None else argv)
    name = words.pop(0) if words and words[0] in COMMANDS else "play"
    module = import_module(COMMANDS[name])
    parser = argparse.ArgumentParser(prog="topple" if name == "play" else f"topple {name}", description=module.__doc__)
    module.add_arguments(parser)
    try:
        return module.run(parser.parse_args(words))
    except BadInput as fault:
        print(f"topple: {fault}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        return 130
