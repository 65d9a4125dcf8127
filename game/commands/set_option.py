"""The options --preset and --set NAME=VALUE, which several commands take, and the settings that they make."""

import argparse
from collections.abc import Iterable, Mapping

from game.commands import BadInput
from game.presets import PRESETS, apply_preset
from game.tunables import Settings, TunableError, Value


def add_settings_options(parser: argparse.ArgumentParser) -> None:
    """--preset and --set, as `measured_settings` reads them."""
    parser.add_argument("--preset", choices=tuple(PRESETS), help="values for the whole method; default: default")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", dest="sets", help="set one tunable; may be given again")


def measured_settings(arguments: argparse.Namespace, options: Mapping[str, Value | None]) -> Settings:
    """What a measuring command plays with; raises BadInput.

    In this order: defaults, the preset, no mirroring (as in every report), the command's own options but None, then every --set.
    """
    settings = Settings()
    try:
        if arguments.preset:
            apply_preset(settings, arguments.preset)
        settings.set("intake.mirror", False)
        for name, value in options.items():
            if value is not None:
                settings.set(name, value)
        apply_assignments(settings, arguments.sets)
    except TunableError as fault:
        raise BadInput(str(fault)) from fault
    return settings


def apply_assignments(settings: Settings, assignments: Iterable[str]) -> None:
    """Set every NAME=VALUE; raises BadInput where one has not that form, TunableError where a tunable refuses it."""
    for assignment in assignments:
        name, equals, value = assignment.partition("=")
        if not equals:
            raise BadInput(f"--set {assignment!r} must have the form NAME=VALUE, such as ik.damping=0.3.")
        settings.set(name.strip(), value.strip())
