"""Options that are whole numbers within a range."""

import argparse

from game.commands import BadInput

JOBS = 1, 256
"""How many runs at a time make sense anywhere."""


def check_whole_numbers(arguments: argparse.Namespace, **ranges: tuple[int, int]) -> None:
    """Raises BadInput for the first of the options that is not from its least to its most."""
    for option, (least, most) in ranges.items():
        value = getattr(arguments, option)
        if not least <= value <= most:
            raise BadInput(f"--{option} must be a whole number from {least} to {most}, not {value}.")
